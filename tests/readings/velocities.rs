//! Velocities of readings: those of the adaptors of a port, and the laws.

use lyapunov::{
    OnePort, PortSample, Reading, Readings,
    effects::OnePortExt,
    laws::{self, Law},
    readings::{Differenced, LowPassed, VelocityEstimator, Windowed},
};

use crate::support::{PERIOD, reading, readings};

/// A port that keeps the velocity it is told.
struct Told(f64);

impl OnePort<f64> for &mut Told {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        self.0 = sample.velocity;
        0.0
    }
}

fn path(tick: i32) -> f64 {
    (0.02 * (0.21 * f64::from(tick)).sin() / 1e-4).round() * 1e-4
}

/// Without gaps every estimator gives the velocities of the port's adaptor of the same name, to the bit.
#[test]
fn they_are_those_of_the_adaptors() {
    let [mut differenced, mut low_passed, mut windowed] = [Told(0.0), Told(0.0), Told(0.0)];
    let mut by_difference = readings::<f64>();
    let mut by_low_pass = by_difference.low_passed(30.0).expect("a cutoff");
    let mut by_window = by_difference.windowed::<12>(9, 1e-4).expect("a window");
    let mut last = path(0);
    let mut ports: [Box<dyn OnePort<f64>>; 3] = [
        Box::new((&mut differenced).differenced()),
        Box::new((&mut low_passed).low_passed(30.0).expect("a cutoff")),
        Box::new((&mut windowed).windowed::<12>(9, 1e-4).expect("a window")),
    ];
    let mut told = Vec::new();
    for tick in 0..300 {
        let position = path(tick);
        let displacement = position - last;
        last = position;
        let sample =
            PortSample { displacement, ..PortSample::starting(PERIOD, position, f64::NAN) };
        for port in &mut ports {
            port.respond(&sample);
        }
        let now = reading(position, 0.0);
        let [a, b, c] = [by_difference.read(now), by_low_pass.read(now), by_window.read(now)]
            .map(|checked| checked.sample.velocity);
        told.push([a, b, c]);
    }
    drop(ports);
    assert_eq!(told.last(), Some(&[differenced.0, low_passed.0, windowed.0]));
    assert!(told.iter().any(|[a, b, c]| a != b && a != c && b != c));
}

/// A straight motion has its velocity in every estimator after a gap, and after a late tick of the clock.
#[test]
fn a_gap_does_not_bend_a_straight_motion() {
    let speed = 0.5;
    let mut windowed = readings::<f64>().windowed::<8>(8, 1e-9).expect("a window");
    let mut clocked = readings::<f64>().windowed::<8>(8, 1e-9).expect("a window").clocked();
    let mut called = 0;
    for tick in 0..60 {
        let time = f64::from(tick) * PERIOD;
        let now = reading(speed * time, 0.0);
        let told = if tick % 7 == 3 { windowed.missed(0.0) } else { windowed.read(now) };
        let late = (tick % 7 != 3).then(|| clocked.read_at(time, now));
        for checked in [Some(told), late].into_iter().flatten() {
            if checked.accepted && tick > 0 {
                assert_eq!(checked.sample.velocity, speed, "tick {tick}");
                called += 1;
            }
        }
    }
    assert!(called > 90);
}

#[test]
fn the_estimators_keep_the_laws() {
    fn keeps<E: VelocityEstimator<f64> + Clone>(estimator: E) {
        let samples = laws::Samples::<f64>::new(1e-3);
        laws::velocity_estimator(&estimator, samples).expect("the laws");
    }
    keeps(Differenced);
    keeps(LowPassed::<f64>::new(40.0).expect("a cutoff"));
    keeps(Windowed::<f64, 16>::new(11, 1e-4).expect("a window"));
}

/// 1e37 Hz over 10 s is beyond the largest number of `f32`; such a filter passes everything.
#[test]
fn a_cutoff_beyond_the_range_filters_nothing() {
    let readings = Readings::<f32>::every(10.0).expect("a period");
    let mut readings = readings.low_passed(1e37).expect("a cutoff");
    for tick in 0..4u8 {
        let told = readings.read(Reading { position: f32::from(tick), applied: 0.0 });
        assert_eq!(told.sample.velocity, if tick == 0 { 0.0 } else { 0.1 });
    }
}

/// A filter that keeps a NaN is found.
#[test]
fn a_poisoned_filter_is_found() {
    #[derive(Clone)]
    struct Poisoned(f64);
    impl VelocityEstimator<f64> for Poisoned {
        fn velocity(&mut self, sample: &PortSample<f64>) -> f64 {
            self.0 += 0.1 * (sample.displacement / sample.period - self.0);
            self.0
        }

        fn restart(&mut self, _lanes: bool) {
            self.0 = 0.0;
        }
    }
    let found = laws::velocity_estimator(&Poisoned(0.0), laws::Samples::new(1e-3));
    assert_eq!(found.expect_err("a broken law").law, Law::Recovers);
}

/// A filter that does not forget is found.
#[test]
fn a_filter_that_does_not_restart_is_found() {
    #[derive(Clone)]
    struct Stubborn(f64);
    impl VelocityEstimator<f64> for Stubborn {
        fn velocity(&mut self, sample: &PortSample<f64>) -> f64 {
            let now = self.0 + 0.1 * (sample.displacement / sample.period - self.0);
            self.0 = if now.is_finite() { now } else { self.0 };
            self.0
        }

        fn restart(&mut self, _lanes: bool) {}
    }
    let found = laws::velocity_estimator(&Stubborn(0.0), laws::Samples::new(1e-3));
    assert_eq!(found.expect_err("a broken law").law, Law::NothingForNothing);
}
