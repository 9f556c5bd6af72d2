//! Bounds of plausible samples, from both sides.

use lyapunov::{
    Correction, Dissipation, Lolc, PortSample, Stabilizer,
    stabilizers::{Plausibility, StabilizerExt},
};

use crate::support::{limit, popc};

/// Each bound by itself: what is as large as it passes, and the next number beyond is refused, of either sign.
#[test]
fn a_bound_is_the_largest_that_passes() {
    // Of these the reach of a tick is 2 m and the most work 32 J.
    let (speed, effort, period) = (8.0, 16.0, 0.25);
    let member = popc::<f64>().plausible(Plausibility { speed, effort }).expect("limits");
    let rest = PortSample::starting(period, 0.0, 0.0);
    let with = |field: &str, size: f64| {
        let (mut sample, mut effort) = (rest, 0.0);
        *match field {
            "velocity" => &mut sample.velocity,
            "displacement" => &mut sample.displacement,
            "applied" => &mut sample.applied,
            "work" => &mut sample.work,
            _ => &mut effort,
        } = size;
        (sample, effort)
    };
    let bounds = [
        ("velocity", 8.0),
        ("displacement", 2.0),
        ("applied", 16.0),
        ("work", 32.0),
        ("asked", 16.0),
    ];
    for (field, most) in bounds {
        for size in [most, -most, f64::next_up(most), -f64::next_up(most)] {
            let (sample, asked) = with(field, size);
            let told = member.clone().stabilize(&sample, asked);
            let passes = size.abs() == most;
            let booked = if passes { sample.work } else { 0.0 };
            assert_eq!(
                (told.accepted, told.observed_energy),
                (passes, booked),
                "{field} of {size}"
            );
        }
    }
}

/// An account of the velocity alone is not blinded either, by whatever field is absurd.
#[test]
fn an_account_that_sees_no_work_books_nothing_absurd() {
    let burns = Lolc::new(Dissipation::of(1.0).expect("a damping"), limit());
    let mut member = burns.plausible(Plausibility { speed: 8.0, effort: 16.0 }).expect("limits");
    let moving = PortSample::starting(0.25, 0.0, 2.0);
    let absurd = [
        PortSample { velocity: 9.0, ..moving },
        PortSample { displacement: 3.0, ..moving },
        PortSample { applied: 17.0, ..moving },
    ];
    for sample in absurd {
        let told = member.stabilize(&sample, 0.0);
        assert_eq!((told.accepted, told.observed_energy), (false, 0.0), "{sample:?}");
    }
    // 1 N·s/m at 2 m/s for a quarter of a second.
    assert_eq!(member.stabilize(&moving, 0.0).observed_energy, 1.0);
}

/// Limits that are changed hold from the next tick on; refused ones change nothing.
#[test]
fn changed_limits_hold() {
    let limits = |speed| Plausibility { speed, effort: 16.0 };
    let mut member = popc::<f64>().plausible(limits(8.0)).expect("limits");
    let moving = PortSample::starting(0.25, 0.0, 6.0);
    for (speed, passes) in [(5.0, false), (7.0, true)] {
        member.set_plausibility(limits(speed)).expect("limits");
        assert!(member.set_plausibility(limits(f64::NAN)).is_err());
        assert_eq!(member.plausibility(), limits(speed));
        assert_eq!(member.stabilize(&moving, 0.0).accepted, passes, "{speed} m/s");
    }
}

/// One number of what a stabilizer is given.
type Number = fn(&PortSample<f64>, f64) -> f64;

/// Stabilizer that answers with one number of what it sees.
struct Echo(Number);

impl Stabilizer<f64> for Echo {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        Correction { effort: (self.0)(sample, effort), accepted: true, ..Correction::default() }
    }
}

impl StabilizerExt for Echo {}

/// Numbers that no device resolves are 0 inside, of either sign; the next number is seen, and a NaN stays one.
#[test]
fn what_nothing_resolves_is_zero() {
    let least = f64::powi(2.0, -51);
    let limits = Plausibility { speed: 8.0, effort: 16.0 };
    let fields: [(Number, f64); 4] = [
        (|sample, _| sample.velocity, least),
        (|sample, _| sample.displacement, least),
        (|sample, _| sample.applied, least),
        (|sample, _| sample.work, least * least),
    ];
    for (field, least) in fields {
        let mut member = Echo(field).plausible(limits).expect("limits");
        let mut seen = |size: f64| {
            let rest = PortSample::starting(0.25, size, size);
            let sample = PortSample { displacement: size, applied: size, work: size, ..rest };
            member.stabilize(&sample, 0.0).effort
        };
        let beneath = f64::next_down(least);
        let sizes = [least, -least, beneath, -beneath, 5e-324];
        assert_eq!(sizes.map(&mut seen), [least, -least, 0.0, 0.0, 0.0]);
        assert!(seen(f64::NAN).is_nan());
    }
    let mut member = Echo(|sample, _| sample.period).plausible(limits).expect("limits");
    for (period, seen) in [(least, least), (f64::next_down(least), 0.0)] {
        let rest = PortSample::starting(period, 0.0, 0.0);
        assert_eq!(member.stabilize(&rest, 0.0).effort, seen);
    }
}

/// An effort that is plausible passes with its bits, the sign of 0 too.
#[test]
fn a_plausible_effort_keeps_its_bits() {
    let limits = Plausibility { speed: 8.0, effort: 16.0 };
    let mut member = Echo(|_, effort| effort).plausible(limits).expect("limits");
    let rest = PortSample::starting(0.25, 0.0, 0.0);
    for asked in [0.0, -0.0, 16.0, -5e-324] {
        assert_eq!(member.stabilize(&rest, asked).effort.to_bits(), f64::to_bits(asked));
    }
}
