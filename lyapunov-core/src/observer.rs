//! Observer: a candidate, a kind of work and a sum.

use crate::{
    Accumulator, Held, Ledger, LyapunovCandidate, ParameterError, Plain, PortSample, Scalar,
    Signal, Snapshot, Work,
};

/// Observer of a port: the sum of a Lyapunov candidate's decrease (the paper's equation 8, in joules).
///
/// It only observes and changes no effort. A stabilizer is an observer with a controller behind it.
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, Observer, PortEnergy};
/// let mut observer = Observer::of(PortEnergy);
/// let start = PortSample::starting(1e-3, 0.0, 0.0);
/// // -2 N applied over 0.1 mm
/// let moved = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: -2.0 }.sample();
/// observer.observe(&start, -2.0);
/// assert_eq!(observer.observe(&moved, -3.0), -2e-4); // the port gave 0.2 mJ away
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Observer<C, W, A> {
    /// The candidate whose decrease is summed.
    pub candidate: C,
    /// The ledger that holds the sum.
    pub ledger: Ledger<W, A>,
}

impl<C, T: Scalar> Observer<C, Held, Plain<T>> {
    /// An observer of `candidate` that books held work in a plain sum.
    pub fn of(candidate: C) -> Self {
        Self { candidate, ledger: Ledger::new() }
    }
}

impl<C, W: Work, A> Observer<C, W, A> {
    /// The same candidate and sum, over another kind of work.
    #[must_use]
    pub fn over<X: Work>(self) -> Observer<C, X, A> {
        Observer { candidate: self.candidate, ledger: self.ledger.over() }
    }

    /// The same candidate and observed energy, in another sum.
    #[must_use]
    pub fn summed_in<T: Scalar, B: Accumulator<T>>(self) -> Observer<C, W, B>
    where
        A: Accumulator<T>,
    {
        let sum = B::holding(self.ledger.energy());
        Observer { candidate: self.candidate, ledger: Ledger::in_sum(sum) }
    }

    /// The candidate's decrease over the sample, J; `effort` is the response of the port behind the observer, N.
    #[inline(always)]
    pub fn decrease<V: Signal>(&mut self, sample: &PortSample<V>, effort: V) -> V::Scalar
    where
        C: LyapunovCandidate<V>,
    {
        self.candidate.decrease(&self.ledger.sample(sample, effort))
    }

    /// Books the candidate's decrease over the sample; returns the observed energy `L(n)`, J. A decrease that is not
    /// finite, or that the sum has no room for, is left out.
    #[inline(always)]
    pub fn observe<V: Signal>(&mut self, sample: &PortSample<V>, effort: V) -> V::Scalar
    where
        C: LyapunovCandidate<V>,
        A: Accumulator<V::Scalar>,
    {
        let decrease = self.decrease(sample, effort);
        self.ledger.credit(decrease);
        self.ledger.energy()
    }
}

impl<C: Snapshot, W: Work, A: Snapshot> Snapshot for Observer<C, W, A> {
    type State = (C::State, A::State);

    fn state(&self) -> Self::State {
        (self.candidate.state(), self.ledger.state())
    }

    fn restored(self, (candidate, ledger): Self::State) -> Result<Self, ParameterError> {
        let Self { candidate: own, ledger: sum } = self;
        Ok(Self { candidate: own.restored(candidate)?, ledger: sum.restored(ledger)? })
    }
}
