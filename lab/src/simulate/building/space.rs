//! Signal at the port of a scene: one axis, or several.

use lyapunov::lanes::AutoF64x8;
use lyapunov::{
    ParameterError, Scalar, Signal,
    accumulators::{Accumulator, Compensated, DoubleDouble, Plain, Wide},
    environments::Solid,
};
use nalgebra::SVector;

use super::Fitted;
use super::plant::{self, AnyPlant};
use super::seen::Operator;
use crate::files::scene::{Basis, Coordinates, Draft, Rates, Render, Scene, Stabilizer};

/// Signal that scenes are simulated with: one axis (`f32`, `f64`, eight lanes of `f64`, a double-double), or an
/// `SVector` of two or three.
pub trait Space: Signal<Scalar: Send> + Send {
    /// The type that a ledger sums in where it is wider than the port.
    type Wide: Accumulator<Self::Scalar> + 'static;

    /// The same axes in `f64`, in which runs are measured.
    type Double: Space<Scalar = f64>;

    /// The number of axes.
    const DIMENSIONS: usize;

    /// The point, velocity or direction `coordinates`.
    fn at(coordinates: &Coordinates) -> Self;

    /// The value along axis `index`, in the first lane; NaN past the last axis.
    fn axis(self, index: usize) -> f64;

    /// The same in `f64`, in the first lane.
    fn double(self) -> Self::Double;

    /// The length, in the first lane: on a line the magnitude.
    fn length(self) -> f64 {
        (0..Self::DIMENSIONS).map(|index| self.axis(index)).fold(0.0, f64::hypot)
    }

    /// The solid whose surface the device of `scene` touches; none before an environment that is neither a wall nor a
    /// solid.
    fn solid(scene: &Draft) -> Option<Box<dyn Solid<Self>>>;

    /// Makes something `of` the environment of `scene`.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, an environment of another space, and any error of the making.
    fn render<R: Render<Self>>(scene: &Scene, of: R) -> Result<R::Made, ParameterError>;

    /// The member of the family that `table` asks for, on the loop of `scene`.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, a stabilizer of another space, and a loop without what it is set by.
    fn fitted(table: &Stabilizer, scene: &Scene) -> Result<Fitted<Self>, ParameterError>;

    /// The plant of `scene`; where a link sets the operator apart from the device, `operator` records its motion.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, alone or with others.
    fn plant(scene: &Scene, operator: &Operator<Self>) -> Result<AnyPlant<Self>, ParameterError>;
}

macro_rules! line {
    ($($scalar:ty, wide $wide:ty);* $(;)?) => {$(
        impl Space for $scalar {
            type Wide = $wide;
            type Double = f64;

            const DIMENSIONS: usize = 1;

            fn at(coordinates: &Coordinates) -> Self {
                Self::of(coordinates.get())
            }

            fn axis(self, index: usize) -> f64 {
                if index == 0 { self.lane(0) } else { f64::NAN }
            }

            fn double(self) -> f64 {
                self.lane(0)
            }

            fn solid(scene: &Draft) -> Option<Box<dyn Solid<Self>>> {
                scene.environment.solid_on_a_line()
            }

            fn render<R: Render<Self>>(scene: &Scene, of: R) -> Result<R::Made, ParameterError> {
                scene.environment.on_a_line(Rates::of(scene), of)
            }

            fn fitted(
                table: &Stabilizer,
                scene: &Scene,
            ) -> Result<Fitted<Self>, ParameterError> {
                Fitted::on_a_line(&Basis::of(scene), table)
            }

            fn plant(
                scene: &Scene,
                operator: &Operator<Self>,
            ) -> Result<AnyPlant<Self>, ParameterError> {
                plant::on_a_line(scene, operator)
            }
        }
    )*};
}

line! {
    f32, wide Wide<f32>;
    f64, wide Wide<f64>;
    // No lanes are wider; two numbers have as many digits.
    AutoF64x8, wide Compensated<AutoF64x8>;
    // For references: nothing is wider, and nothing needs to be.
    DoubleDouble, wide Plain<DoubleDouble>;
}

impl<T: Scalar + Space, const N: usize> Space for SVector<T, N> {
    type Wide = T::Wide;
    type Double = SVector<f64, N>;

    const DIMENSIONS: usize = N;

    fn at(coordinates: &Coordinates) -> Self {
        coordinates.vector()
    }

    fn axis(self, index: usize) -> f64 {
        self.get(index).map_or(f64::NAN, |axis| axis.lane(0))
    }

    fn double(self) -> SVector<f64, N> {
        SVector::from_fn(|index, _| self[index].lane(0))
    }

    fn solid(scene: &Draft) -> Option<Box<dyn Solid<Self>>> {
        scene.environment.solid_in_space()
    }

    fn render<R: Render<Self>>(scene: &Scene, of: R) -> Result<R::Made, ParameterError> {
        scene.environment.in_space(of)
    }

    fn fitted(table: &Stabilizer, scene: &Scene) -> Result<Fitted<Self>, ParameterError> {
        Fitted::in_space(&Basis::of(scene), table)
    }

    fn plant(scene: &Scene, operator: &Operator<Self>) -> Result<AnyPlant<Self>, ParameterError> {
        plant::in_space(scene, operator)
    }
}

/// Evaluates an expression with the type `$signal` set to the signal at the port of a scene.
#[macro_export]
macro_rules! in_space {
    ($scene:expr, $signal:ident => $expression:expr) => {{
        use $crate::SVector;
        use $crate::scene::Scalar;
        match ($scene.scalar, $scene.dimensions()) {
            (Scalar::F64, 3) => {
                type $signal = SVector<f64, 3>;
                $expression
            }
            (Scalar::F64, 2) => {
                type $signal = SVector<f64, 2>;
                $expression
            }
            (Scalar::F64, _) => {
                type $signal = f64;
                $expression
            }
            (Scalar::F32, 3) => {
                type $signal = SVector<f32, 3>;
                $expression
            }
            (Scalar::F32, 2) => {
                type $signal = SVector<f32, 2>;
                $expression
            }
            (Scalar::F32, _) => {
                type $signal = f32;
                $expression
            }
        }
    }};
}

pub(crate) use in_space;
