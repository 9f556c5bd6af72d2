//! Readings of poses: first tick, gaps, jumps of either part, velocities, fallback and ramp.

use lyapunov::{
    CheckedSample, DampingLimit, MovingReading, Popc, PortEnergy, Reading, Readings, Scalar,
    Signal, Snapshot, Stabilizer,
    poses::{Axes, BodyAxes, Pose, Screw, WithPose, WorldAxes},
    readings::PartSpeeds,
    stabilizers::{StabilizerExt, WatchdogTimes},
};
use nalgebra::{Isometry3, Vector3};

use crate::support::{Dice, Real, pose};

const PERIOD: f64 = 1e-3;

/// Fastest motion of the tests: 2 mm and 0.02 rad a tick.
fn fastest<T: Scalar>() -> PartSpeeds<T> {
    PartSpeeds { translation: T::of(2.0), rotation: T::of(20.0) }
}

fn turned(angle: f64) -> Pose<f64> {
    Pose::from(Isometry3::rotation(Vector3::new(0.0, 0.6, 0.8) * angle))
}

fn wrench(force: f64, torque: f64) -> WithPose<f64> {
    WithPose::of(Screw::new(Vector3::x() * force, Vector3::new(0.0, 0.6, 0.8) * torque))
}

/// The numbers of a sample's screws.
fn screws<T: Scalar, F: Axes>(checked: &CheckedSample<WithPose<T, F>>) -> [Screw<T, F>; 3] {
    let sample = &checked.sample;
    [sample.displacement.screw, sample.velocity.screw, sample.work.screw]
}

/// The first reading displaces nothing, wherever and however the body stands.
#[test]
fn the_first_reading_displaces_nothing() {
    let mut readings = Readings::every(PERIOD).expect("a period").of_poses();
    let away = Pose::from(Isometry3::new(Vector3::new(0.3, -2.0, 1.0), Vector3::x() * 3.0));
    let first = readings.read(Reading { position: away, applied: wrench(5.0, 1.0) });
    assert!(first.accepted && !first.jumped && !first.late);
    assert_eq!(screws(&first), [Screw::<f64, WorldAxes>::default(); 3]);
    assert_eq!(first.sample.position, WithPose::at(away));
}

/// Samples are those of a model that remembers poses: displacements lead from the last accepted pose, a gap is spanned,
/// its work is that of the wrench that was held, and what cannot be is rejected.
fn follow_the_last_accepted_pose<T: Real, F: Axes>(seed: u64) {
    let of = T::of;
    let mut dice = Dice::of(seed);
    let mut readings =
        Readings::every(of(PERIOD)).expect("a period").of_poses().no_faster_than(fastest());
    let readings = readings.as_mut().expect("speeds");
    let (mut at, mut last, mut ticks) = (dice.pose::<T>(), None::<Pose<T>>, 0);
    let (mut sum, mut rejected) = (Screw::<T, F>::default(), 0);
    let applied = WithPose::of(dice.screw::<T, F>(10.0, 2.0));
    for _ in 0..2000 {
        // Within half of the fastest motion on each tick, so that only what is spoilt is rejected.
        at = dice.screw::<T, WorldAxes>(5e-4, 5e-3).moving(&at);
        ticks += 1;
        let told = match (10.0 * dice.within(1.0)) as i32 {
            _ if last.is_none() => at,
            6 => Pose::at(Vector3::new(of(f64::NAN), of(0.0), of(0.0))),
            7 => pose(Vector3::zeros(), [0.0; 4]),
            8 => dice.screw::<T, WorldAxes>(9.0, 0.0).moving(&at),
            9 => Screw::<T, WorldAxes>::new(Vector3::zeros(), Vector3::x() * of(1.0)).moving(&at),
            _ => at,
        };
        let checked = readings.read(Reading { position: told, applied });
        assert_eq!(checked.accepted, told == at);
        if !checked.accepted {
            rejected += 1;
            assert_eq!(checked.sample.displacement, WithPose::default());
            assert!(!checked.sample.finite());
            continue;
        }
        let moved = last.map_or(Screw::default(), |last| Screw::<T, F>::between(&last, &told));
        let span = of(f64::from(ticks) * PERIOD);
        let size = |screw: Screw<T, F>| -> f64 { screw.inner(screw).sqrt().into() };
        let near = |one: Screw<T, F>, other: Screw<T, F>, scale: f64| {
            let off = size(one - other);
            assert!(off <= 64.0 * T::epsilon().into() * scale, "{off:e}");
        };
        let [displacement, velocity, work] = screws(&checked);
        sum = sum + moved;
        let reach = 1.0 + size(sum);
        near(displacement, moved, reach);
        near(velocity, moved.scale(of(1.0) / span), reach / span.into());
        near(work, applied.screw.times(moved), 20.0 * reach);
        near(checked.sample.position.screw, sum, 2000.0 * reach);
        assert_eq!(checked.late, ticks > 1);
        (last, ticks) = (Some(told), 0);
    }
    assert!(rejected > 100, "{rejected}");
}

#[test]
fn samples_follow_the_last_accepted_pose() {
    for seed in 1..6 {
        follow_the_last_accepted_pose::<f64, WorldAxes>(seed);
        follow_the_last_accepted_pose::<f64, BodyAxes>(seed);
        follow_the_last_accepted_pose::<f32, WorldAxes>(seed);
        follow_the_last_accepted_pose::<f32, BodyAxes>(seed);
    }
}

/// The parts have limits of their own, and share none.
#[test]
fn either_part_may_jump() {
    let jumps = |along: f64, about: f64, speeds: PartSpeeds<f64>| {
        let readings = Readings::every(PERIOD).expect("a period").of_poses();
        let mut readings = readings.no_faster_than(speeds).expect("speeds");
        let applied = WithPose::<f64>::default();
        readings.read(Reading { position: turned(1.0), applied });
        let at = Pose::new(Vector3::x() * along, turned(1.0 + about).orientation());
        readings.read(Reading { position: at, applied }).jumped
    };
    assert!(!jumps(1.9e-3, 0.019, fastest()));
    assert!(jumps(2.1e-3, 0.0, fastest()) && jumps(0.0, 0.021, fastest()));
    let free = PartSpeeds { rotation: f64::INFINITY, ..fastest() };
    assert!(!jumps(0.0, 3.0, free) && jumps(2.1e-3, 0.0, free));
    let readings = Readings::<WithPose<f64>>::every(PERIOD).expect("a period").of_poses();
    for bad in [0.0, -1.0, f64::NAN] {
        let turning = PartSpeeds { rotation: bad, ..fastest() };
        let refused = readings.no_faster_than(turning).expect_err("no speed");
        assert_eq!(refused.parameter, "fastest rotation");
    }
}

/// A reading without a direction is no start: the next sound one is.
#[test]
fn a_start_must_be_sound() {
    let mut readings = Readings::every(PERIOD).expect("a period").of_poses();
    let none = wrench(0.0, 0.0);
    for bad in [pose(Vector3::zeros(), [0.0; 4]), Pose::at(Vector3::x() * f64::INFINITY)] {
        assert!(!readings.read(Reading { position: bad, applied: none }).accepted);
    }
    let first = readings.read(Reading { position: turned(2.0), applied: none });
    assert!(first.accepted && first.sample.displacement == WithPose::default());
    let next = readings.read(Reading { position: turned(2.01), applied: none }).sample;
    assert!((next.displacement.screw.rotation.norm() - 0.01).abs() < 1e-15);
    readings.restart(); // put down and taken up elsewhere
    let next = readings.read(Reading { position: turned(-1.0), applied: none }).sample;
    assert_eq!(next.displacement.screw, Screw::default());
}

/// A torque held while the body turns by a known angle about it does the torque times the angle, over ticks and gaps.
#[test]
fn held_work_is_torque_times_angle() {
    let mut readings = Readings::every(PERIOD).expect("a period").of_poses();
    let (mut sum, mut applied) = (0.0, wrench(0.0, 0.0));
    for tick in 0..=1000 {
        let position = turned(0.01 * f64::from(tick));
        let told = if tick % 7 == 3 {
            readings.missed(applied)
        } else {
            readings.read(Reading { position, applied })
        };
        sum += if told.accepted { told.sample.work.sum() } else { 0.0 };
        applied = wrench(0.0, 0.5);
    }
    assert!((sum - 0.5 * 10.0).abs() < 1e-12, "{sum}");
}

/// Velocities that are measured, windowed or at the times of a clock.
#[test]
fn every_velocity_and_clock_serves_poses() {
    let rate = |sample: &lyapunov::PortSample<WithPose<f64>>| sample.velocity.screw.rotation.norm();
    let plain = Readings::every(PERIOD).expect("a period").of_poses();
    let mut measured = plain.measured();
    let mut windowed = plain.windowed::<8>(8, 1e-9).expect("a window");
    let mut clocked = plain.clocked();
    let (none, twist) = (wrench(0.0, 0.0), wrench(0.0, 3.0));
    for tick in 0..20 {
        let position = turned(0.01 * f64::from(tick));
        let told = measured.read_moving(MovingReading { position, velocity: twist, applied: none });
        assert!((rate(&told.sample) - 3.0).abs() < 1e-12);
        let reading = Reading { position, applied: none };
        let [one, other] =
            [windowed.read(reading), clocked.read_at(2e-3 * f64::from(tick), reading)];
        if tick > 0 {
            assert!(
                (rate(&one.sample) - 10.0).abs() < 1e-9 && (rate(&other.sample) - 5.0).abs() < 1e-9
            );
        }
    }
}

/// Behind readings of poses a watchdog holds the wrench, lets go, and lets the environment rise again.
#[test]
fn a_watchdog_holds_and_raises_wrenches() {
    let popc = Popc::new(PortEnergy, DampingLimit::at(1.0).expect("a limit"));
    let times = WatchdogTimes { hold: 2.0 * PERIOD, rise: 4.0 * PERIOD };
    let mut popc = popc.watched::<WithPose<f64>>(times).expect("times");
    let mut readings = Readings::every(PERIOD).expect("a period").of_poses();
    let mut efforts = Vec::new();
    for heard in [true, true, true, true, false, false, false, true, true] {
        let applied =
            efforts.last().map_or(WithPose::default(), |&(force, torque)| wrench(force, torque));
        let told = if heard {
            readings.read(Reading { position: turned(0.5), applied })
        } else {
            readings.missed(applied)
        };
        let effort = popc.stabilize(&told.sample, wrench(8.0, 4.0)).effort.screw;
        efforts.push((effort.translation.x, effort.rotation.norm().round()));
    }
    let expected = [2.0, 4.0, 6.0, 8.0, 8.0, 8.0, 0.0, 2.0, 4.0].map(|force| (force, force / 2.0));
    assert_eq!(efforts, expected);
}

/// What was stored in the middle goes on to the bit.
#[test]
fn a_snapshot_goes_on() {
    let mut dice = Dice::of(9);
    let fresh = Readings::every(1e-3_f32).expect("a period").of_poses().low_passed(40.0);
    let fresh = fresh.expect("a cutoff");
    let (mut running, mut at) = (fresh, dice.pose::<f32>());
    let mut resumed = None;
    for tick in 0..400 {
        at = dice.screw::<f32, WorldAxes>(1e-4, 1e-3).moving(&at);
        let applied = WithPose::of(dice.screw::<f32, BodyAxes>(5.0, 1.0));
        if tick == 137 {
            let mut bytes = Vec::new();
            ciborium::into_writer(&running.state(), &mut bytes).expect("it is written");
            let state = ciborium::from_reader(&bytes[..]).expect("it is read");
            resumed = Some(fresh.restored(state).expect("a state"));
        }
        let reading = Reading { position: at, applied };
        let told = if tick % 11 == 5 { running.missed(applied) } else { running.read(reading) };
        if let Some(resumed) = &mut resumed {
            let again =
                if tick % 11 == 5 { resumed.missed(applied) } else { resumed.read(reading) };
            assert_eq!(format!("{again:?}"), format!("{told:?}"));
        }
    }
}

/// Nothing could be counted from a quaternion of 0, or from one whose squares are: each pose after it would be refused for good.
#[test]
fn a_stored_pose_that_is_none_is_refused() {
    let readings = Readings::every(1e-3).expect("a period").of_poses();
    let mut begun = readings;
    begun.read(Reading { position: turned(0.1), applied: wrench(0.0, 0.0) });
    let ((known, mut place, gap, least, most), velocity, clock, track) = begun.state();
    assert!(readings.restored(begun.state()).is_ok());
    let sound = place.pose;
    for size in [0.0, 1e-200] {
        place.pose = sound.scale(size);
        let state = |known| ((known, place, gap, least, most), velocity, clock, track);
        let error = readings.restored(state(known)).expect_err("no pose");
        assert_eq!(error.parameter, "size of a stored quaternion");
        assert!(error.value <= 2.0 * size, "{error}");
        assert!(readings.restored(state(0.0)).is_ok()); // the pose is not looked at
    }
}
