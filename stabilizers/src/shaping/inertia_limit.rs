//! Inertia limit: corrections within what the mechanism in its present posture can use.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Scalar, Signal, Snapshot, Stabilizer, largest_axis,
};

use super::{added, portion};
use crate::account::lends;
use crate::{DampingLimit, Inertia};

/// Stabilizer whose correction is limited by the inertia that it meets: by the apparent mass along the direction of
/// motion, at every tick.
///
/// A correction `c` that is held for a tick changes the kinetic energy by `−c·v T + ½ (c·Λ⁻¹ c) T²`. It removes most at
/// `c·v / (T c·Λ⁻¹ c)` times itself, and adds energy beyond twice that, so the share that is let through is
///
/// ```text
/// s = min(1, cap · c·v / (T c·Λ⁻¹ c))     Λ⁻¹ = J M⁻¹ Jᵀ
/// c = α v:   s α ≤ cap · m / T,           m = 1 / (u·Λ⁻¹ u),  u = v / |v|
/// ```
///
/// On one axis that is [`DampingLimit::of_mass`]. In every posture and direction it is the same share of what helps,
/// where one number for all postures has to be the least of them. It holds for any correction, also one that weighs
/// translation and rotation apart, and no number of it mixes their units. The stabilizer inside needs no limit of its
/// own.
///
/// The inertia is that of the last posture told: [`tell`](Self::tell) it before each step. As all shaping this goes
/// with held work.
///
/// ```
/// use lyapunov_core::{PortEnergy, HeldTick, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, InertiaLimit, JointInertia, Popc};
/// use nalgebra::{Matrix2, Vector2};
/// let posture = |elbow: f64| JointInertia::new(Matrix2::new(0.5 + elbow, 0.1, 0.1, 0.1));
/// let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY)?);
/// let mut popc = InertiaLimit::new(unlimited, posture(0.0)?, 0.5, 1e-3)?;
/// let rates = Vector2::new(1.0, 0.0);
/// let (displacement, applied) = (rates * 1e-3, Vector2::new(-900.0, 0.0)); // a debt of 0.9 J
/// let given = HeldTick { period: 1e-3, position: rates, velocity: rates, displacement, applied }.sample();
/// assert!((popc.stabilize(&given, Vector2::zeros()).alpha - 0.5 * 0.4 / 1e-3).abs() < 1e-9);
/// popc.tell(posture(0.3)?); // stretched
/// assert!((popc.stabilize(&given, Vector2::zeros()).alpha - 0.5 * 0.7 / 1e-3).abs() < 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
///
/// (0.4 kg·m² is what the first joint feels while the second one may yield: `0.5 − 0.1² / 0.1`.)
#[derive(Clone, Copy, Debug)]
pub struct InertiaLimit<S, M, T> {
    stabilizer: S,
    inertia: M,
    /// `damping_cap / T`, 1/s.
    rate: DampingLimit<T>,
}

impl<S, M, T: Scalar> InertiaLimit<S, M, T> {
    /// `stabilizer` with at most the share `damping_cap` of the damping that removes most in one tick of `period` s, for a
    /// mechanism of this `inertia`.
    ///
    /// # Errors
    /// `damping_cap` below 0 or NaN; `period` not above 0 and finite.
    pub fn new(
        stabilizer: S,
        inertia: M,
        damping_cap: T,
        period: T,
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            stabilizer,
            inertia,
            rate: DampingLimit::of_mass(damping_cap, T::of(1.0), period)?,
        })
    }

    /// The limit for an effort that acts `ticks` periods late ([`DampingLimit::delayed`]).
    #[must_use]
    pub fn delayed(self, ticks: u32) -> Self {
        Self { rate: self.rate.delayed(ticks), ..self }
    }

    /// Takes the inertia of the present posture.
    #[inline]
    pub fn tell(&mut self, inertia: M) {
        self.inertia = inertia;
    }
}

lends!(impl[S, M, T: Scalar] InertiaLimit<S, M, T>, of S, in T);

impl<S, M, T: Scalar> InertiaLimit<S, M, T> {
    /// The inertia that was told last.
    pub fn inertia(&self) -> &M {
        &self.inertia
    }

    /// The limit for a mass of one: times the apparent inertia along the motion it is that of this tick.
    pub fn rate(&self) -> DampingLimit<T> {
        self.rate
    }

    /// Changes that limit between ticks, with its delay: `DampingLimit::of_mass(cap, 1.0, period)?.delayed(ticks)`.
    pub fn set_rate(&mut self, rate: DampingLimit<T>) {
        self.rate = rate;
    }
}

// The inertia is told again on every tick.
lyapunov_core::snapshot! {
    impl[S: Snapshot, M, T: Scalar] InertiaLimit<S, M, T>, is stabilizer, of S::State
}

impl<V, S, M> Stabilizer<V> for InertiaLimit<S, M, V::Scalar>
where
    V: Signal,
    S: Stabilizer<V>,
    M: Inertia<V>,
{
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let correction = self.stabilizer.stabilize(sample, effort);
        let added = added(&correction, effort);
        // In units of the largest axis, so that a large correction can be squared.
        let largest = largest_axis(added);
        let unit = V::Scalar::choose(largest.above(zero), largest, one);
        let direction = added.map(|axis| axis / unit);
        let power = direction.inner(V::choose(correction.accepted, sample.velocity, V::zero()));
        let yields = self.inertia.inverse_square(direction) * unit;
        let most = self.rate.most() * power / yields;
        // What does not brake is no damping, and what does not yield is not moved by it.
        let braking = power.above(zero) & yields.above(zero);
        let whole = V::Scalar::choose(most.above(zero), one, zero);
        let share = V::Scalar::choose(most.below(one), most, whole);
        portion(correction, sample, effort, V::Scalar::choose(braking, share, one))
    }
}
