//! Ledger: the observed energy of a port, and which work it books.

use core::fmt::Debug;
use core::marker::PhantomData;

use crate::{Accumulator, HeldTick, PortSample, Scalar, Signal, Snapshot};

/// Kind of work that a ledger books.
pub trait Work: Copy + Debug {
    /// The sample that the candidate's terms see, given the effort of the port behind the stabilizer.
    fn sample<V: Signal>(sample: &PortSample<V>, effort: V) -> PortSample<V>;

    /// Books `decrease` joules and then a correction that removes at most `allowance` joules of a debt; returns
    /// the sum before the correction.
    fn book<T: Scalar, A: Accumulator<T>>(sum: &mut A, decrease: T, allowance: T) -> T;
}

/// Held work: the applied effort times the displacement, which is the work that really crossed the port.
///
/// `L(n) = L(n−1) + f_act(n−1) Δx(n) + credit`. Under a held effort this is exact, the controller's own
/// damping included, so nothing is assumed about what a correction achieved: the next sample shows it.
/// This is the default; hold-exact port energy is due to Stramigioli and co-workers (IEEE Transactions on
/// Robotics 21(4), 2005).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Held;

impl Work for Held {
    #[inline(always)]
    fn sample<V: Signal>(sample: &PortSample<V>, _effort: V) -> PortSample<V> {
        // Over a period that is none, nothing is credited.
        PortSample { period: sample.period.larger(V::Scalar::of(0.0)), ..*sample }
    }

    #[inline(always)]
    fn book<T: Scalar, A: Accumulator<T>>(sum: &mut A, decrease: T, _allowance: T) -> T {
        sum.add(decrease);
        sum.value()
    }
}

/// Sampled work, the paper's step 4: the power sampled now, and the correction booked in full.
///
/// `L(n) = L(n−1) + (f(n) v(n) + α(n−1) v(n−1)²) T + credit`. It misses the energy that leaks between two
/// samples, saturation and delay.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sampled;

impl Work for Sampled {
    #[inline(always)]
    fn sample<V: Signal>(sample: &PortSample<V>, effort: V) -> PortSample<V> {
        // Over a period that is none, nothing is booked.
        let period = sample.period.larger(V::Scalar::of(0.0));
        let displacement = sample.velocity.scale(period);
        HeldTick {
            period,
            position: sample.position,
            velocity: sample.velocity,
            displacement,
            applied: effort,
        }
        .sample()
    }

    #[inline(always)]
    fn book<T: Scalar, A: Accumulator<T>>(sum: &mut A, decrease: T, allowance: T) -> T {
        // α dissipates exactly the debt, or the most it can where that is less, so the sum is raised by that here
        // instead of carrying α and v² to the next tick: the division leaves the chain from tick to tick.
        sum.add_and_raise(decrease, allowance)
    }
}

/// Ledger of a port: the sum that holds the observed energy `L`.
#[derive(Clone, Copy, Debug)]
pub struct Ledger<W, A> {
    sum: A,
    work: PhantomData<W>,
}

impl<W: Work, A> Ledger<W, A> {
    /// An empty ledger.
    pub fn new<T: Scalar>() -> Self
    where
        A: Accumulator<T>,
    {
        Self::in_sum(A::zero())
    }

    /// A ledger that goes on from `sum`.
    pub fn in_sum(sum: A) -> Self {
        Self { sum, work: PhantomData }
    }

    /// The same sum, of another kind of work.
    #[must_use]
    pub fn over<X: Work>(self) -> Ledger<X, A> {
        Ledger::in_sum(self.sum)
    }

    /// The observed energy, J.
    #[inline]
    pub fn energy<T: Scalar>(&self) -> T
    where
        A: Accumulator<T>,
    {
        self.sum.value()
    }

    /// Empties the ledger: credit is forfeited, a debt forgiven.
    #[inline]
    pub fn clear<T: Scalar>(&mut self)
    where
        A: Accumulator<T>,
    {
        self.sum.clear();
    }

    /// Adds `energy` joules of credit, or below 0 of debt, in the lanes whose sum stays finite; tells which.
    #[inline]
    pub fn credit<T: Scalar>(&mut self, energy: T) -> T::Mask
    where
        A: Accumulator<T>,
    {
        self.sum.book(energy)
    }

    /// Forfeits the stored credit above `most` joules.
    #[inline]
    pub fn limit_credit<T: Scalar>(&mut self, most: T)
    where
        A: Accumulator<T>,
    {
        self.sum.lower(most);
    }

    /// The sample that the candidate's terms see, given the effort of the port behind the stabilizer.
    #[inline(always)]
    pub fn sample<V: Signal>(&self, sample: &PortSample<V>, effort: V) -> PortSample<V> {
        W::sample(sample, effort)
    }

    /// Books `decrease` joules and then a correction that removes at most `allowance` joules of a debt; returns
    /// `L(n)`, the observed energy before the correction.
    #[inline(always)]
    pub fn book<T: Scalar>(&mut self, decrease: T, allowance: T) -> T
    where
        A: Accumulator<T>,
    {
        W::book(&mut self.sum, decrease, allowance)
    }

    /// `yes` where `mask` is true, `no` elsewhere, lane by lane.
    #[inline(always)]
    pub fn choose<T: Scalar>(mask: T::Mask, yes: Self, no: Self) -> Self
    where
        A: Accumulator<T>,
    {
        Self::in_sum(A::choose(mask, yes.sum, no.sum))
    }
}

crate::snapshot!(impl[W: Work, A: Snapshot] Ledger<W, A>, is sum, of A::State);
