//! Seen step: what goes into one step of a member and what comes out, on every path.

use lyapunov_core::{Correction, PortSample, Scalar, Snapshot, Stabilizer};

use crate::fresh::{Axes, Memory};
use crate::paths;
use crate::symbolic::{Symbolic, Truth};

/// One path through a step.
#[derive(Debug)]
pub(crate) struct Seen {
    /// What is known of parameters and memory, and what decided for this path.
    pub(crate) given: Vec<Truth>,
    pub(crate) period: Symbolic,
    pub(crate) velocity: Vec<Symbolic>,
    pub(crate) asked: Vec<Symbolic>,
    pub(crate) effort: Vec<Symbolic>,
    pub(crate) sum: Symbolic,
    pub(crate) alpha: Symbolic,
    pub(crate) shortfall: Symbolic,
    pub(crate) accepted: Truth,
    /// `(v · v) T`, and 0 over a period that is none.
    pub(crate) square: Symbolic,
    /// Whether the memory is afterwards as it was taken to be before.
    pub(crate) memory: Truth,
    /// The largest damping.
    pub(crate) limit: Option<Symbolic>,
}

/// Member with what is asked of its memory beyond finite numbers, and its largest damping.
#[derive(Debug)]
pub(crate) struct Made<S> {
    pub(crate) stabilizer: S,
    pub(crate) limit: Option<Symbolic>,
}

/// The memory's further condition of a member that has none.
pub(crate) fn nothing_more<M>(_memory: &M) -> Truth {
    lyapunov_core::Mask::of(true)
}

/// A sample of any numbers.
pub(crate) fn any_sample<V: Axes>() -> PortSample<V> {
    PortSample {
        period: Symbolic::free("period", 1.0),
        position: V::called("position", 0.0),
        velocity: V::called("velocity", 1.0),
        displacement: V::called("displacement", 0.0),
        applied: V::called("applied", 0.0),
        work: V::called("work", -10.0),
    }
}

/// Every path through the step of a member with any parameters and any memory, at any sample.
pub(crate) fn step<V, S>(make: impl Fn() -> Made<S>, more: impl Fn(&S::State) -> Truth) -> Vec<Seen>
where
    V: Axes,
    S: Stabilizer<V> + Snapshot,
    S::State: Memory,
{
    let found = paths::every(|| {
        let Made { stabilizer, limit } = make();
        let memory = S::State::fresh("memory");
        paths::assume(memory.sound() & more(&memory));
        let mut stabilizer =
            stabilizer.restored(memory).expect("a memory that its own check accepts");
        let (sample, asked) = (any_sample::<V>(), V::called("effort", -10.0));
        let correction: Correction<V> = paths::step(|| stabilizer.stabilize(&sample, asked));
        let after = stabilizer.state();
        let inner = sample.velocity.inner(sample.velocity);
        Seen {
            given: vec![],
            period: sample.period,
            velocity: sample.velocity.axes(),
            asked: asked.axes(),
            effort: correction.effort.axes(),
            sum: correction.observed_energy,
            alpha: correction.alpha,
            shortfall: correction.shortfall,
            accepted: correction.accepted,
            square: inner * sample.period.larger(Symbolic::of(0.0)),
            memory: after.sound() & more(&after),
            limit,
        }
    });
    found
        .into_iter()
        .map(|path| {
            let decided =
                path.decided.iter().map(|(truth, held)| if *held { *truth } else { !*truth });
            Seen { given: path.known.iter().copied().chain(decided).collect(), ..path.result }
        })
        .collect()
}
