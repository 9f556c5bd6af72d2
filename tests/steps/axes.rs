//! What several axes tell together, against closed forms.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, HeldTick, Mask, PortSample, Stabilizer,
    stabilizers::{Account, LimitCredit, NoStabilizer, PerAxis},
};
use nalgebra::Vector2;

use crate::support::{Dice, popc};

const PERIOD: f64 = 0.5; // s

/// A stabilizer that tells what it was made with, and keeps nothing.
#[derive(Clone, Copy)]
struct Says {
    energy: f64,
    alpha: f64,
    shortfall: f64,
}

impl Stabilizer<f64> for Says {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let Self { energy: observed_energy, alpha, shortfall } = *self;
        let effort = effort + sample.velocity * alpha;
        Correction { observed_energy, alpha, shortfall, ..Correction::none(effort) }.checked()
    }
}

fn at(x: f64, y: f64) -> PortSample<Vector2<f64>> {
    PortSample::starting(PERIOD, Vector2::zeros(), Vector2::new(x, y))
}

fn both(first: f64, second: f64) -> PerAxis<Says, 2> {
    PerAxis::of([first, second].map(|alpha| Says { energy: -alpha, alpha, shortfall: 2.0 * alpha }))
}

/// `Σ αᵢ vᵢ² / Σ vᵢ²`: 9 and 4 of 13 here, and never more than the largest of them.
#[test]
fn the_joined_damping_burns_what_the_axes_burn() {
    for (first, second, mean) in [(13.0, 0.0, 9.0), (0.0, 13.0, 4.0), (26.0, 13.0, 22.0)] {
        let told = both(first, second).stabilize(&at(3.0, -2.0), Vector2::new(1.0, 1.0));
        assert_relative_eq!(told.alpha, mean, max_relative = 1e-14);
        assert_eq!(told.effort, Vector2::new(1.0 + 3.0 * first, 1.0 - 2.0 * second));
        let most = f64::max(first, second);
        assert_eq!((told.observed_energy, told.shortfall), (-most, 2.0 * (first + second)));
    }
    let told = both(5.0, 5.0).stabilize(&at(0.3, 0.7), Vector2::zeros());
    assert_eq!((told.alpha, told.accepted), (5.0, true));
    // Two shortfalls beyond the range are told as the largest number, and squares that are not normal are no motion.
    let told = both(1e308, 1e308).stabilize(&at(1e-160, 1e-160), Vector2::zeros());
    assert_eq!((told.shortfall, told.alpha), (f64::MAX, 0.0));
    // v² is the smallest normal number here, and v² T is less.
    let told = both(9.0, 0.0).stabilize(&at(2f64.powi(-511), 0.0), Vector2::zeros());
    assert_eq!(told.alpha, 0.0);
    let told = both(9.0, 0.0).stabilize(&at(2f64.powi(-510), 0.0), Vector2::zeros());
    assert_eq!(told.alpha, 9.0);
}

/// A reader who multiplies `v²` by `T` first, then by `α`, finds no less than what the axes burnt.
#[test]
fn the_joined_damping_is_rounded_up() {
    let mut dice = Dice::of(5);
    for _ in 0..5000 {
        let [first, second] = [dice.within(9.0).abs(), dice.within(9.0).abs()];
        let [x, y] = [dice.within(2.0), dice.within(2.0)];
        let told = both(first, second).stabilize(&at(x, y), Vector2::zeros());
        let (along, across) = (x * x * PERIOD, y * y * PERIOD);
        let burnt = first * along + second * across;
        assert!(told.alpha * (along + across) >= burnt, "{told:?}");
        assert_relative_eq!(told.alpha * (along + across), burnt, max_relative = 1e-14);
    }
}

/// A rejected axis counts neither in the damping nor in what moves.
#[test]
fn a_rejected_axis_dissipates_nothing() {
    for (x, y, alpha) in
        [(f64::NAN, 2.0, 4.0), (2.0, f64::INFINITY, 7.0), (f64::NAN, f64::NAN, 0.0)]
    {
        let told = both(7.0, 4.0).stabilize(&at(x, y), Vector2::zeros());
        assert!(!told.accepted.all() && told.effort.iter().all(|it| it.is_finite()));
        assert_relative_eq!(told.alpha, alpha, max_relative = 1e-14);
    }
}

#[test]
fn each_axis_has_its_limit_of_credit() {
    let mut axes = PerAxis::of([popc::<f64>(); 2]);
    axes.axes_mut()[0].grant(5.0).expect("a credit");
    axes.axes_mut()[1].grant(2.0).expect("a credit");
    axes.limit_credit(3.0);
    assert_eq!([0, 1].map(|axis| axes.axes()[axis].observed_energy()), [3.0, 2.0]);
}

/// Without a stabilizer every effort passes, even one that is not finite, and nothing is told.
#[test]
fn no_stabilizer_passes_everything() {
    let moving =
        HeldTick { period: 1.0, position: 0.0, velocity: 1.0, displacement: 1.0, applied: -9.0 };
    for effort in [3.0, -0.0, f64::INFINITY, f64::NAN] {
        let told: Correction<f64> = NoStabilizer.stabilize(&moving.sample(), effort);
        assert_eq!(told.effort.to_bits(), effort.to_bits());
        let rest = (told.observed_energy, told.alpha, told.shortfall, told.accepted);
        assert_eq!(rest, (0.0, 0.0, 0.0, true));
    }
}
