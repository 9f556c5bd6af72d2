//! Damping limit: the largest damping that a stabilizer may inject.

use core::f64::consts::FRAC_PI_4;

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// Largest damping that a stabilizer may inject, N·s/m.
///
/// A held damper `α` on a mass `m` multiplies the velocity by about `1 − α T / m` on each tick: it removes at
/// most `m v² / 2`, at `α = m / T`, and adds energy above `2 m / T`. Hence the limit is a share of `m / T`:
/// 0.5 by default in the scenes, `cap tan(π / (4 (d + 1))) m / T` where the force acts `d` ticks late
/// ([`delayed`](Self::delayed)), 0 for a pure observer.
///
/// ```
/// use lyapunov_stabilizers::DampingLimit;
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?; // half of m / T, the least mass that moves
/// assert_eq!(limit.most(), 100.0); // N·s/m
/// assert!(limit.delayed(2).most() < 100.0); // forces that act two ticks late
/// assert!(DampingLimit::of_mass(0.5, 0.2, 0.0).is_err());
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampingLimit<T> {
    most: T,
}

impl<T: Scalar> DampingLimit<T> {
    /// The limit `cap · mass / period`, with `mass` the smallest mass that moves with the port (kg) and `period` the
    /// time between two ticks (s). A cap of 0 makes a pure observer, an infinite one sets no limit.
    ///
    /// # Errors
    /// `damping_cap` below 0 or NaN; `mass` or `period` not above 0 and finite.
    pub fn of_mass(damping_cap: T, mass: T, period: T) -> Result<Self, ParameterError> {
        let cap = Requirement::Limit.check("damping cap", damping_cap)?;
        let mass = Requirement::Positive.check("mass", mass)?;
        let period = Requirement::Positive.check("period", period)?;
        Ok(Self::finite(cap * mass / period))
    }

    /// The limit of a mobility, `mobility_cap / (stiffness · period)` in m/(N·s), for admittance causality
    /// ([`AdmittanceSample`](lyapunov_core::AdmittanceSample)): `stiffness` is the largest stiffness that holds the
    /// device, N/m.
    ///
    /// A held velocity `β f` against a spring `k` multiplies its force by `1 − β k T` on each tick, as a held damper
    /// multiplies the velocity of a mass: `1 / k` takes the place of `m`.
    ///
    /// # Errors
    /// `mobility_cap` below 0 or NaN; `stiffness` or `period` not above 0 and finite.
    pub fn of_stiffness(mobility_cap: T, stiffness: T, period: T) -> Result<Self, ParameterError> {
        let cap = Requirement::Limit.check("mobility cap", mobility_cap)?;
        let stiffness = Requirement::Positive.check("stiffness", stiffness)?;
        let period = Requirement::Positive.check("period", period)?;
        let product = stiffness * period;
        // A product of 0 would turn a cap of 0 into no limit, an infinite one a limit into 0.
        let fits = !product.below(T::smallest_normal()) & product.finite();
        Ok(Self::finite(T::choose(fits, cap / product, cap / stiffness / period)))
    }

    /// The limit `damping`, N·s/m.
    ///
    /// # Errors
    /// `damping` below 0 or NaN.
    pub fn at(damping: T) -> Result<Self, ParameterError> {
        Ok(Self::finite(Requirement::Limit.check("damping limit", damping)?))
    }

    /// The limit for a force that acts `ticks` periods late: the same share of the largest damper under which a mass
    /// stays stable.
    ///
    /// A held damper that reads the backward difference and acts `d` ticks late leads to
    /// `v(n+1) = v(n) − a (v(n−d) + v(n−d−1)) / 2` with `a = α T / m`, `v` the velocity at the instants. Its
    /// oscillation grows from `a = 2 tan(π / (4 (d+1)))` on, where `z − 1 = −(a/2) z^(−d−1) (z + 1)` has a root on the
    /// unit circle: 2, 0.828, 0.536, 0.398 for 0 to 3 ticks. (With the velocity itself, from `2 sin(π / (2 (2d+1)))`
    /// on: 2, 1, 0.618; the backward difference is half a tick late by itself, so its limit serves both.) Hence the
    /// factor `tan(π / (4 (d+1)))`: half of `m / T` is a quarter of the damping that makes the oscillation grow, and
    /// with the factor it is again a quarter.
    ///
    /// It promises only that the damper's own oscillation does not grow: a wall that is as late as the damper gives out
    /// more energy the later it is, and the smaller damper dissipates less.
    ///
    /// ```
    /// use approx::assert_abs_diff_eq;
    /// use lyapunov_stabilizers::DampingLimit;
    /// let prompt = DampingLimit::of_mass(0.5, 0.2, 1e-3_f64)?; // 100 N·s/m
    /// assert_eq!(prompt.delayed(0), prompt);
    /// assert_abs_diff_eq!(prompt.delayed(1).most(), 41.42, epsilon = 0.01);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    #[must_use]
    pub fn delayed(self, ticks: u32) -> Self {
        match ticks {
            0 => self,
            ticks => {
                let share = libm::tan(FRAC_PI_4 / (f64::from(ticks) + 1.0));
                Self { most: self.most * T::of(share) }
            }
        }
    }

    /// The largest damping, N·s/m: always finite.
    #[inline(always)]
    pub fn most(self) -> T {
        self.most
    }

    pub(crate) fn finite(most: T) -> Self {
        Self { most: most.smaller(T::largest()) }
    }
}

#[cfg(feature = "approx")]
lyapunov_core::approximate!(impl[T: PartialEq] DampingLimit<T>, of T { most });
