//! Force within its sector: what passes, what is limited, and what it may cost.

use std::f64::consts::PI;

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    HeldTick, OnePort, Popc, PortSample, Scalar, Stabilizer,
    environments::{Spring, Wall},
    stabilizers::SlopeBound,
};
use nalgebra::{Vector2, Vector3};

use crate::support::{Dice, HELD, PERIOD, held_tick, popc, swing};

/// Half of what HELD stands, so that a swing decays.
const SLOPE: f64 = 1000.0;

fn bound() -> SlopeBound<f64> {
    SlopeBound::of_damping(0.5 * HELD.damping, PERIOD).expect("a slope")
}

/// The efforts that come out, tick by tick, over positions and the efforts that go in.
fn run(mut bound: SlopeBound<f64>, ticks: &[(f64, f64)]) -> Vec<f64> {
    let mut last = ticks[0].0;
    let follow = |&(position, effort): &(f64, f64)| {
        let sample = HeldTick {
            period: PERIOD,
            position,
            velocity: 0.0,
            displacement: position - last,
            applied: 0.0,
        }
        .sample();
        last = position;
        bound.stabilize(&sample, effort).effort
    };
    ticks.iter().map(follow).collect()
}

#[test]
fn changes_are_in_the_sector_or_towards_nothing() {
    let mut bound = SlopeBound::<Vector3<f64>>::new(SLOPE).expect("a slope");
    let mut dice = Dice::of(8);
    let (mut before, mut rises) = (Vector3::zeros(), 0);
    bound.stabilize(&PortSample::starting(PERIOD, before, before), before);
    for _ in 0..20_000 {
        let (moved, asked): (Vector3<f64>, Vector3<f64>) = (dice.signal(1e-3), dice.signal(5.0));
        let sample = held_tick(Vector3::zeros(), moved, before);
        let force = bound.stabilize(&sample, asked).effort;
        for axis in 0..3 {
            let (change, most) = (force[axis] - before[axis], SLOPE * moved[axis]);
            let inside = change * most >= -1e-12 && change.abs() <= most.abs() + 1e-12;
            let fallen = force[axis].abs() <= before[axis].abs() + 1e-12
                || force[axis].abs() <= most.abs() + 1e-12;
            assert!(inside || fallen, "{change} N for {most} N");
            rises += i32::from(inside && change.abs() > 1e-3);
            let between =
                force[axis] * asked[axis] >= 0.0 && force[axis].abs() <= asked[axis].abs();
            assert!(between, "{} N for {} N", force[axis], asked[axis]);
        }
        before = force;
    }
    assert!(rises > 1000);
}

/// A softer spring passes to the bit, in every scalar, however long it swings.
#[test]
fn what_is_in_the_sector_passes() {
    fn check<T: Scalar>() {
        let mut bound = SlopeBound::<T>::new(T::of(SLOPE)).expect("a slope");
        let (mut dice, mut position) = (Dice::of(4), T::of(2e-3));
        for _ in 0..100_000 {
            let next = T::of(dice.within(3e-3));
            let sample = HeldTick {
                period: T::of(PERIOD),
                position: next,
                velocity: T::of(0.0),
                displacement: next - position,
                applied: T::of(0.0),
            }
            .sample();
            position = next;
            let asked = T::of(0.9 * SLOPE) * position;
            assert_eq!(bound.stabilize(&sample, asked).effort, asked);
        }
    }
    check::<f64>();
    check::<f32>();
}

/// A wall that is stiffer is a spring of the slope, on the way in and out.
#[test]
fn a_stiffer_wall_is_a_spring_of_the_slope() {
    let depths =
        (0..=200).map(|tick| 1e-5 * f64::from(if tick <= 100 { tick } else { 200 - tick }));
    let ticks: Vec<_> = depths.map(|depth| (depth, 50_000.0 * depth)).collect();
    for ((depth, _), force) in ticks.iter().zip(run(bound(), &ticks)) {
        assert!(abs_diff_eq!(force, SLOPE * depth, epsilon = 1e-9), "{force} N at {depth} m");
    }
}

/// Symmetry of the two directions, also of what is held back and let through again.
#[test]
fn a_mirrored_motion_has_mirrored_forces() {
    let creeping = || bound().creeping(20.0).expect("a rate");
    let mut dice = Dice::of(12);
    let ticks: Vec<_> = (0..5000).map(|_| (dice.within(2e-3), dice.within(4.0))).collect();
    let mirrored: Vec<_> = ticks.iter().map(|(position, effort)| (-position, -effort)).collect();
    let forces = run(creeping(), &ticks);
    assert_ne!(forces, run(bound(), &ticks), "something is held back and let through");
    for (force, mirrored) in forces.iter().zip(run(creeping(), &mirrored)) {
        assert_eq!(-force, mirrored);
    }
}

/// Ten times the slope, on both sides and on one.
#[test]
fn a_wall_ten_times_too_stiff() {
    let spring = || Spring::new(10.0 * SLOPE).expect("a spring").at(1e-3);
    let (alone, _) = swing(HELD, spring(), 20_000);
    assert!(alone > 1.0, "{alone} m");
    // It starts where the spring rests; the hand pulls it away from there, by 1 mm of 200 N/m in 1200 N/m.
    let (most, late) = swing(HELD, spring().stabilized(bound()), 20_000);
    let rest = 1e-3 * SLOPE / (SLOPE + HELD.stiffness);
    assert!(
        most <= 1e-3 && abs_diff_eq!(late, rest, epsilon = 1e-9),
        "{most} m, then {late} m for {rest} m"
    );
    let wall = Wall::new(10.0 * SLOPE, 0.0).expect("a wall").at(-2e-3);
    let (most, late) = swing(HELD, wall.stabilized(bound()), 20_000);
    let stored = (10.0 * SLOPE / HELD.stiffness).sqrt() * 3e-3;
    assert!(most < stored && late <= most, "{most} m, then {late} m");
}

/// An environment that makes the most of it: on the way in it asks for ever more, holds that on the way out, and lets go
/// where the motion turns.
struct Pump {
    bound: SlopeBound<f64>,
    asked: f64,
    out: bool,
}

impl OnePort<f64> for Pump {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        let inwards = sample.displacement > 0.0;
        match (inwards, self.out) {
            (true, true) => self.asked = 0.0,
            (true, false) => self.asked += 1e3,
            _ => {}
        }
        self.out = !inwards;
        self.bound.stabilize(sample, self.asked).effort
    }
}

/// A way in and out of `2 A` gives up to `2 μ A²`, and the hand burns `π b ω A²` on it.
#[test]
fn what_it_may_cost_and_what_bounds_it() {
    let rate = (HELD.stiffness / HELD.mass).sqrt();
    let balance = PI * HELD.damping * rate / 2.0;
    let pumped = |slope: f64| {
        let bound = SlopeBound::new(slope).expect("a slope");
        swing(HELD, Pump { bound, asked: 0.0, out: false }, 20_000)
    };
    let (below, above) = (pumped(0.8 * balance), pumped(1.25 * balance));
    assert!(below.0 <= 1e-3 && below.1 < 1e-5, "{below:?} m");
    assert!(above.1 > 0.1, "{above:?} m");
}

/// The least of `Σ F Δx + b Δx² / T` over a motion of these steps before a wall `force`, with `b = μ T / 2`.
fn least_with_damper(force: impl Fn(f64) -> f64, steps: &[f64]) -> f64 {
    let (mut bound, mut position, mut energy, mut least) = (bound(), 0.0, 0.0, 0f64);
    let mut held = bound.stabilize(&PortSample::starting(PERIOD, 0.0, 0.0), force(0.0)).effort;
    for step in steps {
        energy += held * step + 0.5 * SLOPE * step * step;
        least = least.min(energy);
        position += step;
        let sample = held_tick(position, *step, held);
        held = bound.stabilize(&sample, force(position)).effort;
    }
    least
}

#[test]
fn port_and_damper_give_nothing_before_a_linear_wall_whatever_the_motion() {
    for (seed, stiffness) in
        (0..400).zip([0.5, 1.0, 1.7, 10.0, 1e4].map(|it| it * SLOPE).into_iter().cycle())
    {
        let mut dice = Dice::of(seed);
        let steps: Vec<f64> =
            (0..200).map(|_| dice.within(1e-3) * 10f64.powf(dice.within(1.0) - 1.0)).collect();
        let least = least_with_damper(|x| (stiffness * x).max(0.0), &steps);
        assert!(least >= -1e-15, "{least:e} J at {stiffness} N/m, seed {seed}");
    }
}

/// In at once over `X` under no force, which is then `μ X` all the way out: `μ X²` for a damper that took half of it.
#[test]
fn a_wall_that_is_steep_and_then_flat_makes_a_loop() {
    let (depth, count) = (1e-3, 100);
    let out = -depth / f64::from(count);
    let steps = [&[depth][..], &vec![out; count as usize]].concat();
    let flat = |x: f64| (1e6 * x).clamp(0.0, 1.0);
    let expected = -SLOPE * depth * depth * (0.5 - 0.5 / f64::from(count));
    assert_abs_diff_eq!(least_with_damper(flat, &steps), expected, epsilon = 1e-9 * SLOPE * depth);
}

/// A plane at 45° of half the slope pushes both axes by `k (x + y) / 2`. In along `x` only that axis follows, `k X / 2`, and
/// sliding out along it over `L` takes `k X L / 2`, which the other axis would have paid for.
#[test]
fn before_a_slanted_plane_sliding_takes_energy() {
    let (stiffness, step, into, along) = (0.5 * SLOPE, 1e-5, 1000, 4000);
    let plane = |at: Vector2<f64>| Vector2::repeat(0.5 * stiffness * (at.x + at.y).max(0.0));
    let mut bound = SlopeBound::<Vector2<f64>>::new(SLOPE).expect("a slope");
    let still = Vector2::zeros();
    let mut held = bound.stabilize(&PortSample::starting(PERIOD, still, still), still).effort;
    let (mut at, mut bare, mut work, mut alone, mut dissipated) = (still, still, 0.0, 0.0, 0.0);
    for tick in 0..into + along {
        let moved = if tick < into { Vector2::new(step, 0.0) } else { Vector2::new(-step, step) };
        work += held.dot(&moved);
        alone += bare.dot(&moved);
        dissipated += 0.5 * SLOPE * moved.norm_squared();
        at += moved;
        let sample = held_tick(at, moved, held);
        bare = plane(at);
        held = bound.stabilize(&sample, bare).effort;
    }
    let square = stiffness * step * step;
    let (n, m) = (f64::from(into), f64::from(along));
    let took = square * n * (n - 1.0) / 4.0;
    assert_abs_diff_eq!(alone, took, epsilon = 1e-12);
    assert_abs_diff_eq!(work, took - square * n * m / 2.0, epsilon = 1e-12);
    assert_abs_diff_eq!(dissipated, square * (n + 2.0 * m), epsilon = 1e-12);
    assert!(work + dissipated < -0.087, "{work} J and {dissipated} J");
}

/// A held spring that the device's own damper makes passive needs no help: POPC, which does not know the damper, corrects it
/// all the same.
#[test]
fn less_conservative_than_popc() {
    struct Corrections<S>(S, f64);
    impl<S: Stabilizer<f64>> Stabilizer<f64> for &mut Corrections<S> {
        fn stabilize(
            &mut self,
            sample: &PortSample<f64>,
            effort: f64,
        ) -> lyapunov::Correction<f64> {
            let correction = self.0.stabilize(sample, effort);
            self.1 = self.1.max((correction.effort - effort).abs());
            correction
        }
    }
    let spring = || Spring::new(0.9 * SLOPE).expect("a spring").at(1e-3);
    let mut slope = Corrections(bound(), 0.0);
    let (most, _) = swing(HELD, spring().stabilized(&mut slope), 5000);
    assert!(slope.1 == 0.0 && most <= 1e-3, "{} N", slope.1);
    let alone: Popc<f64> = popc();
    let mut passivity = Corrections(alone, 0.0);
    swing(HELD, spring().stabilized(&mut passivity), 5000);
    assert!(passivity.1 > 0.01, "{} N", passivity.1);
}

/// At rest a weight is felt only through the creep, by `ρ T` a tick.
#[test]
fn a_weight_creeps_in() {
    let mut ticks = vec![(0.0, 0.0)];
    ticks.resize(100, (0.0, 1.0));
    assert!(run(bound(), &ticks).iter().all(|force| *force == 0.0));
    let creeping = bound().creeping(20.0).expect("a rate");
    for (tick, force) in run(creeping, &ticks).into_iter().enumerate() {
        assert_abs_diff_eq!(force, (0.02 * tick as f64).min(1.0), epsilon = 1e-12);
    }
}

/// The first sound effort passes whole, whatever came before it.
#[test]
fn a_first_effort_that_is_not_sound_holds_nothing_back() {
    let ticks = [(0.0, f64::NAN), (0.0, 5.0), (0.0, f64::INFINITY), (0.0, 5.0)];
    assert_eq!(run(bound(), &ticks), [0.0, 5.0, 0.0, 5.0]);
}

#[test]
fn what_cannot_be_right_is_refused() {
    assert!(SlopeBound::<f64>::new(0.0).is_err() && SlopeBound::<f64>::new(f64::INFINITY).is_err());
    let told = SlopeBound::<f64>::of_damping(1e300, 1e-300).expect_err("an infinite slope");
    let range = "such that the result is within the range of the scalar";
    assert_eq!(told.to_string(), format!("device damping is 1e300; it must be {range}"));
    assert!(SlopeBound::<f64>::of_damping(1.0, 0.0).is_err());
    assert!(bound().creeping(-1.0).is_err() && bound().creeping(f64::NAN).is_err());
}
