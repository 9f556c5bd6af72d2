//! Signal at the port of a scene: one axis, or several.

use lyapunov::{
    ParameterError, Scalar, Signal,
    accumulators::{Accumulator, Compensated, DoubleDouble, Plain, Wide},
    environments::Solid,
};
use nalgebra::SVector;
use pulp::NullaryFnOnce;

use super::plant::{self, AnyPlant};
use super::seen::Operator;
use super::{Fitted, Port, Scenes, Seen, assembly};
use crate::files::scene::{Coordinates, Draft, Environment, Rates, Render, Scene, Stabilizer};
use crate::simulate::aligned::F64x8;
use crate::simulate::instructions::Instructions;

/// Signal that scenes are simulated with: one axis (`f32`, `f64`, eight lanes of `f64`, a double-double), or an
/// `SVector` of two or three.
pub trait Space: Signal<Scalar: Send> + Send {
    /// The type that a ledger sums in where it is wider than the port.
    type Wide: Accumulator<Self::Scalar> + 'static;

    /// The same axes in `f64`, in which runs are measured.
    type Double: Space<Scalar = f64>;

    /// The number of axes.
    const DIMENSIONS: usize;

    /// A point, velocity or direction of each scene.
    fn at(scenes: Scenes<'_>, coordinates: impl Fn(&Scene) -> &Coordinates) -> Self;

    /// The value along axis `index`, in the first lane; NaN past the last axis.
    fn axis(self, index: usize) -> f64;

    /// The values along all axes, in the first lane, and 0 in place of axes that it does not have.
    #[inline]
    fn axes(self) -> [f64; 3] {
        let mut axes = [0.0; 3];
        for (index, axis) in axes.iter_mut().enumerate().take(Self::DIMENSIONS) {
            *axis = self.axis(index);
        }
        axes
    }

    /// The signal in `f64`, in the first lane.
    fn double(self) -> Self::Double;

    /// The length, in the first lane: on a line the magnitude.
    #[inline]
    fn length(self) -> f64 {
        (0..Self::DIMENSIONS).map(|index| self.axis(index)).fold(0.0, f64::hypot)
    }

    /// The solid whose surface the device of `scene` touches; none before an environment that is neither a wall nor a
    /// solid.
    fn solid(scene: &Draft) -> Option<Box<dyn Solid<Self>>>;

    /// Makes something `of` the environment of the scenes.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, an environment of another space, and any error of the making.
    fn render<R: Render<Self>>(scenes: Scenes<'_>, of: R) -> Result<R::Made, ParameterError>;

    /// The stabilizer that the tables, one for each scene and alike in all but numbers, ask for; none without tables.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, a stabilizer of another space, and a loop without what it is set by.
    fn fitted(
        tables: Option<&[Stabilizer]>,
        scenes: Scenes<'_>,
    ) -> Result<Fitted<Self>, ParameterError>;

    /// The port of the scenes that answers the motion, stabilizer and effects included; `seen` records what they do.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, alone or with others.
    fn port(
        scenes: Scenes<'_>,
        fitted: Fitted<Self>,
        seen: Option<&Seen<Self>>,
    ) -> Result<Port<Self>, ParameterError>;

    /// The plant of the scenes; where a link sets the operator apart from the device, `operator` records its motion.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar, alone or with others.
    fn plant(
        scenes: Scenes<'_>,
        operator: &Operator<Self>,
    ) -> Result<AnyPlant<Self>, ParameterError>;

    /// Runs a part's share of a tick, lanes on `instructions`.
    fn run<J: NullaryFnOnce>(instructions: Instructions, job: J) -> J::Output;
}

/// The ways from scenes to the parts of a loop. Each is compiled here for the one signal; generic over signals, it would
/// be compiled again, with all parts that a loop can have, in every crate that names it.
macro_rules! built {
    ($fitted:path, $plant:path) => {
        fn fitted(
            tables: Option<&[Stabilizer]>,
            scenes: Scenes<'_>,
        ) -> Result<Fitted<Self>, ParameterError> {
            Fitted::asked(tables, scenes, $fitted)
        }

        fn port(
            scenes: Scenes<'_>,
            fitted: Fitted<Self>,
            seen: Option<&Seen<Self>>,
        ) -> Result<Port<Self>, ParameterError> {
            assembly::answering(scenes, seen, fitted)
        }

        fn plant(
            scenes: Scenes<'_>,
            operator: &Operator<Self>,
        ) -> Result<AnyPlant<Self>, ParameterError> {
            $plant(scenes, operator)
        }
    };
}

macro_rules! line {
    ($($scalar:ty, wide $wide:ty, by $run:path);* $(;)?) => {$(
        impl Space for $scalar {
            type Wide = $wide;
            type Double = f64;

            const DIMENSIONS: usize = 1;

            fn at(scenes: Scenes<'_>, coordinates: impl Fn(&Scene) -> &Coordinates) -> Self {
                scenes.each(|it| coordinates(it).get())
            }

            #[inline]
            fn axis(self, index: usize) -> f64 {
                if index == 0 { self.lane(0) } else { f64::NAN }
            }

            #[inline]
            fn double(self) -> f64 {
                self.lane(0)
            }

            fn solid(scene: &Draft) -> Option<Box<dyn Solid<Self>>> {
                scene.environment.solid_on_a_line()
            }

            fn render<R: Render<Self>>(
                scenes: Scenes<'_>,
                of: R,
            ) -> Result<R::Made, ParameterError> {
                let environments: Vec<_> =
                    scenes.values().iter().map(|it| &it.environment).collect();
                Environment::on_a_line(&environments, Rates::of(scenes.common()), of)
            }

            built!(Fitted::on_a_line, plant::on_a_line);

            #[inline(always)]
            fn run<J: NullaryFnOnce>(instructions: Instructions, job: J) -> J::Output {
                $run(instructions, job)
            }
        }
    )*};
}

line! {
    f32, wide Wide<f32>, by at_once;
    f64, wide Wide<f64>, by at_once;
    // There is no wider type of lanes; a compensated sum has as many digits.
    F64x8, wide Compensated<F64x8>, by Instructions::run;
    // For references: nothing is wider, and nothing needs to be.
    DoubleDouble, wide Plain<DoubleDouble>, by at_once;
}

/// Runs the job of one scalar, which gains nothing from vectors.
#[inline(always)]
fn at_once<J: NullaryFnOnce>(_instructions: Instructions, job: J) -> J::Output {
    job.call()
}

macro_rules! space {
    ($($scalar:ty, $axes:literal);* $(;)?) => {$(
        impl Space for SVector<$scalar, $axes> {
            type Wide = <$scalar as Space>::Wide;
            type Double = SVector<f64, $axes>;

            const DIMENSIONS: usize = $axes;

            fn at(scenes: Scenes<'_>, coordinates: impl Fn(&Scene) -> &Coordinates) -> Self {
                coordinates(scenes.common()).vector()
            }

            #[inline]
            fn axis(self, index: usize) -> f64 {
                self.get(index).map_or(f64::NAN, |axis| axis.lane(0))
            }

            #[inline]
            fn double(self) -> Self::Double {
                SVector::from_fn(|index, _| self[index].lane(0))
            }

            fn solid(scene: &Draft) -> Option<Box<dyn Solid<Self>>> {
                scene.environment.solid_in_space()
            }

            fn render<R: Render<Self>>(
                scenes: Scenes<'_>,
                of: R,
            ) -> Result<R::Made, ParameterError> {
                scenes.common().environment.in_space(of)
            }

            built!(Fitted::in_space, plant::in_space);

            #[inline(always)]
            fn run<J: NullaryFnOnce>(instructions: Instructions, job: J) -> J::Output {
                at_once(instructions, job)
            }
        }
    )*};
}

space! {
    f32, 2;
    f32, 3;
    f64, 2;
    f64, 3;
}

/// Evaluates an expression with the type `$signal` set to the signal at the port of a scene.
#[cfg(feature = "every-scalar")]
#[macro_export]
macro_rules! in_space {
    ($scene:expr, $signal:ident => $expression:expr) => {
        match $scene.scalar {
            $crate::scene::Scalar::F64 => $crate::in_space_of!(f64, $scene, $signal => $expression),
            $crate::scene::Scalar::F32 => $crate::in_space_of!(f32, $scene, $signal => $expression),
        }
    };
}

/// The same of a program without loops in `f32`: [`Draft::check`] refuses such scenes.
#[cfg(not(feature = "every-scalar"))]
#[macro_export]
macro_rules! in_space {
    ($scene:expr, $signal:ident => $expression:expr) => {
        $crate::in_space_of!(f64, $scene, $signal => $expression)
    };
}

/// The same in `$scalar`, whatever the scalar of the scene is.
#[macro_export]
macro_rules! in_space_of {
    ($scalar:ty, $scene:expr, $signal:ident => $expression:expr) => {
        match $scene.dimensions() {
            3 => {
                type $signal = $crate::SVector<$scalar, 3>;
                $expression
            }
            2 => {
                type $signal = $crate::SVector<$scalar, 2>;
                $expression
            }
            _ => {
                type $signal = $scalar;
                $expression
            }
        }
    };
}

pub(crate) use in_space;
