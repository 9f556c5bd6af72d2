//! Least-norm filter: the least change that keeps a scalar constraint.

mod constraint;

pub use constraint::{Constraint, Input};

use lyapunov_core::{
    Accumulator, Correction, Held, Ledger, LyapunovCandidate, Observer, ParameterError, Plain,
    PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::account::{account, booked};
use crate::credit::limits_credit;
use crate::{DampingLimit, StabilizerExt};

/// A safety filter on an energy: the least correction that keeps the next observed energy above a share of this one,
/// which is what a quadratic program over a control Lyapunov or barrier function gives with one constraint.
///
/// ```text
/// L(n) + F · v T ≥ (1 − γ) L(n),   0 < γ ≤ 1   ⇒   F = f + α v,   α = min(−min(0, γ L + f · v T) / (v² T), limit)
/// ```
///
/// `L` in J is the observed energy of the candidate, [`PortEnergy`](lyapunov_core::PortEnergy) or more; the correction
/// is the [least norm](Constraint::least_norm) for the drift `−(γ L + f · v T)` and the gain `−v T`. `γ = 1` spends all
/// in one tick, a smaller one slows the decrease. [`Popc`](crate::Popc) is this without the look ahead: it waits until
/// `L < 0`, this one also gives less than is asked on the way out.
///
/// **Guarantee** (textbook, derived here): `L(n+1) ≥ (1 − γ) L(n)`, so `L ≥ 0` from `L(0) ≥ 0` on. **Assumed** are a
/// next displacement `v T`, a prompt force and a limit that does not bite; else `L` is off by `|F| |Δx − v T|`. At
/// `v = 0` nothing can be done. Where the constraint cannot be met, or a debt not be served, the larger of the two is
/// reported as shortfall.
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, LeastNorm};
/// let mut filter = LeastNorm::new(PortEnergy, DampingLimit::at(100.0)?, 1.0)?;
/// // takes 0.1 mJ
/// filter.stabilize(&HeldTick {
///     period: 1e-3, position: 2e-4, velocity: 0.2, displacement: 2e-4, applied: 0.5
/// }.sample(), 4.0);
/// // is about to give 0.4 mJ
/// let back = HeldTick { period: 1e-3, position: 2e-4, velocity: -0.1, displacement: 0.0, applied: 4.0 }.sample();
/// let correction = filter.stabilize(&back, 4.0_f64);
/// let effort: f64 = correction.effort;
/// assert!((effort - 1.0).abs() < 1e-12 && correction.shortfall < 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LeastNorm<T, C, A = Plain<T>> {
    observer: Observer<C, Held, A>,
    limit: DampingLimit<T>,
    decay: T,
}

impl<T: Scalar, C> LeastNorm<T, C> {
    /// A filter that lets the observed energy of `candidate` fall by at most the share `decay` γ a tick, by at most
    /// `limit`.
    ///
    /// # Errors
    /// `decay` not above 0, or above 1.
    pub fn new(candidate: C, limit: DampingLimit<T>, decay: T) -> Result<Self, ParameterError> {
        Ok(Self { observer: Observer::of(candidate), limit, decay: checked(decay)? })
    }
}

impl<T: Scalar, C, A: Accumulator<T>> LeastNorm<T, C, A> {
    /// The same filter with its energies summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> LeastNorm<T, C, B> {
        let Self { observer, limit, decay } = self;
        LeastNorm { observer: observer.summed_in(), limit, decay }
    }

    /// The same filter with `energy` more joules on its account.
    ///
    /// # Errors
    /// `energy` below 0, infinite or NaN, or more than the sum has room for.
    pub fn budgeted(mut self, energy: T) -> Result<Self, ParameterError> {
        self.observer.ledger = booked("budget", energy, self.observer.ledger, Ledger::credit)?;
        Ok(self)
    }
}

impl<T, C, A> StabilizerExt for LeastNorm<T, C, A> {}

limits_credit!(impl[T: Scalar, C, A: Accumulator<T>] LeastNorm<T, C, A>, in T, of observer.ledger);

impl<V, C, A> Stabilizer<V> for LeastNorm<V::Scalar, C, A>
where
    V: Signal,
    C: LyapunovCandidate<V>,
    A: Accumulator<V::Scalar>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let zero = V::Scalar::of(0.0);
        let decrease = self.observer.decrease(sample, effort);
        let booked = self.observer.ledger.credit(decrease);
        let sum = self.observer.ledger.energy();
        let square = sample.velocity.inner(sample.velocity) * sample.period;
        let slack = self.decay * sum + effort.inner(sample.velocity) * sample.period;
        let timed = sample.period.above(zero);
        let sound = (slack + square + sample.work.sum()).finite() & effort.finite();
        let accepted = booked & sound & timed;
        // The divisor stays normal, and the margin rounds up, so that what is served is served in full.
        let margin = V::Scalar::of(1.0) - V::Scalar::of(4.0) * V::Scalar::epsilon();
        let lacking = (-slack).larger(zero);
        let needed = lacking / (square * margin).larger(V::Scalar::smallest_normal());
        let able = accepted & square.above(V::Scalar::smallest_normal());
        let alpha = V::Scalar::choose(able, needed.smaller(self.limit.most()), zero);
        let served = V::Scalar::choose(able, alpha * square, zero);
        let least = V::Scalar::choose(accepted, slack.smaller(sum), sum);
        let corrected = effort + sample.velocity.scale(alpha);
        Correction {
            effort: V::choose(accepted, corrected, V::zero()),
            observed_energy: sum,
            alpha,
            shortfall: (-(least + served)).larger(zero),
            accepted,
        }
        .checked()
    }
}

account!(impl[T: Scalar, C, A: Accumulator<T>] LeastNorm<T, C, A>, in T, is observer.ledger);

impl<T: Scalar, C, A> LeastNorm<T, C, A> {
    /// The candidate.
    pub fn candidate(&self) -> &C {
        &self.observer.candidate
    }

    /// The candidate, to be changed between ticks, as [`Lolc::candidate_mut`](crate::Lolc::candidate_mut).
    pub fn candidate_mut(&mut self) -> &mut C {
        &mut self.observer.candidate
    }

    /// The largest damping.
    pub fn limit(&self) -> DampingLimit<T> {
        self.limit
    }

    /// Changes the limit between ticks, as [`Lolc::set_limit`](crate::Lolc::set_limit).
    pub fn set_limit(&mut self, limit: DampingLimit<T>) {
        self.limit = limit;
    }

    /// The share of the observed energy by which it may fall on one tick.
    pub fn decay(&self) -> T {
        self.decay
    }

    /// Changes that share between ticks; the account stays.
    ///
    /// # Errors
    /// `decay` not above 0, or above 1; the old one stays.
    pub fn set_decay(&mut self, decay: T) -> Result<(), ParameterError> {
        self.decay = checked(decay)?;
        Ok(())
    }
}

fn checked<T: Scalar>(decay: T) -> Result<T, ParameterError> {
    let decay = Requirement::Positive.check("barrier decay", decay)?;
    Requirement::AtMost(1.0).check("barrier decay", decay)
}

lyapunov_core::snapshot! {
    impl[T: Scalar, C: Snapshot, A: Snapshot] LeastNorm<T, C, A>, is observer, of (C::State, A::State)
}
