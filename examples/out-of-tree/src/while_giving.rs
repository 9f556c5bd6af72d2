//! An own stabilizer.

use lyapunov::{Correction, Held, Observer, ParameterError, accumulators::Plain, prelude::*};

/// Pays a debt only while the environment pushes along, so that free motion never feels it:
/// `α = min(−L / (v² T), limit)` where `L < 0` and `f · v < 0`, else 0.
#[derive(Clone, Copy, Debug)]
pub struct WhileGiving<T, C> {
    /// The account, whose `ledger` carries a debt over by `owe`.
    pub observer: Observer<C, Held, Plain<T>>,
    limit: DampingLimit<T>,
}

impl<T: Scalar, C> WhileGiving<T, C> {
    /// The stabilizer that watches `candidate` and injects at most `limit`.
    pub fn new(candidate: C, limit: DampingLimit<T>) -> Self {
        Self { observer: Observer::of(candidate), limit }
    }
}

impl<V: Signal, C: LyapunovCandidate<V>> Stabilizer<V> for WhileGiving<V::Scalar, C> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, tiny) = (V::Scalar::of(0.0), V::Scalar::smallest_normal());
        let sum = self.observer.observe(sample, effort);
        let square = sample.velocity.inner(sample.velocity) * sample.period;
        let sound = sample.sound() & effort.finite() & square.finite();
        let velocity = V::choose(sound, sample.velocity, V::zero());
        let effort = V::choose(sound, effort, V::zero());
        let square = V::Scalar::choose(sound, square, zero);

        let debt = (-sum).larger(zero);
        let giving = effort.inner(velocity).below(zero) & square.above(tiny);
        let wanted = (debt / square.larger(tiny)).smaller(self.limit.most());
        let alpha = V::Scalar::choose(giving, wanted, zero);
        Correction {
            effort: effort + velocity.scale(alpha),
            observed_energy: sum,
            alpha,
            shortfall: (debt - alpha * square).larger(zero),
            accepted: sound,
        }
        .checked()
    }
}

impl<T: Scalar, C: Snapshot> Snapshot for WhileGiving<T, C> {
    type State = <Observer<C, Held, Plain<T>> as Snapshot>::State;

    fn state(&self) -> Self::State {
        self.observer.state()
    }

    fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
        Ok(Self { observer: self.observer.restored(state)?, ..self })
    }
}
