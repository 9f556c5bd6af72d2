//! Account of a port: `E₀ + Σ −ΔV + α v² T + shortfall ≥ 0`, by a sum of the test's own. It checks that a debt is told, and
//! not that there is none.

use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::{Config, RngSeed, TestCaseResult, TestRunner};

use lyapunov::{
    HeldTick, Mask, PortEnergy, PortSample, Scalar, Signal, Stabilizer, StorageFunction,
    accumulators::Plain,
    candidates::Gate,
    stabilizers::{
        AlongDirection, DirectedDamping, ForceBound, PathMemory, PerAxis, ReferenceFollowing,
        SlopeBound, StabilizerExt, Tank, TankLimits, WindowedCredit,
    },
};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD, limit, popc};

const TICKS: usize = 300;

/// Energy that a stabilizer counts besides the work of the port, J.
type Credit<V> = fn(&PortSample<V>) -> f64;

fn none<V: Signal>(_: &PortSample<V>) -> f64 {
    0.0
}

/// Closes the loop over random motions, forces and actuators, and keeps the account beside.
fn holds<V: Signal>(
    seed: u64,
    mut stabilizer: impl Stabilizer<V>,
    budget: f64,
    credit: Credit<V>,
) -> TestCaseResult {
    let of = V::Scalar::of;
    let mut dice = Dice::of(seed);
    let (mut position, mut applied) = (V::zero(), V::zero());
    let (mut account, mut size) = (budget, budget);
    for tick in 0..TICKS {
        let still = dice.within(1.0) > 0.8;
        let strength = if tick % 100 < 50 { 2e-4 } else { 2e-6 };
        let moved = if still { V::zero() } else { dice.signal(strength) };
        position = position + moved;
        let velocity = moved.map(|it| it / of(PERIOD));
        let sample =
            HeldTick { period: of(PERIOD), position, velocity, displacement: moved, applied }
                .sample();
        let works = sample.work.map(Scalar::magnitude).sum().lane(0);
        let credited = credit(&sample);
        account += sample.work.sum().lane(0) + credited;
        size += works + credited.abs();
        let correction = stabilizer.stabilize(&sample, dice.signal(20.0));
        let burnt = (correction.alpha * (velocity.inner(velocity) * of(PERIOD))).lane(0);
        let kept = account + burnt + correction.shortfall.lane(0);
        let rounding = TICKS as f64 * V::Scalar::epsilon().lane(0) * size;
        prop_assert!(correction.accepted.all(), "tick {tick}");
        prop_assert!(kept >= -rounding, "{kept:e} J on tick {tick}");
        // An actuator that now and then does not do all it is told.
        applied = if dice.within(1.0) > 0.5 {
            correction.effort.limited(of(8.0))
        } else {
            correction.effort
        };
    }
    Ok(())
}

/// Open where the first axis is positive.
#[derive(Clone, Copy, Debug)]
struct Half;

impl<V: Signal> Gate<V> for Half {
    fn open(&self, sample: &PortSample<V>) -> <V::Scalar as Scalar>::Mask {
        sample.position.sum().above(V::Scalar::of(0.0))
    }
}

const DAMPING: f64 = 0.1;

fn damper<V: Signal>(sample: &PortSample<V>) -> f64 {
    let moved = sample.displacement.inner(sample.displacement);
    (V::Scalar::of(DAMPING) * (moved / sample.period)).lane(0)
}

fn alike<V: Signal>(seed: u64) -> TestCaseResult {
    let of = V::Scalar::of;
    let popc = popc::<V::Scalar>();
    let fine = "what is built";
    holds::<V>(seed, popc, 0.0, none)?;
    holds::<V>(seed, popc.budgeted(of(1e-3)).expect(fine), 1e-3, none)?;
    holds::<V>(seed, popc.bounded(of(1e-4)).expect(fine), 0.0, none)?;
    holds::<V>(seed, popc.reset_at(Half), 0.0, none)?;
    holds::<V>(seed, popc.summed_in::<WindowedCredit<_, Plain<_>, 16>>(), 0.0, none)?;
    holds::<V>(seed, popc.above_velocity(of(0.01)).expect(fine), 0.0, none)?;
    holds::<V>(seed, popc.spread_over(5).expect(fine), 0.0, none)?;
    holds::<V>(seed, popc.rising_over(5).expect(fine), 0.0, none)?;
    holds::<V>(seed, popc.rate_limited::<V>(of(500.0)).expect(fine), 0.0, none)?;
    let along = AlongDirection::new(V::splat(of(1.0))).expect(fine);
    holds::<V>(seed, DirectedDamping::new(popc, along, limit()), 0.0, none)?;
    let bound = ForceBound::new(of(DAMPING)).and_then(|it| it.budgeted(of(1e-3)));
    holds::<V>(seed, bound.expect(fine), 1e-3, damper)?;
    let slope = SlopeBound::<V>::new(of(500.0)).and_then(|it| it.creeping(of(2.0)));
    holds::<V>(seed, slope.expect(fine), 0.0, none)?;
    let store = TankLimits { start: of(2e-3), floor: of(1e-3), ceiling: of(4e-3), power: of(0.5) };
    holds::<V>(seed, Tank::new(PortEnergy, store).expect(fine), 1e-3, none)
}

fn try_all(property: fn(u64) -> TestCaseResult) {
    let rng_seed = RngSeed::Fixed(0x5eed);
    let config = Config { cases: 200, failure_persistence: None, rng_seed, ..Config::default() };
    let result = TestRunner::new(config).run(&any::<u64>(), property);
    result.unwrap_or_else(|failed| panic!("{failed}"));
}

fn on_one_axis<T: Scalar>(seed: u64) -> TestCaseResult {
    let memory = PathMemory::<T, 32>::beyond(T::of(-1e-3), T::of(3e-3)).expect("what is built");
    holds::<T>(seed, memory, 0.0, none)
}

#[test]
fn on_a_line() {
    try_all(alike::<f64>);
    try_all(alike::<f32>);
    try_all(on_one_axis::<f64>);
    try_all(on_one_axis::<f32>);
}

#[test]
fn in_space() {
    try_all(alike::<Vector3<f64>>);
    try_all(alike::<Vector3<f32>>);
    try_all(|seed| holds::<Vector3<f64>>(seed, PerAxis::of([popc(); 3]), 0.0, none));
}

/// With a reference the energy stays above what the reference holds.
#[test]
fn above_a_reference() {
    const STIFFNESS: f64 = 500.0;
    try_all(|seed| {
        let stored = |x: f64, _v: f64| 0.5 * STIFFNESS * x * x;
        let candidate = (PortEnergy, StorageFunction::starting(stored, 0.0, 0.0));
        let following = ReferenceFollowing::new(candidate, limit());
        let change = |sample: &PortSample<f64>| {
            let before = sample.position - sample.displacement;
            0.5 * STIFFNESS * (before * before - sample.position * sample.position)
        };
        holds(seed, following, 0.0, change)
    });
}
