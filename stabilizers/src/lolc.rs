//! The Lyapunov observer/controller.

use lyapunov_core::{
    Accumulator, Correction, Held, Ledger, LyapunovCandidate, Mask, Observer, ParameterError,
    Plain, PortSample, Sampled, Scalar, Signal, Snapshot, Stabilizer, Work,
};

use crate::account::{account, booked};
use crate::credit::limits_credit;
use crate::{DampingLimit, StabilizerExt};

/// Lyapunov observer/controller of Jafari, Etoundi and Chong.
///
/// `α(n) = min(−L(n) / (v(n)² T), limit)` where `L(n) < 0` and `v(n)² T` is above the smallest normal
/// number, else 0; effort out is effort in plus `α(n) v(n)`. (The paper's steps 4 to 6 and its equations 13
/// and 18, which leave out `T` and the limit.) The observed energy `L` follows from the candidate, the kind of
/// work and the accumulator with which the stabilizer is built.
///
/// The served energy is `L + α v² T`. Served energy plus shortfall is never negative, and the served energy is never
/// negative where `v² T` is above the smallest normal number and `α` below its limit. Both hold exactly for a reader
/// who recomputes the served energy as `L + α · ((v · v) · T)`: the second because `α` is rounded up by a few units in
/// the last place, as long as `α` and that product are normal numbers, the first always, because the shortfall is what
/// that reader finds missing. These are identities of bookkeeping: a tick may bring any debt. A run with `L ≥ 0` on
/// every tick is one whose port gave no more than it took and was credited; that every run is like this is not
/// promised.
///
/// Every choice is a select, so a sound sample takes the same time whatever it holds, and lanes run the same
/// code. A sample is rejected where `L`, `v² T`, the served energy and the corrected effort do not add up to a finite
/// number, and where the period is not above 0: the effort
/// is then zero, the correction reports the sample as not accepted, and the ledger books its decrease if that is
/// finite, as the past that the sample reports did happen.
///
/// ```
/// use lyapunov_core::{Dissipation, HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Lolc};
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?; // half of m / T
/// let candidate = (PortEnergy, Dissipation::of(0.001)?); // credit what the device's damper dissipates
/// let mut lolc = Lolc::new(candidate, limit);
/// // -2 N applied over 0.1 mm: a debt of 0.2 mJ
/// let sample = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: -2.0 }.sample();
/// let correction = lolc.stabilize(&sample, 0.5);
/// assert!(correction.observed_energy < 0.0 && correction.effort > 0.5 && correction.shortfall == 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Lolc<T, C, W = Held, A = Plain<T>> {
    observer: Observer<C, W, A>,
    limit: DampingLimit<T>,
}

impl<T: Scalar, C> Lolc<T, C> {
    /// The stabilizer that watches `candidate` over held work, summed in one number.
    pub fn new(candidate: C, limit: DampingLimit<T>) -> Self {
        Self { observer: Observer::of(candidate), limit }
    }
}

impl<T: Scalar, C, W: Work, A: Accumulator<T>> Lolc<T, C, W, A> {
    /// The same stabilizer over the paper's sampled work.
    #[must_use]
    pub fn sampled(self) -> Lolc<T, C, Sampled, A> {
        Lolc { observer: self.observer.over(), limit: self.limit }
    }

    /// The same stabilizer with its energies summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> Lolc<T, C, W, B> {
        Lolc { observer: self.observer.summed_in(), limit: self.limit }
    }

    /// The same stabilizer with its energies summed in `sum`, from the present value of `sum` on: what was summed before is left
    /// behind, and with it a budget, so give that afterwards.
    #[must_use]
    pub fn summed_by<B: Accumulator<T>>(self, sum: B) -> Lolc<T, C, W, B> {
        let candidate = self.observer.candidate;
        Lolc { observer: Observer { candidate, ledger: Ledger::in_sum(sum) }, limit: self.limit }
    }

    /// The same stabilizer with `energy` more joules of stored credit: a budget for the energy stored at the start.
    ///
    /// A loop that starts from rest in a compressed spring gives that energy away without having absorbed it first.
    /// With `E₀ = V(x₀)` credited, `L(n) = E₀ + Σ −ΔV`, and where `L ≥ 0` the port has given at most `E₀`.
    /// Credit for an energy that the port does not store only delays the controller.
    ///
    /// # Errors
    /// `energy` below 0, infinite or NaN, or more than the sum has room for.
    ///
    /// ```
    /// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
    /// use lyapunov_stabilizers::{DampingLimit, Popc};
    /// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
    /// // a spring pushes out: it gives 0.2 mJ
    /// let sample = HeldTick {
    ///     period: 1e-3, position: 0.0, velocity: -0.1, displacement: -1e-4, applied: 2.0
    /// }.sample();
    /// assert!({ popc }.stabilize(&sample, 2.0).alpha > 0.0);
    /// assert_eq!(popc.budgeted(1e-3)?.stabilize(&sample, 2.0).alpha, 0.0);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    pub fn budgeted(mut self, energy: T) -> Result<Self, ParameterError> {
        self.observer.ledger = booked("budget", energy, self.observer.ledger, Ledger::credit)?;
        Ok(self)
    }

    /// Adds `energy` joules, which may be below 0.
    #[inline]
    pub(crate) fn credit(&mut self, energy: T) {
        self.observer.ledger.credit(energy);
    }
}

impl<T: Copy, C, W, A> Lolc<T, C, W, A> {
    /// The candidate.
    #[inline]
    pub fn candidate(&self) -> &C {
        &self.observer.candidate
    }

    /// The candidate, to be changed between ticks.
    ///
    /// What was summed stays, and from the next tick on the decrease of the changed one is added. `L ≥ 0` then bounds
    /// what the sum of both says, each over its time; a term that credits more from now on weakens the bound from now on.
    #[inline]
    pub fn candidate_mut(&mut self) -> &mut C {
        &mut self.observer.candidate
    }

    /// The largest damping that is injected.
    #[inline]
    pub fn limit(&self) -> DampingLimit<T> {
        self.limit
    }

    /// Changes the limit between ticks, as where the period or the moving mass changes.
    ///
    /// It changes no sum. With a debt open, a smaller limit serves it more slowly and reports the rest as shortfall, and
    /// one of 0 only observes it; the debt stays. A limit that is too large for the period adds energy.
    ///
    /// ```
    /// use lyapunov_core::PortEnergy;
    /// use lyapunov_stabilizers::{DampingLimit, Popc};
    /// let mut popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
    /// popc.set_limit(DampingLimit::of_mass(0.5, 0.2, 0.5e-3)?); // the loop runs at 2 kHz now
    /// assert_eq!(popc.limit().most(), 200.0);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    #[inline]
    pub fn set_limit(&mut self, limit: DampingLimit<T>) {
        self.limit = limit;
    }
}

limits_credit!(impl[T: Scalar, C, W: Work, A: Accumulator<T>] Lolc<T, C, W, A>, in T, of observer.ledger);

impl<V, C, W, A> Stabilizer<V> for Lolc<V::Scalar, C, W, A>
where
    V: Signal,
    C: LyapunovCandidate<V>,
    W: Work,
    A: Accumulator<V::Scalar>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let before = self.observer.ledger;
        // As the ledger's own samples have it, so that a credit and this are one product.
        let period = sample.period.larger(V::Scalar::of(0.0));
        let terms = Terms {
            decrease: self.observer.decrease(sample, effort),
            square: sample.velocity.inner(sample.velocity) * period,
            velocity: sample.velocity,
            effort,
        };
        let mut correction = self.correct(terms);
        // An infinite period makes the step's numbers infinite or NaN.
        correction.accepted = correction.accepted & period.above(V::Scalar::of(0.0));
        if correction.accepted.all() {
            correction
        } else {
            self.reject(before, terms.decrease, correction)
        }
    }
}

/// Quantities of one step.
#[derive(Clone, Copy)]
struct Terms<V: Signal> {
    decrease: V::Scalar,
    square: V::Scalar,
    velocity: V,
    effort: V,
}

impl<T: Scalar, C, W: Work, A: Accumulator<T>> Lolc<T, C, W, A> {
    #[inline(always)]
    fn correct<V: Signal<Scalar = T>>(&mut self, terms: Terms<V>) -> Correction<V> {
        let Terms { decrease, square, velocity, effort } = terms;
        let zero = T::zero();
        let moving = square.above(T::smallest_normal());
        let limit = T::choose(moving, self.limit.most(), zero);
        // The division waits for the motion and not for the effort. The margin rounds alpha up: it covers the rounding
        // of the divisor, of its reciprocal, of alpha, of the product by which a reader checks it, and of v² T in any
        // order. The divisor stays normal: 0 would give an infinity, and a subnormal one takes several times as long.
        let margin = T::of(1.0) - T::of(4.0) * T::epsilon();
        let inverse = T::of(-1.0) / (square * margin).larger(T::smallest_normal());
        let sum = self.observer.ledger.book(decrease, limit * square);
        // A sum of 0 or more gives a number of 0 or less, which makes alpha +0.
        let alpha = (sum * inverse).smaller(limit).larger(zero);
        // What alpha serves is multiplied out as a reader does, so that the shortfall is exact also where alpha underflows.
        let served = sum + alpha * square;
        let effort = effort + velocity.scale(alpha);
        let accepted = (served + effort.sum()).finite();
        let shortfall = zero - served.smaller(zero);
        Correction { effort, observed_energy: sum, alpha, shortfall, accepted }
    }

    /// The step for a rejected sample: what was absorbed is booked if it is sound, and nothing is corrected.
    ///
    /// It is a path of its own, because within the step it would cost five more selects on every tick for a rare case;
    /// it is inlined, because a call would keep the sum and the correction in memory instead of registers.
    #[inline(always)]
    fn reject<V: Signal<Scalar = T>>(
        &mut self,
        before: Ledger<W, A>,
        decrease: T,
        correction: Correction<V>,
    ) -> Correction<V> {
        let (accepted, zero) = (correction.accepted, T::zero());
        let mut booked = before;
        booked.credit(decrease);
        self.observer.ledger = Ledger::choose::<T>(accepted, self.observer.ledger, booked);
        let sum = booked.energy();
        Correction {
            effort: V::choose(accepted, correction.effort, V::zero()),
            observed_energy: T::choose(accepted, correction.observed_energy, sum),
            alpha: T::choose(accepted, correction.alpha, zero),
            shortfall: T::choose(accepted, correction.shortfall, zero - sum.smaller(zero)),
            accepted,
        }
    }
}

impl<T, C, W, A> StabilizerExt for Lolc<T, C, W, A> {}

account!(impl[T: Scalar, C, W: Work, A: Accumulator<T>] Lolc<T, C, W, A>, in T, is observer.ledger);

lyapunov_core::snapshot! {
    impl[T: Scalar, C: Snapshot, W: Work, A: Snapshot] Lolc<T, C, W, A>, is observer, of (C::State, A::State)
}
