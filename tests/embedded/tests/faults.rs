//! Every fault of a tick, at every tick of a loop, for every member: forces stay finite and bounded, and the next sample is
//! accepted again.
//!
//! A mass and a hand press into a wall of 6 kN/m at 1 kHz. What is finite and too large to be true, a member cannot tell
//! without being told what is plausible; such faults are in the position and in the effort asked for, not in the effort that
//! was applied.

use lyapunov_core::{
    CheckedSample, Clocked, Differenced, Mask, Reading, Readings, Scalar, Signal, Stabilizer,
};
use lyapunov_embedded::{Number, Visit, visit};

const TICKS: usize = 200;
const PERIOD: f64 = 1e-3; // s

/// The most that a member of `lyapunov_embedded::visit` damps, N·s/m: half of its least mass in each period.
fn limit(name: &str) -> f64 {
    if name == "popc-task-inertia" { 600.0 } else { 100.0 }
}

/// The largest force of the amplifier, N.
const STRONGEST: f64 = 50.0;

/// Ticks after a fault from which on every sample is accepted.
const RECOVERY: usize = 2;

/// Ports and ends of channels that answer by themselves, so that no effort is asked of them and none bounds them.
const ANSWERING: [&str; 4] = ["iss", "iss-adaptive", "virtual-coupling", "waves"];

/// No stabilizers: they pass on what they are asked.
const UNCHECKED: [&str; 2] = ["none", "by-hand"];

/// What is wrong in one tick.
#[derive(Clone, Copy, Debug)]
enum Fault {
    Position(f64),
    Stale,
    Missed,
    Mirrored,
    Applied(f64),
    AppliedMirrored,
    Late,
    Clock(f64),
    Asked(f64),
}

fn faults() -> Vec<Fault> {
    use Fault::*;
    let unbounded = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let large = [f64::MAX, -f64::MAX];
    let mut faults = vec![Stale, Missed, Mirrored, AppliedMirrored, Late];
    faults.extend(unbounded.into_iter().chain(large).map(Position));
    faults.extend(unbounded.map(Applied));
    faults.extend(unbounded.into_iter().chain(large).map(Asked));
    faults.extend(unbounded.into_iter().chain([0.0, -1.0, 1e9]).map(Clock));
    faults
}

/// The largest axis.
fn size<V: Signal>(signal: V) -> f64 {
    let mut most = 0.0_f64;
    signal.map(|axis| {
        most = most.max(axis.lane(0).abs());
        axis
    });
    most
}

/// The reading of a tick, spoilt by a fault if there is one.
fn read<V: Signal>(
    readings: &mut Readings<V, Differenced, Clocked>,
    tick: usize,
    mut reading: Reading<V>,
    fault: Option<Fault>,
) -> CheckedSample<V> {
    let bad = |number| V::splat(V::Scalar::of(number));
    let mut time = PERIOD * tick as f64;
    match fault {
        Some(Fault::Position(number)) => reading.position = bad(number),
        Some(Fault::Stale) => reading.position = readings.position(),
        Some(Fault::Mirrored) => reading.position = V::zero() - reading.position,
        Some(Fault::Applied(number)) => reading.applied = bad(number),
        Some(Fault::AppliedMirrored) => reading.applied = V::zero() - reading.applied,
        Some(Fault::Late) => time += 0.9 * PERIOD,
        Some(Fault::Clock(now)) => time = now,
        Some(Fault::Missed) => return readings.missed_at(time, reading.applied),
        Some(Fault::Asked(_)) | None => {}
    }
    readings.read_at(time, reading)
}

/// Runs a member with a `fault` at the tick `at`, and checks what it answers.
fn check<V: Signal, S: Stabilizer<V>>(name: &str, mut member: S, at: usize, fault: Fault) {
    let of = V::Scalar::of;
    let readings = Readings::<V>::every(of(PERIOD)).and_then(|it| it.no_faster_than(of(5.0)));
    let mut readings = readings.expect("readings").clocked();
    let [mut position, mut velocity] = [-2e-3, 0.2].map(|it| V::splat(of(it)));
    let (mut applied, mut asked_most, mut fastest) = (V::zero(), 0.0_f64, 0.0_f64);
    for tick in 0..TICKS {
        let now = (tick == at).then_some(fault);
        let sample = read(&mut readings, tick, Reading { position, applied }, now).sample;
        let wall = |x: V::Scalar| V::Scalar::choose(of(0.0).below(x), x * of(6000.0), of(0.0));
        let asked = match now {
            Some(Fault::Asked(number)) => V::splat(of(number)),
            _ => sample.position.map(wall),
        };
        let told = member.stabilize(&sample, asked);
        let place = || format!("{name}, {fault:?} at tick {at}, tick {tick}: {told:?}");
        let numbers = [told.alpha, told.shortfall].map(|it| it.finite().all());
        assert!(told.effort.finite().all() && numbers == [true; 2], "{}", place());
        if sample.velocity.finite().all() {
            fastest = fastest.max(size(sample.velocity));
        }
        if asked.finite().all() {
            asked_most = asked_most.max(size(asked));
        }
        let bound = (asked_most + limit(name) * fastest) * (1.0 + 1e-5);
        assert!(
            ANSWERING.contains(&name) || size(told.effort) <= bound,
            "above {bound} N: {}",
            place()
        );
        assert!(tick < at + RECOVERY || told.accepted.all(), "{}", place());

        applied = told.effort.limited(of(STRONGEST));
        let hand = position.map(|x| (x - of(2e-3)) * of(300.0)) + velocity;
        velocity = velocity - (hand + applied).scale(of(PERIOD / 0.2));
        position = position + velocity.scale(of(PERIOD));
    }
}

/// Every fault at every tick, but for a first position that is finite and absurd: nothing contradicts it yet, and it stands until
/// the readings are restarted.
struct Sweep;

impl<T: Number> Visit<T> for Sweep {
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        let asks = |fault: &Fault| matches!(fault, Fault::Asked(_));
        let fits = |fault: &Fault| !(ANSWERING.contains(&name) && asks(fault));
        let stands = |fault: &Fault| matches!(fault, Fault::Position(number) if number.is_finite());
        for fault in faults().into_iter().filter(fits) {
            let first = usize::from(stands(&fault));
            for at in (first..TICKS - RECOVERY).filter(|_| !UNCHECKED.contains(&name)) {
                check::<V, S>(name, member, at, fault);
            }
        }
    }
}

#[test]
fn no_fault_at_any_tick_leaves_its_bounds() {
    visit::<f64>(&mut Sweep).expect("the parameters");
    visit::<f32>(&mut Sweep).expect("the parameters");
}
