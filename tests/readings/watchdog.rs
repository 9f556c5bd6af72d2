//! The watchdog: holding, letting go, coming back.

use lyapunov::{
    Correction, DampingLimit, Lolc, Popc, PortEnergy, PortSample, Sampled, Scalar, Stabilizer,
    laws::{self, Samples},
    stabilizers::{NoStabilizer, StabilizerExt, Watchdog, WatchdogTimes},
};

use super::support::{PERIOD, reading, readings};

fn popc() -> Popc<f64> {
    Lolc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, PERIOD).expect("a limit"))
}

fn watched<S: StabilizerExt>(stabilizer: S, hold: f64, rise: f64) -> Watchdog<S, f64> {
    stabilizer.watched(WatchdogTimes { hold: hold * PERIOD, rise: rise * PERIOD }).expect("times")
}

fn still(position: f64) -> PortSample<f64> {
    PortSample::starting(PERIOD, position, 0.0)
}

/// The efforts of `stabilizer` where `Some` effort is asked or no reading came.
fn efforts(mut stabilizer: impl Stabilizer<f64>, asked: &[Option<f64>]) -> Vec<f64> {
    let mut readings = readings::<f64>();
    let mut tick = |asked: &Option<f64>| {
        let checked = match asked {
            Some(_) => readings.read(reading(0.0, 0.0)),
            None => readings.missed(0.0),
        };
        let correction = stabilizer.stabilize(&checked.sample, asked.unwrap_or(123.0));
        assert_eq!(correction.accepted, asked.is_some());
        correction.effort
    };
    asked.iter().map(&mut tick).collect()
}

/// It holds through the stated time and not longer, whatever the stabilizer inside accepts.
#[test]
fn it_holds_and_lets_go() {
    let asked = [Some(5.0), None, None, None, None, Some(6.0), None];
    let expected = [5.0, 5.0, 5.0, 5.0, 0.0, 6.0, 6.0];
    assert_eq!(efforts(watched(popc(), 3.0, 0.0), &asked), expected);
    let sampled: Popc<f64, Sampled> = popc().sampled();
    assert_eq!(efforts(watched(sampled, 3.0, 0.0), &asked), expected);
    assert_eq!(efforts(watched(popc(), 0.0, 0.0), &asked), [5.0, 0.0, 0.0, 0.0, 0.0, 6.0, 0.0]);
    let for_ever = popc().watched::<f64>(WatchdogTimes { hold: f64::INFINITY, rise: 0.0 });
    assert_eq!(efforts(for_ever.expect("times"), &asked), [5.0, 5.0, 5.0, 5.0, 5.0, 6.0, 6.0]);
}

/// The effort rises in proportion to the time at the start and after it let go, and not after a short gap.
#[test]
fn it_rises_at_the_start_and_after_letting_go() {
    let asked = [8.0; 3].map(Some).into_iter();
    let asked = asked.chain([None; 1]).chain([8.0; 3].map(Some)).chain([None; 3]);
    let asked: Vec<_> = asked.chain([8.0; 2].map(Some)).collect();
    let expected = [2.0, 4.0, 6.0, 6.0, 8.0, 8.0, 8.0, 8.0, 8.0, 0.0, 2.0, 4.0];
    assert_eq!(efforts(watched(popc(), 2.0, 4.0), &asked), expected);
}

/// Damping does not wait for the rise.
#[test]
fn a_correction_is_not_reduced() {
    let (mut plain, mut rising) = (popc(), watched(popc(), 0.0, 1000.0));
    let velocity = 0.1;
    let displacement = velocity * PERIOD;
    let debt = PortSample { velocity, displacement, work: -2e-4, ..still(0.0) };
    let (one, other) = (plain.stabilize(&debt, 0.0), rising.stabilize(&debt, 0.0));
    assert!(one.alpha > 0.0);
    assert_eq!(one, other);
}

/// A tick of unknown length ends the hold at once; so does a stabilizer that rejects for longer.
#[test]
fn an_unknown_time_ends_the_hold() {
    let mut dog = watched(popc(), 1e6, 0.0);
    dog.stabilize(&still(0.0), 5.0);
    let rejected: Correction<f64> = dog.stabilize(&still(0.0), f64::NAN);
    assert!(!rejected.accepted && rejected.effort == 5.0);
    for period in [f64::NAN, f64::INFINITY, -1.0] {
        let timeless = PortSample { period, work: f64::NAN, ..still(0.0) };
        assert_eq!({ dog }.stabilize(&timeless, 5.0).effort, 0.0, "{period}");
    }
}

/// A hold of so many periods is one of so many ticks, whatever they sum to.
#[test]
fn a_hold_lasts_as_many_ticks_as_it_has_periods() {
    fn held<T: Scalar>(ticks: u16) -> u16 {
        let period = T::of(1e-3);
        let times = WatchdogTimes { hold: T::of(f64::from(ticks) * 1e-3), rise: T::of(0.0) };
        let mut dog = NoStabilizer.watched::<T>(times).expect("times");
        let sound = PortSample::starting(period, T::of(0.0), T::of(0.0));
        let unsound = PortSample { work: T::of(f64::NAN), ..sound };
        dog.stabilize(&sound, T::of(5.0));
        let efforts = (0..ticks + 3).map(|_| dog.stabilize(&unsound, T::of(0.0)).effort.lane(0));
        efforts.map(|effort| u16::from(effort == 5.0)).sum()
    }
    for ticks in 0..1000 {
        assert_eq!(held::<f64>(ticks), ticks);
        assert_eq!(held::<f32>(ticks), ticks);
    }
}

/// Times of 0 change no bit of a sound run, and the laws stay.
#[test]
fn it_is_neutral_without_times() {
    let (mut plain, mut dog) = (popc(), watched(popc(), 0.0, 0.0));
    for (sample, effort) in Samples::<f64>::new(PERIOD).seeded(9) {
        let (one, other) = (plain.stabilize(&sample, effort), dog.stabilize(&sample, effort));
        assert_eq!(one, other);
        assert_eq!(one.effort.to_bits(), other.effort.to_bits());
    }
    laws::stabilizer(&watched(popc(), 5.0, 0.0), Samples::<f64>::new(PERIOD)).expect("the laws");
    laws::ledger(&watched(popc(), 5.0, 0.0), &PortEnergy, 0.5 * 0.2 / PERIOD, Samples::new(PERIOD))
        .expect("the ledger");
}

/// A held effort is booked when the readings come back: the port's energy is that of the run without a gap.
#[test]
fn a_held_effort_is_booked() {
    let path: Vec<f64> = (0..12).map(|tick| f64::from(tick * tick) / 4096.0).collect();
    let (mut dog, mut readings) = (watched(popc(), 5.0, 0.0), readings::<f64>());
    let (mut applied, mut truth, mut told) = (0.0, 0.0, 0.0);
    for (tick, &position) in path.iter().enumerate() {
        if tick > 0 {
            truth += applied * (position - path[tick - 1]);
        }
        let checked = if (4..8).contains(&tick) {
            readings.missed(applied)
        } else {
            readings.read(reading(position, applied))
        };
        let correction = dog.stabilize(&checked.sample, 512.0 * checked.sample.position);
        applied = correction.effort;
        if checked.accepted {
            told = correction.observed_energy;
            assert_eq!(told, truth, "tick {tick}");
        }
    }
    assert!(told > 0.0);
}

#[test]
fn times_are_checked() {
    let refused = |hold, rise| {
        NoStabilizer.watched::<f64>(WatchdogTimes { hold, rise }).expect_err("bad").parameter
    };
    for bad in [-1.0, f64::NAN] {
        assert_eq!(refused(bad, 0.0), "watchdog hold");
        assert_eq!(refused(0.0, bad), "watchdog rise");
    }
    assert_eq!(refused(0.0, f64::INFINITY), "watchdog rise");
}
