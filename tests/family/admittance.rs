//! Admittance device: it measures the hand's force and renders a mass by moving.
//!
//! The hand is a spring of 1 kN/m. The device moves exactly as commanded, one tick late; this loop gains energy.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    AdmittanceSample, DampingLimit, HeldFlow, OnePort, Popc, PortEnergy, PortSample, Stabilizer,
    effects::OnePortExt, stabilizers::StabilizerExt,
};

use crate::support::PERIOD;

const STIFFNESS: f64 = 1000.0;
const START: f64 = 5e-3;

/// `m v' = f`: what is rendered, in admittance causality.
#[derive(Clone, Copy, Debug)]
struct VirtualMass {
    mass: f64,
    flow: f64,
}

impl OnePort<f64> for VirtualMass {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        // The displacement of a load is its impulse.
        self.flow += sample.displacement / self.mass;
        self.flow
    }
}

/// The hand holds the device by a spring; the device keeps its velocity over a period.
#[derive(Clone, Copy, Debug)]
struct Hand {
    position: f64,
    momentum: f64,
}

impl Hand {
    fn energy(&self) -> f64 {
        0.5 * STIFFNESS * self.position * self.position
    }

    fn force(&self) -> f64 {
        -STIFFNESS * self.position
    }

    fn advance(&mut self, flow: f64) -> AdmittanceSample<f64> {
        let before = self.force();
        self.position += flow * PERIOD;
        let impulse = 0.5 * (before + self.force()) * PERIOD;
        self.momentum += impulse;
        HeldFlow { period: PERIOD, momentum: self.momentum, effort: self.force(), impulse, flow }
            .sample()
    }
}

/// The largest energy of the hand's spring over two seconds, in shares of the start's.
fn run(mut port: impl OnePort<f64>) -> f64 {
    let mut hand = Hand { position: START, momentum: 0.0 };
    let (start, mut most) = (hand.energy(), 0f64);
    let mut load = AdmittanceSample::starting(PERIOD, hand.force());
    let mut crossed = 0.0;
    for tick in 0..2000 {
        load = hand.advance(port.respond(&PortSample::from(load)));
        crossed += load.work;
        // What crosses the port is what the spring loses: ∫ f v dt under a held flow, exactly.
        let lost = start - hand.energy();
        assert_abs_diff_eq!(
            crossed,
            lost,
            epsilon = 1e-12 * (start + hand.energy()) * f64::from(tick + 1)
        );
        most = most.max(hand.energy() / start);
        if most > 1e6 {
            break;
        }
    }
    most
}

fn limit() -> DampingLimit<f64> {
    DampingLimit::of_stiffness(0.5, STIFFNESS, PERIOD).expect("a limit")
}

const RENDERED: VirtualMass = VirtualMass { mass: 0.2, flow: 0.0 };

#[test]
fn without_a_stabilizer_it_swings_up() {
    let most = run(RENDERED.delayed::<1>(1).expect("a delay"));
    assert!(most > 1e3, "{most}");
}

/// The stabilizers and the adaptors are the very ones of the other causality.
#[test]
fn stabilized_it_stays_bounded() {
    let popc = Popc::new(PortEnergy, limit());
    let most = run(RENDERED.delayed::<1>(1).expect("a delay").stabilized(popc));
    assert!(most < 1.1, "{most}");
    // What it absorbed before pays for less, and the swing never comes back to the start.
    let bounded = popc.bounded(1e-4).expect("a bound");
    let most = run(RENDERED.delayed::<1>(1).expect("a delay").stabilized(bounded));
    assert!(most <= 1.0, "{most}");
}

/// A load gives what a sample gives with effort and flow exchanged.
#[test]
fn a_load_is_a_drive_read_the_other_way() {
    let mut popc = Popc::new(PortEnergy, limit());
    let load =
        HeldFlow { period: PERIOD, momentum: 0.3, effort: -2.0, impulse: -2.0 * PERIOD, flow: 0.1 }
            .sample();
    let correction = popc.stabilize(&PortSample::from(load), 0.5);
    // A debt of 0.2 mJ is burnt by β f² T: β = 2e-4 / (4 · 1e-3) = 0.05 m/(N·s).
    assert_abs_diff_eq!(correction.alpha, 0.05, epsilon = 1e-12);
    assert_abs_diff_eq!(correction.effort, 0.5 - 0.05 * 2.0, epsilon = 1e-12);
}

/// `1 − β k T`: half of `1 / (k T)` halves the force on every tick, twice of it turns it round for ever.
#[test]
fn the_limit_is_that_of_a_held_spring() {
    let after = |cap: f64| {
        let most = DampingLimit::of_stiffness(cap, STIFFNESS, PERIOD).expect("a limit").most();
        let mut hand = Hand { position: START, momentum: 0.0 };
        for _ in 0..50 {
            hand.advance(most * hand.force());
        }
        hand.position.abs() / START
    };
    assert_abs_diff_eq!(after(0.5), 0.5f64.powi(50), epsilon = 1e-20);
    assert!(abs_diff_eq!(after(2.0), 1.0, epsilon = 1e-9) && after(2.1) > 100.0);
}
