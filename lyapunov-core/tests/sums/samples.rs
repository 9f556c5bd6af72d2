//! Samples, corrections and the credit of a damper.

use lyapunov_core::{
    Always, Correction, Dissipation, Gate, HeldTick, InContact, LyapunovCandidate, PortSample,
};
use nalgebra::Vector3;

type Sample = PortSample<Vector3<f64>>;

fn sample() -> Sample {
    let [position, velocity, displacement, applied] =
        [1.0, 2.0, 3.0, 4.0].map(|size| Vector3::new(size, -size, 0.5 * size));
    HeldTick { period: 0.25, position, velocity, displacement, applied }.sample()
}

#[test]
fn work_is_force_times_way_axis_by_axis() {
    let Sample { period, position, velocity, displacement, applied, work } = sample();
    assert_eq!(work, Vector3::new(12.0, 12.0, 3.0));
    assert_eq!(
        (period, position.x, velocity.x, displacement.x, applied.x),
        (0.25, 1.0, 2.0, 3.0, 4.0)
    );
    let none = Vector3::zeros();
    let start = PortSample { displacement: none, applied: none, work: none, ..sample() };
    assert_eq!(Sample::starting(0.25, position, velocity), start);
    let nothing = Sample { period: 0.0, position: none, velocity: none, ..start };
    assert_eq!(Sample::default(), nothing);
}

/// Of two samples times, ways and works add up, and the rest is the later one's.
#[test]
fn a_gap_is_spanned_by_sums() {
    let four = sample().work * 4.0;
    let earlier = Sample { period: 2.0, work: four, ..Sample::default() };
    let earlier = Sample { displacement: sample().position, ..earlier };
    let expected = Sample {
        period: 2.25,
        displacement: Vector3::new(4.0, -4.0, 2.0),
        work: Vector3::new(60.0, 60.0, 15.0),
        ..sample()
    };
    assert_eq!(sample().spanning(&earlier), expected);
    assert_eq!(sample().spanning(&Sample::default()), sample());
}

/// One number that is not finite in any field, on any axis.
#[test]
fn one_bad_number_is_noticed() {
    assert!(sample().finite() && sample().sound() && sample().timed());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            for field in 0..5 {
                let mut it = sample();
                let fields = [
                    &mut it.position,
                    &mut it.velocity,
                    &mut it.displacement,
                    &mut it.applied,
                    &mut it.work,
                ];
                fields.into_iter().nth(field).expect("a field")[axis] = bad;
                assert!(!it.finite() && !it.sound() && it.timed(), "{it:?}");
            }
        }
        let untimed = Sample { period: bad, ..sample() };
        assert!(!untimed.finite() && !untimed.timed() && !untimed.sound());
    }
    for period in [0.0, -0.0, -1e-3] {
        let untimed = Sample { period, ..sample() };
        assert!(untimed.finite() && !untimed.timed() && !untimed.sound());
    }
}

#[test]
fn corrections_that_differ_in_one_number_are_not_the_same() {
    let one =
        Correction { observed_energy: 2.0, alpha: 3.0, shortfall: 4.0, ..Correction::none(1.0) };
    assert!(one == one.checked() && one.accepted && one != Correction::default());
    assert_eq!(Correction::default(), Correction::none(0.0));
    for other in [
        Correction { effort: 0.0, ..one },
        Correction { observed_energy: 0.0, ..one },
        Correction { alpha: 0.0, ..one },
        Correction { shortfall: 0.0, ..one },
        Correction { accepted: false, ..one },
    ] {
        assert_ne!(one, other);
    }
    // A bad effort gives none and no damping; what was observed stays. What was rejected stays rejected.
    let spoilt = Correction { effort: f64::NAN, ..one };
    let expected = Correction { effort: 0.0, alpha: 0.0, accepted: false, ..one };
    assert_eq!(spoilt.checked(), expected);
    assert_eq!(expected.checked(), expected);
    assert_eq!(Correction { accepted: false, ..spoilt }.checked(), expected);
}

/// `b v² T` while the gate is open and the number is one.
#[test]
fn a_damper_credits_what_it_burns() {
    let mut device = Dissipation::of(3.0).expect("a damping");
    assert_eq!(device.damping(), 3.0);
    assert_eq!(device.decrease(&sample()), 3.0 * (4.0 + 4.0 + 1.0) * 0.25);
    let on_a_line = |position, velocity| PortSample::<f64>::starting(0.25, position, velocity);
    let mut wall = device.gated(InContact { position: 1.0 });
    let burnt = [(0.5, 2.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1e200), (0.5, 1e200), (2.0, f64::NAN)]
        .map(|(x, v)| wall.decrease(&on_a_line(x, v)));
    assert_eq!(burnt, [0.0, 0.0, 3.0, 0.0, 0.0, 0.0]);
    assert_eq!(wall.damping(), 3.0);
    assert!(Gate::<f64>::open(&Always, &on_a_line(0.0, 0.0)));
    assert!(Dissipation::of(0.0).is_ok());
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(Dissipation::of(bad).is_err());
    }
}
