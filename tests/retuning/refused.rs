//! States and changes that are refused.

use lyapunov::{
    Correction, OnePort, PortEnergy, PortSample, Snapshot,
    accumulators::{Compensated, Plain, Wide},
    candidates::InContact,
    environments::Spring,
    stabilizers::{
        Account, ForceBounding, NoStabilizer, PathMemory, SlopeBound, StabilizerExt, TwoLayer,
        WatchdogTimes, WindowedCredit,
    },
    telemetry::EnergyMeter,
};

use crate::support::{limit, popc};

#[test]
fn sums_that_are_not_finite_are_refused() {
    let popc = popc::<f64>();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(popc.restored(((), bad)).is_err());
        assert!(popc.summed_in::<Compensated<f64>>().restored(((), (1.0, bad))).is_err());
        let wide = lyapunov::Popc::<f32>::new(PortEnergy, limit());
        assert!(wide.summed_in::<Wide<f32>>().restored(((), bad)).is_err());
        assert!(popc.reset_at(InContact { position: 0.0 }).restored((((), bad), 1.0)).is_err());
    }
    let narrow = lyapunov::Popc::<f32>::new(PortEnergy, limit());
    assert!(narrow.summed_in::<Wide<f32>>().restored(((), 1e300)).is_err()); // no f32
}

#[test]
fn counters_out_of_range_are_refused() {
    let window = WindowedCredit::<f64, Plain<f64>, 4>::of_ticks(7).expect("one");
    let (sum, slots, slot, left) = window.state();
    assert!(window.restored((sum, slots, slot, left)).is_ok());
    assert!(window.restored((sum, slots, 4, left)).is_err());
    assert!(window.restored((sum, slots, slot, 8)).is_err());
    let windowed = lyapunov::Readings::<f64>::every(1e-3).expect("one").windowed::<8>(5, 1e-4);
    let windowed = windowed.expect("one");
    let (memory, (past, _), clock, track) = windowed.state();
    assert!(windowed.restored((memory, (past, 6), clock, track)).is_err());
}

/// Periods reach the time that was told or beyond it, where the clock stands.
#[test]
fn a_clock_that_is_behind_itself_is_refused() {
    let clocked = lyapunov::Readings::<f64>::every(1e-3).expect("one").clocked();
    let (memory, estimator, _, track) = clocked.state();
    let restored = |told, reached| {
        clocked.restored((memory, estimator, Some([told, reached]), track)).map(|_| ())
    };
    assert!(restored(10.0, 10.0).is_ok() && restored(10.0, 10.5).is_ok());
    let refused = restored(10.0, 0.0).expect_err("behind itself");
    assert_eq!((refused.parameter, refused.value), ("stored time reached", 0.0));
    for (told, reached) in [(f64::NAN, 0.0), (0.0, f64::NAN), (0.0, f64::INFINITY)] {
        assert!(restored(told, reached).is_err(), "{told} {reached}");
    }
}

#[test]
fn energies_and_forces_out_of_range_are_refused() {
    let slope = SlopeBound::<f64>::new(1e3).expect("one");
    assert!(slope.restored((f64::NAN, f64::NAN, 0.0)).is_err());
    assert!(slope.restored((f64::INFINITY, 0.0, 0.0)).is_err());
    let path = PathMemory::<f64, 4>::beyond(0.0, 1.0).expect("one");
    let (forces, _) = path.state();
    assert!(path.restored((forces, 1.0)).is_err());
    assert!(path.restored((-forces.add_scalar(1.0), 0.0)).is_err());
    let bound = ForceBounding::of_damping(0.1).and_then(|it| it.delayed::<4>(3)).expect("one");
    let (energy, costs) = bound.state();
    assert!(bound.restored((energy, costs.add_scalar(-1.0))).is_err());
    let sharing = lyapunov::stabilizers::Sharing { start: 0.0, share: 0.1 };
    let layer = TwoLayer::<f64>::slave(sharing).expect("one");
    assert!(layer.restored((0.0, -1.0, 0.0, 0.0)).is_err());
}

/// Memory that a part wrote itself is taken: a NaN that went through it spoils nothing later.
#[test]
fn a_memory_that_was_written_is_taken() {
    let unknown = PortSample::starting(1e-3, f64::NAN, 0.0);
    let sound = PortSample::starting(1e-3, 0.01, 0.0);
    let made = || Spring::new(500.0_f64).expect("a spring").stabilized(NoStabilizer);
    let mut port = made();
    assert!(port.respond(&unknown).is_nan());
    let mut again = made().restored(port.state()).expect("its own memory");
    assert!(OnePort::<f64>::correction(&again).effort.is_nan());
    assert_eq!(again.respond(&sound), 5.0);

    let mut meter = EnergyMeter::<f64>::new();
    for energy in [-3.0, f64::NAN] {
        meter.add(&sound, &Correction { observed_energy: energy, ..Correction::none(0.0) });
    }
    let mut again = EnergyMeter::new().restored(meter.state()).expect("its own memory");
    again.add(&sound, &Correction { observed_energy: 2.0, ..Correction::none(0.0) });
    let summary = again.summary();
    assert_eq!((summary.now, summary.least, summary.most), (2.0, -3.0, 2.0));
    let (ticks, sums, mut last) = meter.state();
    last[1] = f64::NEG_INFINITY;
    assert!(meter.restored((ticks, sums, last)).is_err());
}

/// A refused change leaves everything as it was.
#[test]
fn refused_changes_change_nothing() {
    let mut popc = popc::<f64>();
    popc.grant(1e308).expect("a credit");
    for bad in [-1.0, f64::NAN, f64::INFINITY, 1e308] {
        let refused = popc.grant(bad).expect_err("a bad credit");
        assert_eq!(refused.parameter, "granted credit");
        assert_eq!(refused.value.to_bits(), bad.to_bits(), "what was given");
        assert_eq!(popc.observed_energy(), 1e308);
    }
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(popc.owe(bad).expect_err("a bad debt").parameter, "debt carried over");
    }
    let mut deep = popc;
    deep.owe(1e308).and(deep.owe(1e308)).expect("room for both");
    let refused = deep.owe(1e308).expect_err("no room");
    assert_eq!((refused.value, deep.observed_energy()), (1e308, -1e308));
    let mut bounded = popc.bounded(1e-3).expect("one");
    assert!(bounded.set_most(-1.0).is_err() && bounded.most() == 1e-3);
    let mut limited = popc.rate_limited::<f64>(5.0).expect("one");
    assert!(limited.set_rate(f64::NAN).is_err() && limited.rate() == 5.0);
    let times = WatchdogTimes { hold: 1.0, rise: 2.0 };
    let mut dog = popc.watched::<f64>(times).expect("one");
    assert!(dog.set_times(WatchdogTimes { hold: 1.0, rise: f64::INFINITY }).is_err());
    assert_eq!(dog.times(), times);
    let mut readings = lyapunov::Readings::<f64>::every(1e-3).expect("one");
    assert!(readings.set_period(0.0).is_err() && readings.period() == 1e-3);
}
