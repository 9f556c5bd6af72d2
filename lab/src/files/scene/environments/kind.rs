//! What every kind of environment answers.

use std::fmt;

use lyapunov::{Dissipation, ParameterError, Scalar, bodies::Impedance};
use nalgebra::SVector;

use super::render::Render;
use crate::files::scene::Draft;
use crate::files::scene::check::Conflict;
use crate::files::scene::quantity::{Finite, NonNegative};

/// How a number is written.
pub(crate) type Number = fn(f64) -> String;

/// What the lab asks an environment beside its law, which is the library's.
pub(crate) trait EnvironmentKind: fmt::Debug {
    /// Mass, damping and stiffness about its surface or its rest; none where it has no stiffness there.
    fn impedance(&self) -> Option<Impedance<f64>>;

    /// What [`impedance`](Self::impedance) leaves out.
    fn impedance_note(&self) -> Option<&'static str> {
        None
    }

    /// The spring that it is to whoever is at rest, beyond its surface if it has one; none where its force is no straight
    /// line.
    fn static_spring(&self) -> Option<StaticSpring> {
        None
    }

    /// Whether its law changes with time.
    fn swings(&self) -> bool {
        false
    }

    /// Gives it another stiffness; none where that is not one number, or not one that it can have.
    fn set_stiffness(&mut self, stiffness: f64) -> Option<()> {
        let _ = stiffness;
        None
    }

    /// Whether a part of its force that depends on the motion is worked out in `f64`, whatever the scalar.
    fn is_double(&self) -> bool {
        false
    }

    /// Its vectors with their keys in its table; none in one dimension.
    fn vectors(&self) -> Vec<(&'static str, usize)> {
        Vec::new()
    }

    /// The rules between its own values.
    fn check(&self) -> Result<(), Conflict> {
        Ok(())
    }

    /// Itself in a line, without its name.
    fn words(&self, number: Number) -> String;
}

/// An environment of one dimension.
pub(super) trait OnALine: EnvironmentKind {
    /// Makes something of the library's environment.
    fn make<T: Scalar, R: Render<T>>(&self, rates: Rates, to: R)
    -> Result<R::Made, ParameterError>;
}

/// An environment of several dimensions.
pub(super) trait InSpace: EnvironmentKind {
    /// Makes something of the library's environment.
    fn make<T: Scalar, const N: usize, R: Render<SVector<T, N>>>(
        &self,
        to: R,
    ) -> Result<R::Made, ParameterError>;
}

/// The rates by which an environment and the credit of its damper tell the time, Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rates {
    pub(super) environment: f64,
    pub(super) servo: f64,
}

impl Rates {
    pub(crate) fn of(scene: &Draft) -> Self {
        // Environments tick at their own rate, what is credited at the servo's. The one is taken from the other, because a
        // scene's two rates divide each other but for a billionth, which would add up.
        let servo = scene.servo_rate.get();
        Self { environment: servo / scene.environment_ratio() as f64, servo }
    }
}

/// A spring of `stiffness` N/m that is relaxed at `position` m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StaticSpring {
    pub(crate) stiffness: f64,
    pub(crate) position: f64,
}

impl StaticSpring {
    pub(super) fn new(stiffness: impl Into<f64>, position: Finite) -> Self {
        Self { stiffness: stiffness.into(), position: position.get() }
    }
}

/// An impedance without a mass.
pub(super) fn spring_and_damper(
    stiffness: impl Into<f64>,
    damping: impl Into<f64>,
) -> Impedance<f64> {
    Impedance { mass: 0.0, damping: damping.into(), stiffness: stiffness.into() }
}

/// Stiffness and damping in words.
pub(super) fn damped(number: Number, stiffness: impl Into<f64>, damping: impl Into<f64>) -> String {
    format!("{} N/m, {} N.s/m", number(stiffness.into()), number(damping.into()))
}

/// The credit of an environment without a damper.
pub(super) fn no_credit<T: Scalar>() -> Result<Dissipation<T>, ParameterError> {
    Dissipation::of(T::zero())
}

/// Whether something with this amplitude and frequency ever moves.
pub(super) fn swings(amplitude: Finite, frequency: NonNegative) -> bool {
    amplitude.get() != 0.0 && frequency.get() != 0.0
}
