//! Loops known to gain energy are detected, loops known not to are left alone, and the detected ones are bounded.
//!
//! The paper's wall of 8 kN/m and 2 N·s/m: a held spring contains a damper of `−k T / 2`, which exceeds the damping of
//! the wall and the plant together up to 2 kHz, and is below it at 10 kHz.

use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, OnePort, Plant, Popc, PortEnergy,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
};

use crate::support::{Bits, CASES, Motion, Real, State, hold, unit};

const START: f64 = 4e-3;

/// The paper's plant: operator and device as one mass.
fn body<T: Real>(start: f64, rate: f64) -> Body<T> {
    let of = T::of;
    let operator = Impedance { mass: of(0.1), damping: of(0.2), stiffness: of(50.0) };
    let device = Impedance { mass: of(0.2), damping: of(0.001), stiffness: of(0.0) };
    let body = Body::new(operator + device, of(1.0 / rate)).expect("a body");
    body.starting(of(-start), of(0.0))
}

fn wall<T: Real>() -> Wall<T> {
    Wall::new(T::of(8000.0), T::of(2.0)).expect("a wall")
}

fn limit<T: Real>(cap: f64, rate: f64) -> DampingLimit<T> {
    DampingLimit::of_mass(T::of(cap), T::of(0.3), T::of(1.0 / rate)).expect("a limit")
}

/// A start within 10 % of the paper's.
fn start(bits: Bits) -> f64 {
    START * (0.9 + 0.2 * unit(bits))
}

/// The least observed energy up to the tick that ends the first contact, observed but not corrected.
fn least_in_first_contact<T: Real>(start: f64, rate: f64) -> f64 {
    let popc: Popc<T> = Popc::new(PortEnergy, limit(0.0, rate));
    let mut port = wall().stabilized(popc).differenced();
    let (mut plant, mut least, mut touched) = (body::<T>(start, rate), 0f64, false);
    let mut sample = plant.start();
    for _ in 0..rate as usize {
        sample = plant.advance(port.respond(&sample));
        let inside = sample.position > T::of(0.0);
        least = least.min(port.correction().observed_energy.f64());
        if touched && !inside {
            port.respond(&sample);
            return least.min(port.correction().observed_energy.f64());
        }
        touched |= inside;
    }
    panic!("the wall was not reached, or not left, within a second");
}

/// The largest swing from 0, 1 and 9 seconds on until 10 s, over a wall at 100 Hz.
fn swings<T: Real>(start: f64, rate: f64, candidate: impl LyapunovCandidate<T>) -> [f64; 3] {
    let hold = (rate / 100.0) as u32;
    let lolc = Lolc::new(candidate, limit(0.5, rate));
    let mut port = wall().held(hold).expect("a hold").stabilized(lolc).differenced();
    let mut plant = body::<T>(start, rate);
    let mut sample = plant.start();
    largest(rate, || {
        sample = plant.advance(port.respond(&sample));
        sample.position.f64()
    })
}

fn largest(rate: f64, mut next: impl FnMut() -> f64) -> [f64; 3] {
    let mut swings = [0f64; 3];
    for tick in 1..=(10.0 * rate) as usize {
        let x = next().abs();
        for (swing, after) in swings.iter_mut().zip([0.0, 1.0, 9.0]) {
            if tick as f64 >= after * rate {
                *swing = swing.max(x);
            }
        }
    }
    swings
}

/// The same loop in straight code after the tick contract, with or without the credit of the wall's damping.
fn straight_swings(start: f64, rate: f64, credit: bool) -> [f64; 3] {
    let (mass, period) = (0.3, 1.0 / rate);
    let motion = Motion { mass, damping: 0.201, stiffness: 50.0, rest: 0.0 };
    let gain = motion.over(period);
    let mut now = State { position: -start, velocity: 0.0 };
    let (mut before, mut sum, mut applied, mut environment) = (now.position, 0.0, 0.0, 0.0);
    let mut tick = 0u32;
    largest(rate, || {
        let (x, dx) = (now.position, now.position - before);
        let v = dx / period;
        if tick.is_multiple_of((rate / 100.0) as u32) {
            environment = if x > 0.0 { (8000.0 * x + 2.0 * v).max(0.0) } else { 0.0 };
        }
        sum += applied * dx + if credit && x > 0.0 { 2.0 * v * v * period } else { 0.0 };
        let square = v * v * period;
        let owed = sum < 0.0 && square > f64::MIN_POSITIVE;
        let alpha = if owed { (-sum / square).min(0.5 * mass / period) } else { 0.0 };
        applied = environment + alpha * v;
        before = x;
        now = gain.step(&motion, now, applied);
        tick += 1;
        now.position
    })
}

mod check {
    use super::*;

    pub(super) fn sees_what_gains<T: Real>() {
        hold(CASES, any::<Bits>(), |bits| {
            for rate in [100.0, 1000.0, 2000.0] {
                let least = least_in_first_contact::<T>(start(bits), rate);
                prop_assert!(least < 0.0, "unseen at {rate} Hz");
            }
            Ok(())
        });
    }

    pub(super) fn leaves_alone_what_does_not<T: Real>() {
        hold(CASES / 10, any::<Bits>(), |bits| {
            let least = least_in_first_contact::<T>(start(bits), 10_000.0);
            prop_assert!(least >= 0.0, "{least:e} J at 10 kHz");
            Ok(())
        });
    }

    /// Fewer loops where there are more ticks in each.
    const RATES: [(f64, u32); 7] = [
        (100.0, CASES),
        (200.0, 1000),
        (500.0, 500),
        (1000.0, 200),
        (2000.0, 100),
        (5000.0, 40),
        (10_000.0, 20),
    ];

    pub(super) fn popc_bounds<T: Real>() {
        for (rate, cases) in RATES {
            bounded(cases, POPC, |start| swings::<T>(start, rate, PortEnergy));
            bounded(cases / 10, POPC, |start| straight_swings(start, rate, false));
        }
    }

    pub(super) fn lolc_bounds<T: Real>() {
        let candidate = (PortEnergy, wall::<T>().dissipation());
        bounded(CASES, LOLC, |start| swings::<T>(start, 100.0, candidate));
        bounded(CASES / 10, LOLC, |start| straight_swings(start, 100.0, true));
    }

    /// Bounds of the swing as shares of the start: always, after a second, in the tenth.
    const POPC: [f64; 3] = [1.0, 0.8, 0.1];
    const LOLC: [f64; 3] = [1.0, 0.85, 0.6];

    fn bounded(cases: u32, shares: [f64; 3], swings: impl Fn(f64) -> [f64; 3]) {
        hold(cases, any::<Bits>(), |bits| {
            let start = start(bits);
            let swings = swings(start);
            for (swing, share) in swings.iter().zip(shares) {
                prop_assert!(*swing <= share * start, "{swings:?} from {start:e}");
            }
            Ok(())
        });
    }
}

crate::support::every_real!(sees_what_gains, leaves_alone_what_does_not, popc_bounds, lolc_bounds);
