//! A bounded slope is passive whatever asks for the force, and a creep gives what it says.

use lyapunov::{Adapt, Drive, OnePort, Popc, SlopeBound, Spring, Stabilizer, Wall};
use nalgebra::Vector3;

use crate::support::{Dice, HELD, PERIOD, popc, swing};

const SLOPE: f64 = 2000.0;
/// `μ T / 2`, N·s/m.
const DAMPING: f64 = 1.0;

fn bound() -> SlopeBound<f64> {
    SlopeBound::of_damping(DAMPING, PERIOD).expect("a slope")
}

/// The least over a run of `Σ (F · Δx + b |Δx|² / T) − U(F) + ρ T Σ |F| / μ`, in which an environment asks for anything.
fn least(
    mut bound: SlopeBound<f64>,
    creep: f64,
    damping: f64,
    mut motion: impl FnMut(usize, Vector3<f64>) -> Vector3<f64>,
) -> f64 {
    let mut dice = Dice::of(5);
    let mut drive = Drive::starting(PERIOD, Vector3::zeros(), Vector3::zeros());
    let (mut energy, mut least) = (0.0, 0f64);
    for tick in 0..4000 {
        let force = bound.stabilize(&drive, dice.signal(1e3)).effort;
        energy += creep * PERIOD * force.abs().sum() / SLOPE;
        least = least.min(energy - force.norm_squared() / (2.0 * SLOPE));
        let moved = motion(tick, force);
        energy += force.dot(&moved) + damping * moved.norm_squared() / PERIOD;
        drive = Drive::new(PERIOD, Vector3::zeros(), moved / PERIOD, moved, force);
    }
    least
}

#[test]
fn whatever_the_motion_and_the_environment() {
    for creep in [0.0, 50.0, 5000.0] {
        let bound = bound().creeping(creep).expect("a rate");
        for seed in 0..20 {
            let mut dice = Dice::of(seed);
            let mut random = |_, _| dice.signal::<Vector3<f64>>(1e-4);
            assert!(least(bound, creep, DAMPING, &mut random) >= -1e-12);
            let worst = |_, force: Vector3<f64>| {
                dice.signal::<Vector3<f64>>(1e-5) - force * (PERIOD / (2.0 * DAMPING))
            };
            assert!(least(bound, creep, DAMPING, worst) >= -1e-12);
        }
    }
}

/// To and fro on every tick gives `(μ − 2 b / T) Δx²` at most, which is 0 at `b = μ T / 2`.
#[test]
fn the_slope_is_the_largest() {
    let shaken = |damping| {
        let mut dice = Dice::of(1);
        let (mut stroke, stride) = (Vector3::zeros(), 1e-4);
        least(bound(), 0.0, damping, move |tick, _| {
            let inwards = tick % 2 == 0;
            stroke = if inwards { dice.signal::<Vector3<f64>>(stride) } else { -stroke };
            stroke
        })
    };
    assert!(shaken(DAMPING) >= -1e-12);
    assert!(shaken(0.95 * DAMPING) < -1e-4, "{:e} J", shaken(0.95 * DAMPING));
}

/// A wall that is stiffer is a spring of the slope, on the way in and out.
#[test]
fn a_stiffer_wall_is_rendered_by_the_slope() {
    let mut port = Wall::new(50_000.0, 0.0).expect("a wall").stabilized(bound());
    let (mut drive, mut position) = (Drive::starting(PERIOD, 0.0, 0.0), 0.0);
    for tick in 0..200 {
        let moved = if tick < 100 { 1e-5 } else { -1e-5 };
        let force = port.respond(&drive);
        assert!((force - SLOPE * position).abs() < 1e-9, "{force} N at {position} m");
        position += moved;
        drive = Drive::new(PERIOD, position, moved / PERIOD, moved, force);
    }
}

/// Behind the bound anything may stand: a spring of ten times the slope, two ticks late.
#[test]
fn a_late_and_stiff_spring_stays_bounded() {
    let late = || Spring::new(10.0 * SLOPE).and_then(|it| it.delayed::<2>(2)).expect("a spring");
    let (alone, _) = swing(HELD, late(), 20_000);
    assert!(alone > 1.0, "{alone} m");
    let (most, _) = swing(HELD, late().stabilized(bound()), 20_000);
    assert!(most <= 1e-3 * (1.0 + 1e-9), "{most} m");
    let creeping = bound().creeping(10.0).expect("a rate");
    let (most, _) = swing(HELD, late().stabilized(creeping), 20_000);
    assert!(most < 5e-3, "{most} m");
}

/// A held spring that the device's own damper makes passive needs no help: POPC, which does not know the damper, corrects it
/// all the same.
#[test]
fn less_conservative_than_popc() {
    struct Corrections<S>(S, f64);
    impl<S: Stabilizer<f64>> Stabilizer<f64> for &mut Corrections<S> {
        fn stabilize(&mut self, drive: &Drive<f64>, effort: f64) -> lyapunov::Action<f64> {
            let action = self.0.stabilize(drive, effort);
            self.1 = self.1.max((action.effort - effort).abs());
            action
        }
    }
    let spring = Spring::new(0.9 * SLOPE).expect("a spring");
    let mut slope = Corrections(bound(), 0.0);
    let (_, late) = swing(HELD, spring.stabilized(&mut slope), 5000);
    assert!(slope.1 < 1e-12 && late < 1e-4, "{} N, {late} m", slope.1);
    let alone: Popc<f64> = popc();
    let mut passivity = Corrections(alone, 0.0);
    swing(HELD, spring.stabilized(&mut passivity), 5000);
    assert!(passivity.1 > 0.05, "{} N", passivity.1);
}

/// At rest a weight is felt only through the creep, by `ρ T` a tick.
#[test]
fn a_weight_creeps_in() {
    let rest = |force| Drive::new(PERIOD, 0.0, 0.0, 0.0, force);
    let mut passive = bound();
    assert_eq!(passive.stabilize(&rest(0.0), 1.0).effort, 0.0);
    let mut creeping = bound().creeping(20.0).expect("a rate");
    let mut force: f64 = 0.0;
    for tick in 1..100 {
        force = creeping.stabilize(&rest(force), 1.0).effort;
        assert!((force - (0.02 * f64::from(tick)).min(1.0)).abs() < 1e-12);
    }
}

#[test]
fn what_cannot_be_right_is_refused() {
    assert!(SlopeBound::new(0.0).is_err() && SlopeBound::new(f64::INFINITY).is_err());
    assert!(SlopeBound::of_damping(1e300_f64, 1e-300).is_err());
    assert!(SlopeBound::of_damping(1.0, 0.0).is_err());
    assert!(bound().creeping(-1.0).is_err() && bound().creeping(f64::NAN).is_err());
}
