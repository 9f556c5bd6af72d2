//! The interface of every kind of environment.

use std::fmt;

use lyapunov::{
    Dissipation, ParameterError, Scalar,
    bodies::Impedance,
    environments::{Contact, Solid},
};
use nalgebra::SVector;

use super::render::Render;
use crate::files::scene::check::Conflict;
use crate::files::scene::quantity::{Finite, NonNegative};
use crate::files::scene::{Coordinates, Draft, Lanes};

/// A function that formats a number.
pub(crate) type Number = fn(f64) -> String;

/// The properties of an environment that the lab needs besides its force law, which is the library's.
pub(crate) trait EnvironmentKind: fmt::Debug {
    /// Mass, damping and stiffness about its surface or its rest; none if it has no stiffness there.
    fn impedance(&self) -> Option<Impedance<f64>>;

    /// The parts that [`impedance`](Self::impedance) leaves out, in words.
    fn impedance_note(&self) -> Option<&'static str> {
        None
    }

    /// Stiffness, damping and mass that no change of its answer exceeds; none where they have no bound.
    fn steepest(&self) -> Option<Impedance<f64>> {
        self.impedance()
    }

    /// The direction in which it pushes, if that is the same everywhere and of no axis in particular.
    fn normal(&self) -> Option<Coordinates> {
        None
    }

    /// Its flat faces; empty of a kind without a surface, or whose surface is one.
    fn faces(&self) -> Vec<Face> {
        Vec::new()
    }

    /// The spring that a device at rest feels, beyond the surface if there is one; none if the force is no straight
    /// line.
    fn static_spring(&self) -> Option<StaticSpring> {
        None
    }

    /// Frequency at which its force law changes with time, Hz, if it does.
    fn frequency(&self) -> Option<f64> {
        None
    }

    /// Whether it gives energy by its own law: a part that pushes along the motion, or a law that changes with time.
    fn is_active(&self) -> bool {
        let pushes = |it: Impedance<f64>| it.stiffness < 0.0 || it.damping < 0.0;
        self.frequency().is_some() || self.impedance().is_some_and(pushes)
    }

    /// Whether a part of its force that depends on the motion is computed in `f64`, whatever the scalar.
    fn is_double(&self) -> bool {
        false
    }

    /// The keys of its vectors in its table, with their lengths; empty in one dimension.
    fn vectors(&self) -> Vec<(&'static str, usize)> {
        Vec::new()
    }

    /// The rules between its own values.
    fn check(&self) -> Result<(), Conflict> {
        Ok(())
    }

    /// A description in one line, without its name.
    fn words(&self, number: Number) -> String {
        let damped = |it: Impedance<f64>| damped(number, it.stiffness, it.damping);
        self.impedance().map_or_else(String::new, damped)
    }
}

/// A face square to an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Face {
    /// The index of the axis.
    pub(crate) axis: usize,
    /// 1 where the solid lies below it, −1 where it lies above.
    pub(crate) outward: f64,
    /// Its place along the axis, m.
    pub(crate) position: f64,
}

/// An environment of one dimension.
pub(super) trait OnALine: EnvironmentKind {
    /// The result of `to` for the library's environment with the numbers of each lane.
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError>
    where
        Self: Sized;
}

/// An environment of several dimensions.
pub(super) trait InSpace: EnvironmentKind {
    /// The solid that the device touches.
    fn solid<T: Scalar, const N: usize>(
        &self,
    ) -> Result<impl Solid<SVector<T, N>> + Copy + 'static, ParameterError>;

    /// The result of `to` for the library's environment.
    fn make<T: Scalar, const N: usize, R: Render<SVector<T, N>>>(
        &self,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let touch = self.impedance().map_or((0.0, 0.0), |it| (it.stiffness, it.damping));
        let contact = Contact::with(self.solid::<T, N>()?, T::of(touch.0), T::of(touch.1))?;
        to.render(contact, contact.dissipation())
    }
}

/// The rates, in Hz, at which an environment and the credit of its damper advance their time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rates {
    pub(super) environment: f64,
    pub(super) servo: f64,
}

impl Rates {
    pub(crate) fn of(scene: &Draft) -> Self {
        // Environments tick at their own rate, credits at the servo rate. The former is computed from the latter,
        // because the two rates of a scene divide each other only within 1e-9, and the difference would add up.
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

/// The frequency of something with this amplitude, Hz, if it ever moves.
pub(super) fn swinging(amplitude: Finite, frequency: NonNegative) -> Option<f64> {
    Some(frequency.get()).filter(|frequency| amplitude.get() != 0.0 && *frequency != 0.0)
}
