//! Laws of a Lyapunov function: kept by those that ship, and broken by wrong ones.

use lyapunov::lanes::{AutoF32x8, WideF64x4};
use lyapunov::laws::{self, Law};
use lyapunov::{
    Scalar,
    models::{ArmEnergy, LegEnergy, LyapunovFunction, MotorEnergy, QuadraticForm, UprightEnergy},
};
use nalgebra::{SVector, Vector2};

use crate::{Draw, arm, device, leg, motor, pendulum};

fn states<T: Scalar, const N: usize>(size: f64) -> impl Iterator<Item = SVector<T, N>> {
    let mut draw = Draw(9);
    (0..500).map(move |_| draw.vector(size))
}

fn those_that_ship_keep_the_laws<T: Scalar>() {
    let of = T::of;
    let upright = UprightEnergy::new(pendulum::<T>(), of(6.0)).expect("an energy");
    laws::lyapunov_function(&upright, states(1.0)).expect("the pendulum's");
    laws::lyapunov_function(&upright, states(0.1)).expect("the pendulum's, near rest");
    let current = MotorEnergy::new(motor::<T>(), of(0.05), of(0.004)).expect("a function");
    laws::lyapunov_function(&current, states(2.0)).expect("the motor's");
    let springs = ArmEnergy::new(arm::<T>(), [of(40.0), of(10.0)]).expect("an energy");
    laws::lyapunov_function(&springs, states(1.0)).expect("the arm's");
    let standing = LegEnergy::new(leg::<T>(), [of(150.0), of(80.0)]).expect("an energy");
    laws::lyapunov_function(&standing, states(0.5)).expect("the leg's");
    let rendered = device::<T>().energy(of(0.2)).expect("an energy");
    laws::lyapunov_function(&rendered, states(0.1)).expect("the device's");
    let rows =
        [[2.0, -0.5, 0.1], [-0.5, 1.0, 0.2], [0.1, 0.2, 0.7]].map(|row| SVector::from(row.map(of)));
    let form = QuadraticForm::new(rows).expect("a form");
    laws::lyapunov_function(&form, states(3.0)).expect("a quadratic form");
}

#[test]
fn the_functions_that_ship_keep_the_laws() {
    those_that_ship_keep_the_laws::<f64>();
    those_that_ship_keep_the_laws::<f32>();
    those_that_ship_keep_the_laws::<WideF64x4>();
    those_that_ship_keep_the_laws::<AutoF32x8>();
}

/// Functions that break one law each, and one that breaks none.
#[derive(Clone, Copy, Debug)]
enum Wrong {
    Nothing,
    /// Its value at rest is not 0.
    Offset,
    /// Negative along one direction.
    Saddle,
    /// Zero along one direction.
    Flat,
    /// A wrong sign in the gradient.
    Sign,
    /// A term missing in the gradient.
    Cross,
    /// The gradient five per cent too large.
    Factor,
    /// Not finite far out.
    Overflow,
    /// A false slope at rest in the gradient.
    Tilted,
}

impl<T: Scalar> LyapunovFunction<SVector<T, 2>> for Wrong {
    fn value(&self, state: SVector<T, 2>) -> T {
        let [x, y] = state.data.0[0];
        let of = T::of;
        let bowl = of(2.0) * x * x + x * y + of(0.5) * y * y + x * x * x * x;
        match self {
            Self::Offset => bowl + of(1e-3),
            Self::Saddle => x * x - of(0.1) * y * y,
            Self::Flat => x * x,
            Self::Overflow => bowl / T::choose(x.above(of(0.9)), of(0.0), of(1.0)),
            _ => bowl,
        }
    }

    fn gradient(&self, state: SVector<T, 2>) -> SVector<T, 2> {
        let [x, y] = state.data.0[0];
        let of = T::of;
        let cubic = of(4.0) * x * x * x;
        let right = SVector::from([of(4.0) * x + y + cubic, x + y]);
        match self {
            Self::Saddle => SVector::from([of(2.0) * x, of(-0.2) * y]),
            Self::Flat => SVector::from([of(2.0) * x, of(0.0)]),
            Self::Sign => SVector::from([right[0], of(0.0) - right[1]]),
            Self::Cross => SVector::from([of(4.0) * x + cubic, right[1]]),
            Self::Factor => right * of(1.05),
            Self::Tilted => right + SVector::from([of(0.02), of(0.0)]),
            _ => right,
        }
    }
}

fn told<T: Scalar>(wrong: Wrong) -> Option<Law> {
    let states = states::<T, 2>(1.0);
    laws::lyapunov_function(&wrong, states).err().map(|violation| violation.law)
}

fn each_is_told<T: Scalar>() {
    assert_eq!(told::<T>(Wrong::Nothing), None);
    assert_eq!(told::<T>(Wrong::Offset), Some(Law::ZeroAtRest));
    assert_eq!(told::<T>(Wrong::Saddle), Some(Law::Positive));
    assert_eq!(told::<T>(Wrong::Sign), Some(Law::Slope));
    assert_eq!(told::<T>(Wrong::Cross), Some(Law::Slope));
    assert_eq!(told::<T>(Wrong::Factor), Some(Law::Slope));
    assert_eq!(told::<T>(Wrong::Tilted), Some(Law::Slope));
    assert_eq!(told::<T>(Wrong::Overflow), Some(Law::Finite));
}

#[test]
fn each_wrong_function_breaks_its_law() {
    each_is_told::<f64>();
    each_is_told::<f32>();
    each_is_told::<WideF64x4>();
    // Flat along an axis: noticed only at a state on that axis.
    assert_eq!(told::<f64>(Wrong::Flat), None);
    let along = laws::lyapunov_function(&Wrong::Flat, [Vector2::new(0.0, 0.5)]);
    assert_eq!(along.expect_err("V = 0").law, Law::Positive);
}
