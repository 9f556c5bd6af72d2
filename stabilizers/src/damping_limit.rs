//! How much damping a stabilizer may inject.

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// The most damping a stabilizer may inject, N·s/m.
///
/// A held damper `α` on a mass `m` multiplies the velocity by about `1 − α T / m` on each tick: it removes at
/// most `m v² / 2`, at `α = m / T`, and adds energy above `2 m / T`. Hence the limit is a share of `m / T`:
/// 0.5 by default in the scenes, less where the force is delayed, 0 for a pure observer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampingLimit<T> {
    most: T,
}

impl<T: Scalar> DampingLimit<T> {
    /// The limit `cap · mass / period`, with `mass` the least that moves with the port (kg) and `period` the
    /// time between two ticks (s). A cap of 0 makes a pure observer, an infinite one sets no limit.
    ///
    /// # Errors
    /// `damping_cap` below 0 or NaN; `mass` or `period` not above 0 and finite.
    pub fn of_mass(damping_cap: T, mass: T, period: T) -> Result<Self, ParameterError> {
        let cap = Requirement::Limit.check("damping_cap", damping_cap)?;
        let mass = Requirement::Positive.check("mass", mass)?;
        let period = Requirement::Positive.check("period", period)?;
        Ok(Self::finite(cap * mass / period))
    }

    /// The limit `damping`, N·s/m.
    ///
    /// # Errors
    /// `damping` below 0 or NaN.
    pub fn at(damping: T) -> Result<Self, ParameterError> {
        Ok(Self::finite(Requirement::Limit.check("damping_limit", damping)?))
    }

    /// The most damping, N·s/m: always finite.
    #[inline(always)]
    pub fn most(self) -> T {
        self.most
    }

    fn finite(most: T) -> Self {
        Self { most: most.smaller(T::largest()) }
    }
}
