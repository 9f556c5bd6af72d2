//! Force bound: forces no larger than the device's own damper can pay for.

use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Requirement, Scalar, Signal,
    Stabilizer,
};

use crate::{LimitCredit, StabilizerExt};

/// Force bounding: `|F(n)| ≤ √(4 b E(n) / T)`, `E(n) = E₀ + Σ (f_act(n−1) · Δx(n) + b |Δx(n)|² / T)`.
///
/// Over a period a held force `F` and a device with the damping `b` (N·s/m) change the account by at least
/// `F · Δx + b |Δx|² / T`, as `b ∫ |v|² dt ≥ b |Δx|² / T`. Over all displacements this is least at
/// `Δx = −F T / (2 b)`, where it is `−F² T / (4 b)`. A force within the bound therefore leaves the account at or above 0
/// whatever the motion, and one that is larger does not where the motion is the worst. The family is that of the
/// energy-bounding algorithm (Kim and Ryu, International Journal of Robotics Research 29(6), 2010); this derivation and
/// its tightness are checked in `tests/family`.
///
/// An effort that is too large is made smaller, all axes by one factor; nothing is added. So it needs no limit and no
/// velocity, and at rest it is as good as in motion. It needs a damping that is surely there, and a force that acts over
/// the next period: one that acts late may leave the account below 0, which is told as shortfall. The first touch after
/// little motion is soft, for the account starts at `E₀` ([`budgeted`](Self::budgeted)). What a long free motion
/// burnt allows large forces later: see [`StabilizerExt::bounded`] and [`StabilizerExt::reset_at`].
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{PortSample, Stabilizer};
/// use lyapunov_stabilizers::ForceBound;
/// let mut bound = ForceBound::new(0.1)?.budgeted(1e-3)?; // N·s/m, J
/// let correction = bound.stabilize(&PortSample::starting(1e-3, 0.0, 0.0), 5.0);
/// assert_abs_diff_eq!(correction.effort, 0.4_f64.sqrt(), epsilon = 1e-12); // √(4 · 0.1 · 1e-3 / 1e-3) N
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ForceBound<T, A = Plain<T>> {
    damping: T,
    energy: A,
}

impl<T: Scalar> ForceBound<T> {
    /// A bound for a device that surely has the viscous `damping`, N·s/m.
    ///
    /// # Errors
    /// `damping` below 0, infinite or NaN.
    pub fn new(damping: T) -> Result<Self, ParameterError> {
        let damping = Requirement::NonNegative.check("device damping", damping)?;
        Ok(Self { damping, energy: Plain::zero() })
    }
}

impl<T: Scalar, A: Accumulator<T>> ForceBound<T, A> {
    /// The same bound with its energies summed in a `B`.
    pub fn summed_in<B: Accumulator<T>>(self) -> ForceBound<T, B> {
        ForceBound { damping: self.damping, energy: B::zero() }
    }

    /// The same bound with `energy` more joules of energy.
    ///
    /// # Errors
    /// `energy` below 0, infinite or NaN.
    pub fn budgeted(mut self, energy: T) -> Result<Self, ParameterError> {
        self.energy.add(Requirement::NonNegative.check("budget", energy)?);
        Ok(self)
    }
}

impl<T, A> StabilizerExt for ForceBound<T, A> {}

impl<T: Scalar, A: Accumulator<T>> LimitCredit<T> for ForceBound<T, A> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        self.energy.lower(most);
    }
}

impl<V: Signal, A: Accumulator<V::Scalar>> Stabilizer<V> for ForceBound<V::Scalar, A> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let moved = sample.displacement.inner(sample.displacement);
        let change = sample.work.sum() + self.damping * (moved / sample.period);
        let booked = (self.energy.value() + change).finite();
        self.energy.add(V::Scalar::choose(booked, change, zero));
        let sum = self.energy.value();
        // A little less than the bound: with the rounding of what follows the account stays at or above 0.
        let share = V::Scalar::of(4.0) - V::Scalar::of(64.0) * V::Scalar::epsilon();
        let most = (share * self.damping * (sum.larger(zero) / sample.period)).sqrt();
        let size = effort.inner(effort).sqrt();
        let factor = V::Scalar::choose(size.above(most), most / size, one);
        let accepted = booked & (size + most).finite() & effort.finite();
        Correction {
            effort: V::choose(accepted, effort.scale(factor), V::zero()),
            observed_energy: sum,
            alpha: zero,
            shortfall: (-sum).larger(zero),
            accepted,
        }
    }
}
