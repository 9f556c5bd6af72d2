//! Mass, damping and stiffness.

use core::ops::Add;

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// A mechanical impedance: mass, damper and spring.
///
/// Impedances that are joined rigidly add up: an operator and a device as one mass are `operator + device`.
///
/// ```
/// use lyapunov_plants::Impedance;
/// let hand = Impedance { mass: 0.1, damping: 0.2, stiffness: 50.0 };
/// let device = Impedance { mass: 0.2, damping: 0.001, stiffness: 0.0 };
/// assert_eq!((hand + device).damping, 0.2 + 0.001); // held fast, they move as one
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impedance<T> {
    /// Mass, kg.
    pub mass: T,
    /// Damping, N·s/m.
    pub damping: T,
    /// Stiffness, N/m.
    pub stiffness: T,
}

impl<T: Scalar> Impedance<T> {
    /// `number` of each part.
    #[inline(always)]
    pub(crate) fn map<R>(self, number: impl Fn(T) -> R) -> Impedance<R> {
        Impedance {
            mass: number(self.mass),
            damping: number(self.damping),
            stiffness: number(self.stiffness),
        }
    }

    /// The same parts, of a mass that can move.
    #[inline(always)]
    pub(crate) fn checked(self) -> Result<Self, ParameterError> {
        Ok(Self {
            mass: Requirement::Positive.check("mass", self.mass)?,
            damping: Requirement::NonNegative.check("damping", self.damping)?,
            stiffness: Requirement::NonNegative.check("stiffness", self.stiffness)?,
        })
    }

    pub(crate) fn finite(self) -> Result<Self, ParameterError> {
        Requirement::Finite.check("mass", self.mass)?;
        Requirement::Finite.check("damping", self.damping)?;
        Requirement::Finite.check("stiffness", self.stiffness)?;
        Ok(self)
    }
}

impl<T: Add<Output = T>> Add for Impedance<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            damping: self.damping + other.damping,
            stiffness: self.stiffness + other.stiffness,
        }
    }
}
