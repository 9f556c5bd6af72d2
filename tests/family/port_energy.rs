//! Account of a port, by a sum of the test's own: the stabilizers tell it, or less where they forget credit, and
//! `E₀ + Σ −ΔV + α v² T + shortfall ≥ 0`, which says that a debt is told, and not that there is none.

use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestCaseResult, TestRunner};

use lyapunov::{
    Dissipation, Lolc, Mask, PortEnergy, PortSample, Scalar, Signal, Stabilizer, StorageFunction,
    accumulators::{Compensated, Plain},
    candidates::Gate,
    stabilizers::{
        AlongDirection, DirectedDamping, ForceBound, LeastNorm, PathMemory, PerAxis, Plausibility,
        ReferenceFollowing, SlopeBound, StabilizerExt, Tank, TankLimits, WatchdogTimes,
        WindowedCredit,
    },
};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD, held_tick, limit, popc};

const TICKS: usize = 300;

/// Energy that a stabilizer counts besides the work of the port, J.
type Credit<V> = fn(&PortSample<V>) -> f64;

fn none<V: Signal>(_: &PortSample<V>) -> f64 {
    0.0
}

/// Energies that the test and the stabilizer know on a tick, J.
struct Told {
    account: f64,
    observed: f64,
    burnt: f64,
    shortfall: f64,
    rounding: f64,
}

/// Closes the loop over random motions, forces and actuators, and keeps the account beside.
fn run<V: Signal>(
    seed: u64,
    mut stabilizer: impl Stabilizer<V>,
    budget: f64,
    credit: Credit<V>,
) -> Result<Vec<Told>, TestCaseError> {
    let of = V::Scalar::of;
    let mut dice = Dice::of(seed);
    let (mut position, mut applied) = (V::zero(), V::zero());
    let (mut account, mut size) = (budget, budget);
    let mut told = Vec::new();
    for tick in 0..TICKS {
        let still = dice.within(1.0) > 0.8;
        let strength = if tick % 100 < 50 { 2e-4 } else { 2e-6 };
        let moved = if still { V::zero() } else { dice.signal(strength) };
        position = position + moved;
        let sample = held_tick(position, moved, applied);
        let works = sample.work.map(Scalar::magnitude).sum().lane(0);
        let credited = credit(&sample);
        account += sample.work.sum().lane(0) + credited;
        size += works + credited.abs();
        let correction = stabilizer.stabilize(&sample, dice.signal(20.0));
        prop_assert!(correction.accepted.all(), "tick {tick}");
        told.push(Told {
            account,
            observed: correction.observed_energy.lane(0),
            burnt: (correction.alpha * (sample.velocity.inner(sample.velocity) * of(PERIOD)))
                .lane(0),
            shortfall: correction.shortfall.lane(0),
            rounding: TICKS as f64 * V::Scalar::epsilon().lane(0) * size,
        });
        // An actuator that now and then does not do all it is told.
        applied = if dice.within(1.0) > 0.5 {
            correction.effort.limited(of(8.0))
        } else {
            correction.effort
        };
    }
    Ok(told)
}

/// A debt of the port is told, whatever the stabilizer's own account says.
fn holds<V: Signal>(
    seed: u64,
    stabilizer: impl Stabilizer<V>,
    budget: f64,
    credit: Credit<V>,
) -> TestCaseResult {
    for (tick, told) in run(seed, stabilizer, budget, credit)?.iter().enumerate() {
        let kept = told.account + told.burnt + told.shortfall;
        prop_assert!(kept >= -told.rounding, "{kept:e} J on tick {tick}");
    }
    Ok(())
}

/// The stabilizer's own account is that of the test, or less by what it has `forgotten`, J, at most.
fn tells<V: Signal>(
    seed: u64,
    stabilizer: impl Stabilizer<V>,
    budget: f64,
    credit: Credit<V>,
    forgotten: f64,
) -> TestCaseResult {
    for (tick, told) in run(seed, stabilizer, budget, credit)?.iter().enumerate() {
        let off = told.observed - told.account;
        let range = -told.rounding - forgotten..=told.rounding;
        prop_assert!(range.contains(&off), "{off:e} J on tick {tick}");
    }
    Ok(())
}

/// A debt is told, and the account is the test's.
fn keeps<V: Signal>(
    seed: u64,
    stabilizer: impl Stabilizer<V> + Clone,
    budget: f64,
    credit: Credit<V>,
) -> TestCaseResult {
    holds(seed, stabilizer.clone(), budget, credit)?;
    tells(seed, stabilizer, budget, credit, 0.0)
}

/// A debt is told, and the account is never more than the test's: credit may be forgotten.
fn forgets<V: Signal>(
    seed: u64,
    stabilizer: impl Stabilizer<V> + Clone,
    budget: f64,
    credit: Credit<V>,
) -> TestCaseResult {
    holds(seed, stabilizer.clone(), budget, credit)?;
    tells(seed, stabilizer, budget, credit, f64::INFINITY)
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
    keeps::<V>(seed, popc, 0.0, none)?;
    keeps::<V>(seed, popc.summed_in::<Compensated<_>>(), 0.0, none)?;
    keeps::<V>(seed, popc.budgeted(of(1e-3)).expect(fine), 1e-3, none)?;
    keeps::<V>(seed, popc.above_velocity(of(0.01)).expect(fine), 0.0, none)?;
    keeps::<V>(seed, popc.spread_over(5).expect(fine), 0.0, none)?;
    keeps::<V>(seed, popc.rising_over(5).expect(fine), 0.0, none)?;
    keeps::<V>(seed, popc.rate_limited::<V>(of(500.0)).expect(fine), 0.0, none)?;
    keeps::<V>(
        seed,
        popc.plausible(Plausibility { speed: of(1e3), effort: of(1e3) }).expect(fine),
        0.0,
        none,
    )?;
    let times = WatchdogTimes { hold: of(0.01), rise: of(0.1) };
    keeps::<V>(seed, popc.watched::<V>(times).expect(fine), 0.0, none)?;
    let along = AlongDirection::new(V::splat(of(1.0))).expect(fine);
    keeps::<V>(seed, DirectedDamping::new(popc, along, limit()), 0.0, none)?;
    let credited = (PortEnergy, Dissipation::of(of(DAMPING)).expect(fine));
    keeps::<V>(seed, Lolc::new(credited, limit()), 0.0, damper)?;
    tells::<V>(seed, LeastNorm::new(credited, limit(), of(0.3)).expect(fine), 0.0, damper, 0.0)?;
    let bound = ForceBound::new(of(DAMPING)).and_then(|it| it.budgeted(of(1e-3)));
    keeps::<V>(seed, bound.expect(fine), 1e-3, damper)?;
    let slope = SlopeBound::<V>::new(of(500.0)).and_then(|it| it.creeping(of(2.0)));
    keeps::<V>(seed, slope.expect(fine), 0.0, none)?;

    let windowed = popc.summed_in::<WindowedCredit<_, Plain<_>, 16>>();
    forgets::<V>(seed, windowed, 0.0, none)?;
    let bounded = popc.bounded(of(1e-4)).expect(fine);
    forgets::<V>(seed, bounded, 0.0, none)?;
    forgets::<V>(seed, popc.reset_at(Half), 0.0, none)?;
    let store = TankLimits { start: of(2e-3), floor: of(1e-3), ceiling: of(4e-3), power: of(0.5) };
    let tank = Tank::new(PortEnergy, store).expect(fine);
    forgets::<V>(seed, tank, 1e-3, none)
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
        keeps(seed, following, 0.0, change)
    });
}
