//! Ticks without a reading: the next sample spans them.

use proptest::prelude::any;
use proptest::{prop_assert, prop_assert_eq, proptest};

use approx::assert_abs_diff_eq;
use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, Mask, MovingReading, Popc, PortEnergy, PortSample,
    Reading, Sampled, Scalar, Stabilizer, StorageFunction,
    stabilizers::{Account, ReferenceDamper},
};

use crate::support::{Dice, PERIOD, reading, readings};

const COUNT: f64 = 1.0 / 4096.0; // m: sums of counts are exact

proptest! {
    /// A run with gaps, under one held force, is the run without them with the missing ticks summed by hand.
    #[test]
    fn a_gap_is_the_sum_of_its_ticks(seed in any::<u64>(), force in -20i32..20) {
        let force = f64::from(force);
        let mut dice = Dice::of(seed);
        let (mut whole, mut broken) = (readings::<f64>(), readings::<f64>());
        let mut sum = None;
        let (mut position, mut applied) = (dice.whole(4000) * COUNT, 0.0);
        for tick in 0..60 {
            let sample = whole.read(reading(position, applied)).sample;
            let summed = match sum {
                Some(earlier) => sample.spanning(&earlier),
                None => sample,
            };
            let missing = tick > 0 && dice.draw().is_multiple_of(3);
            let told = if missing {
                broken.missed(applied)
            } else {
                broken.read(reading(position, applied))
            };
            prop_assert_eq!(told.accepted, !missing);
            if missing {
                prop_assert!(told.sample.work.is_nan());
                prop_assert_eq!(told.sample.displacement, 0.0);
                prop_assert_eq!(told.sample.period, PERIOD);
                sum = Some(summed);
            } else {
                prop_assert_eq!(told.sample.period, summed.period);
                prop_assert_eq!(told.sample.displacement, summed.displacement);
                prop_assert_eq!(told.sample.work, summed.work);
                prop_assert_eq!(told.sample.position, summed.position);
                prop_assert_eq!(told.late, sum.is_some());
                prop_assert_eq!(told.sample.velocity, summed.displacement / summed.period);
                sum = None;
            }
            position += dice.whole(50) * COUNT;
            applied = force;
        }
    }

    /// Under efforts that change within the gap the work is never overstated while the motion does not turn round.
    #[test]
    fn a_gap_is_not_overstated(seed in any::<u64>(), outwards in any::<bool>()) {
        let mut dice = Dice::of(seed);
        let (mut readings, mut truth) = (readings::<f64>(), 0.0);
        let (mut position, mut applied) = (0.0, 0.0);
        readings.read(reading(position, applied));
        for _ in 0..40 {
            let way = dice.whole(30).abs() * COUNT * if outwards { -1.0 } else { 1.0 };
            applied = dice.whole(9);
            position += way;
            truth += applied * way;
            if dice.draw().is_multiple_of(2) {
                readings.missed(applied);
            } else {
                let work = readings.read(reading(position, applied)).sample.work;
                prop_assert!(work <= truth, "{} of {}", work, truth);
                truth = 0.0;
            }
        }
    }
}

/// What is rejected changes nothing in a stabilizer, and the next reading books what crossed the port meanwhile.
#[test]
fn a_stabilizer_rejects_a_gap_and_books_it_later() {
    let popc = Popc::new(PortEnergy, DampingLimit::at(50.0).expect("a limit"));
    let (mut popc, mut readings) = (popc, readings::<f64>());
    popc.stabilize(&readings.read(reading(0.25, 0.0)).sample, 4.0);
    let lost = popc.stabilize(&readings.missed(4.0).sample, 4.0);
    assert!(!lost.accepted && lost.effort == 0.0 && lost.observed_energy == 0.0);
    let found = popc.stabilize(&readings.read(reading(0.75, 4.0)).sample, 4.0);
    assert!(found.accepted);
    assert_eq!(found.observed_energy, 2.0); // 4 N over 0.5 m
}

/// Over sampled work, which takes nothing from the sample's own, a gap books nothing either.
#[test]
fn sampled_work_books_nothing_in_a_gap() {
    let popc: Popc<f64, Sampled> =
        Popc::new(PortEnergy, DampingLimit::at(50.0).expect("a limit")).sampled();
    let (mut popc, mut readings) = (popc, readings::<f64>());
    popc.stabilize(&readings.read(reading(0.25, 0.0)).sample, 4.0);
    let before = popc.stabilize(&readings.read(reading(0.5, 4.0)).sample, 4.0).observed_energy;
    let gap = popc.stabilize(&readings.missed(4.0).sample, 4.0);
    assert_eq!(gap.observed_energy, before);
}

/// Before the first reading there is no position, and nothing to span.
#[test]
fn nothing_is_booked_before_the_first_reading() {
    let mut readings = readings::<f64>();
    for _ in 0..5 {
        let none = readings.missed(7.0);
        assert!(!none.accepted && none.sample.position == 0.0);
    }
    let first = readings.read(reading(0.3, 7.0));
    assert!(first.accepted && !first.late);
    let sample = first.sample;
    assert_eq!([sample.displacement, sample.work, sample.velocity], [0.0; 3]);
    assert_eq!(sample.period, PERIOD);
}

/// An effort that is not finite counts as one before it, and its tick as a gap.
#[test]
fn an_unknown_effort_is_a_gap() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut readings = readings::<f64>();
        readings.read(reading(0.0, 0.0));
        readings.read(reading(0.25, 2.0));
        let lost = readings.read(reading(0.5, bad));
        assert!(!lost.accepted && lost.sample.applied == 2.0);
        let found = readings.read(reading(0.75, 2.0)).sample;
        assert_eq!((found.work, found.period), (1.0, 2.0 * PERIOD));
    }
}

/// A measured velocity after a gap is no larger than the mean over it, and 0 against it.
#[test]
fn a_velocity_after_a_gap_is_careful() {
    for (told, careful) in [(1024.0, 64.0), (32.0, 32.0), (-1024.0, 0.0), (f64::NAN, 0.0)] {
        let mut readings = readings::<f64>().measured();
        let at = |position, velocity| MovingReading { position, velocity, applied: 0.0 };
        readings.read_moving(at(0.0, 0.0));
        assert!(!readings.missed_moving(0.0).accepted);
        let found = readings.read_moving(at(0.125, told)).sample;
        assert_eq!(found.velocity, careful, "of {told}"); // 0.125 m in two periods are 64 m/s
        let next = readings.read_moving(at(0.125, 5.0)).sample;
        assert_eq!(next.velocity, 5.0); // what is measured without a gap is passed on
    }
}

/// In one lane there is a gap, in the others none.
#[test]
fn gaps_are_per_lane() {
    use lyapunov::lanes::AutoF64x4;
    let of = |lanes: [f64; 4]| AutoF64x4::from_lanes(|lane| lanes[lane]);
    let period = AutoF64x4::of(PERIOD);
    let mut readings = lyapunov::Readings::<AutoF64x4>::every(period).expect("a period");
    let mut read = |position| {
        readings.read(Reading { position: of(position), applied: of([1.0, 2.0, 3.0, 4.0]) })
    };
    read([0.0; 4]);
    let lost = read([0.25, f64::NAN, 0.25, 0.25]);
    let found = read([0.5; 4]);
    for lane in 0..4 {
        let gap = lane == 1;
        assert_eq!((lost.accepted.lane(lane), found.late.lane(lane)), (!gap, gap));
        let way = if gap { 0.5 } else { 0.25 };
        assert_eq!(found.sample.work.lane(lane), way * (lane + 1) as f64);
    }
}

/// A storage function telescopes over missed readings: what is summed is the start's energy less the end's.
#[test]
fn a_storage_function_telescopes_over_a_gap() {
    let energy = |_: f64, v: f64| 0.5 * 0.3 * v * v;
    let mut alone =
        Lolc::new(StorageFunction::starting(energy, 0.0, 0.0), DampingLimit::at(0.0).unwrap());
    let mut readings = readings();
    let (mut position, mut rejected) = (0.0, 0);
    for tick in 0..1000 {
        position += 64.0 * COUNT * PERIOD;
        let told = if tick % 5 == 4 {
            readings.missed(0.0)
        } else {
            readings.read(reading(position, 0.0))
        };
        let correction = alone.stabilize(&told.sample, 0.0);
        assert_eq!(correction.accepted, told.accepted);
        rejected += u32::from(!correction.accepted);
    }
    assert_eq!(rejected, 200);
    let v: f64 = 64.0 * COUNT;
    assert_abs_diff_eq!(alone.observed_energy(), -0.5 * 0.3 * v * v, epsilon = 1e-15);
}

/// The reference of a wall whose start is unknown begins with the first reading, and dissipates nothing before.
#[test]
fn a_reference_that_starts_unknown_owes_nothing() {
    let depth = |x: f64| x.max(0.0);
    let mut damper = ReferenceDamper::starting(2.0, depth, f64::NAN).unwrap();
    let at = |x: f64| PortSample::starting(1e-3, x, 0.0);
    assert_eq!(damper.decrease(&at(0.1)), 0.0);
    assert_abs_diff_eq!(damper.decrease(&at(0.101)), -2.0 * 1e-3, epsilon = 1e-15);
    // A sample with a NaN is passed over, and the next one spans it.
    let missed = PortSample { work: f64::NAN, ..at(0.2) };
    assert_eq!(damper.decrease(&missed), 0.0);
    assert_abs_diff_eq!(damper.decrease(&at(0.102)), -2.0 * 1e-3, epsilon = 1e-15);
}
