//! Time trajectory of an added damping, at a port that moves steadily and on which nothing else acts.

use approx::relative_eq;
use lyapunov::{HeldTick, PortSample, Signal, Stabilizer, stabilizers::StabilizerExt};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD, popc};

const SPEED: f64 = 0.1;

/// The energies burnt on each tick after a debt of `debt`, J.
fn payments(mut stabilizer: impl Stabilizer<f64>, debt: f64) -> Vec<f64> {
    let moved = SPEED * PERIOD;
    let mut sample = PortSample {
        work: -debt,
        ..HeldTick {
            period: PERIOD,
            position: 0.0,
            velocity: SPEED,
            displacement: moved,
            applied: 0.0,
        }
        .sample()
    };
    (0..20)
        .map(|_| {
            let effort = stabilizer.stabilize(&sample, 0.0).effort;
            sample = HeldTick {
                period: PERIOD,
                position: 0.0,
                velocity: SPEED,
                displacement: moved,
                applied: effort,
            }
            .sample();
            effort * moved
        })
        .collect()
}

#[test]
fn a_debt_is_paid_in_equal_parts() {
    let paid = payments(popc().spread_over(8).expect("ticks"), 4e-5);
    for (tick, paid) in paid.into_iter().enumerate() {
        assert!(
            relative_eq!(
                paid,
                if tick < 8 { 5e-6 } else { 0.0 },
                epsilon = 1e-18,
                max_relative = 1e-12
            ),
            "{paid:e} on tick {tick}"
        );
    }
}

/// `j / N` of what is left: 1/4, then 2/4 of 3/4, then 3/4 of 3/8, then the rest.
#[test]
fn a_correction_rises() {
    let paid = payments(popc().rising_over(4).expect("ticks"), 1e-5);
    for (paid, share) in paid.into_iter().zip([1.0 / 4.0, 3.0 / 8.0, 9.0 / 32.0, 3.0 / 32.0, 0.0]) {
        assert!(
            relative_eq!(paid, 1e-5 * share, epsilon = 1e-18, max_relative = 1e-12),
            "{paid:e}"
        );
    }
}

/// Without a limit 0.4 N at once; with 100 N/s, 0.1 N more on each tick until the debt is paid.
#[test]
fn a_correction_grows_no_faster_than_its_rate() {
    let paid = payments(popc().rate_limited(100.0).expect("a rate"), 4e-5);
    for (paid, newtons) in paid.into_iter().zip([0.1, 0.2, 0.1, 0.0]) {
        assert!(
            relative_eq!(paid, newtons * SPEED * PERIOD, epsilon = 1e-18, max_relative = 1e-12),
            "{paid:e}"
        );
    }
}

#[test]
fn on_no_axis_faster_and_never_along_the_motion() {
    let mut limited = popc().rate_limited(200.0).expect("a rate");
    let (mut dice, mut last) = (Dice::of(8), Vector3::<f64>::zeros());
    for _ in 0..5000 {
        let velocity: Vector3<f64> = dice.signal(0.2);
        let sample = PortSample {
            work: dice.signal(1e-4),
            ..HeldTick {
                period: PERIOD,
                position: Vector3::zeros(),
                velocity,
                displacement: velocity * PERIOD,
                applied: Vector3::zeros(),
            }
            .sample()
        };
        let effort: Vector3<f64> = dice.signal(5.0);
        let added = limited.stabilize(&sample, effort).effort - effort;
        for axis in 0..3 {
            let (now, before) = (added[axis], last[axis]);
            assert!(now.abs() <= before.abs() + 0.2 + 1e-12);
            assert!(now * before > 0.0 || now.abs() <= 0.2 + 1e-12);
            assert!(now * velocity[axis] >= -1e-12);
        }
        last = added;
    }
}

#[test]
fn below_the_threshold_a_debt_waits() {
    let mut popc = popc().above_velocity(0.05).expect("a threshold");
    let still =
        |velocity: f64| PortSample { work: -1e-5, ..PortSample::starting(PERIOD, 0.0, velocity) };
    for tick in 1..=3 {
        let correction = popc.stabilize(&still(0.049), 1.0);
        assert_eq!((correction.effort, correction.alpha), (1.0, 0.0));
        assert!(relative_eq!(
            correction.shortfall,
            1e-5 * f64::from(tick),
            epsilon = 1e-18,
            max_relative = 1e-12
        ));
    }
    let correction = popc.stabilize(&still(-0.05), 1.0);
    assert!(correction.effort < 1.0 && correction.shortfall == 0.0);
    assert!(relative_eq!(
        (correction.effort - 1.0) * -0.05 * PERIOD,
        4e-5,
        epsilon = 1e-18,
        max_relative = 1e-12
    ));
    assert!(Signal::finite(correction.observed_energy));
}
