//! Dry friction of 0, with bad numbers, and on lanes.

use approx::assert_abs_diff_eq;
use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::lanes::{AutoF32x4, AutoF64x4};
use lyapunov::{
    ParameterError, Plant, PortSample, Requirement, Scalar, Signal,
    bodies::{Body, Friction, Impedance, OperatedBody, Transition},
};

use crate::friction::law;
use crate::support::{Bits, CASES, Port, Real, hold, hostile, log_between, ordinary, same, wild};

type FrictionBody<T> = Friction<Body<T>, T, 2>;

/// A scene of ordinary size and its efforts.
struct Scene([f64; 9], [f64; 40]);

impl Scene {
    fn of(bits: &[Bits; 8], least: f64) -> Self {
        let mut random = bits[7];
        let efforts = std::array::from_fn(|_| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            ordinary(random, 2.0)
        });
        let coulomb = least * log_between(bits[0], 0.1, 1.0);
        let numbers = [
            log_between(bits[1], 0.05, 1.0),
            log_between(bits[2], 1e-3, 1.0),
            log_between(bits[3], 1.0, 1e4),
            log_between(bits[4], 1e-4, 2e-2),
            ordinary(bits[5], 0.02),
            if bits[6].is_multiple_of(2) { 0.0 } else { ordinary(bits[6], 0.3) },
            coulomb,
            least,
            log_between(bits[0].rotate_left(32), 1e-3, 0.1),
        ];
        Self(numbers, efforts)
    }
}

/// The scenes in the lanes of one body.
fn bodies<T: Scalar + Signal<Scalar = T>>(scenes: &[Scene]) -> (Body<T>, FrictionBody<T>) {
    let number = |at: usize| T::from_lanes(|lane| scenes[lane].0[at]);
    let parts = Impedance { mass: number(0), damping: number(1), stiffness: number(2) };
    let body = Body::<T>::new(parts, number(3)).expect("a body").starting(number(4), number(5));
    let mut law = law(0.0, 0.0, 1.0);
    (law.coulomb, law.breakaway, law.stribeck_velocity) = (number(6), number(7), number(8));
    (body, Friction::new(body, parts, law).expect("friction"))
}

fn numbers<T: Scalar + Signal<Scalar = T>>(sample: &PortSample<T>, lane: usize) -> [f64; 6] {
    let PortSample { period, position, velocity, displacement, applied, work } = *sample;
    [period, position, velocity, displacement, applied, work].map(|number| number.lane(lane))
}

fn zero_changes_nothing<T: Real + Port<Scalar = T>>() {
    hold(CASES / 10, uniform8(any::<Bits>()), |bits| {
        let scene = Scene::of(&bits, 0.0);
        let (mut body, mut plant) = bodies::<T>(std::slice::from_ref(&scene));
        for effort in scene.1 {
            let (free, sample) = (body.advance(T::of(effort)), plant.advance(T::of(effort)));
            prop_assert!(free == sample && plant.heat() == T::of(0.0));
            prop_assert!(plant.transitions().count(0) == 0);
        }
        Ok(())
    });
}

#[test]
fn zero_static_friction_changes_nothing() {
    zero_changes_nothing::<f32>();
    zero_changes_nothing::<f64>();
}

/// Lanes with and without friction side by side.
fn lanes_are_alone<L: Scalar + Signal<Scalar = L>, T: Real + Port<Scalar = T>>() {
    hold(CASES / 100, uniform8(any::<Bits>()), |bits| {
        let scenes: Vec<Scene> = (0..L::LANES)
            .map(|lane| {
                let bits = bits.map(|bits| bits.rotate_left(11 * lane as u32));
                Scene::of(&bits, if lane == 1 { 0.0 } else { 0.3 + lane as f64 })
            })
            .collect();
        let (_, mut all) = bodies::<L>(&scenes);
        let mut each: Vec<_> = scenes.chunks(1).map(|scene| bodies::<T>(scene).1).collect();
        for tick in 0..40 {
            let sample = all.advance(L::from_lanes(|lane| scenes[lane].1[tick]));
            for (lane, alone) in each.iter_mut().enumerate() {
                let single = alone.advance(T::of(scenes[lane].1[tick]));
                let pairs = numbers(&sample, lane).into_iter().zip(numbers(&single, 0));
                for (a, b) in pairs {
                    prop_assert!(same(a, b), "{a:e} is not {b:e}");
                }
                prop_assert!(same(all.heat().lane(lane), alone.heat().f64()));
                prop_assert!(all.transitions().last(lane).eq(alone.transitions().last(0)));
            }
        }
        Ok(())
    });
}

#[test]
fn lanes_equal_the_scalar_run() {
    lanes_are_alone::<AutoF64x4, f64>();
    lanes_are_alone::<AutoF32x4, f32>();
}

/// Any accepted parameters, any efforts: every period ends, and friction takes energy where anything is finite.
#[test]
fn hostile_numbers_end() {
    let (mut cut, mut moved) = (0, 0);
    for case in 0..1000_u64 {
        let bits = |at: u64| (case * 64 + at + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let number = |at: u64| {
            let bits = bits(at) ^ bits(at) >> 29;
            if case % 2 == 0 { hostile::<f64>(bits) } else { log_between(bits, 1e-6, 1e6) }
        };
        let parts = Impedance {
            mass: number(1).abs(),
            damping: if case % 3 == 0 { 0.0 } else { number(2).abs() },
            stiffness: number(3).abs(),
        };
        let Ok(body) = Body::new(parts, number(4).abs()) else { continue };
        let coulomb = number(5).abs();
        let law = law(coulomb, coulomb + number(6).abs(), number(7).abs());
        let body = body.starting(number(8), number(9));
        let Ok(mut plant) = Friction::new(body, parts, law) else { continue };
        for tick in 0..3 {
            let heat = plant.heat();
            let effort = if tick == 2 { wild(bits(20)) } else { number(10 + tick) };
            let sample = plant.advance(effort);
            let burnt = plant.heat() - heat;
            assert!(burnt >= 0.0 || burnt.is_nan(), "{burnt} J in case {case}");
            let cuts = plant.transitions().last(0).filter(|&(_, what)| what == Transition::Cut);
            cut += cuts.count();
            moved += usize::from(sample.velocity != 0.0 && sample.velocity.is_finite());
        }
    }
    assert!(cut > 0 && moved > 100, "{cut} cut, {moved} moved");
}

/// A body too fast for its period, moved over roughly, does not gain energy either.
#[test]
fn a_body_too_fast_for_its_period_gains_no_energy() {
    for (stiffness, damping) in [(1e14, 0.0), (1e12, 3.0), (0.0, 1e7), (1e10, 1e7)] {
        let parts = Impedance { mass: 0.2, damping, stiffness };
        let body = Body::new(parts, 1e-2).expect("a body").starting(0.01, 0.3);
        let mut plant = Friction::new(body, parts, law(0.5, 1.0, 0.05)).expect("friction");
        let energy = |sample: &PortSample<f64>| {
            0.5 * (stiffness * sample.position.powi(2) + 0.2 * sample.velocity.powi(2))
        };
        let start = energy(&plant.start());
        let mut work = 0.0;
        for tick in 0..50 {
            let sample = plant.advance(if tick % 7 == 0 { 3.0 } else { -2.0 });
            work += sample.work;
            assert!(energy(&sample) + work + plant.heat() <= start * (1.0 + 1e-6) + 1e-6);
        }
    }
}

#[test]
fn from_an_effort_that_is_not_finite_nothing_is_finite() {
    let parts = Impedance { mass: 0.2, damping: 0.1, stiffness: 50.0 };
    let body = Body::new(parts, 1e-3).expect("a body");
    let plant = Friction::new(body, parts, law(0.1, 0.2, 0.01)).expect("friction");
    for effort in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut plant = plant;
        for effort in [effort, 0.0, 1.0] {
            let sample = plant.advance(effort);
            assert!(!sample.position.is_finite() && !sample.velocity.is_finite());
        }
    }
}

/// An interval of 0 moves nothing, and a later one continues as if there had been one period.
#[test]
fn intervals_may_vary() {
    let parts = Impedance { mass: 0.2, damping: 0.1, stiffness: 80.0 };
    let body = Body::<f64>::new(parts, 0.05).expect("a body").starting(0.03, -0.4);
    let mut whole = Friction::new(body, parts, law(0.1, 0.2, 0.01)).expect("friction");
    let mut split = whole;
    let one = whole.advance(0.3);
    for interval in [0.0, 0.02, 0.0, 0.025, 0.005] {
        split.reshape(parts, interval).expect("an interval");
        let before = split.start();
        let sample = split.advance(0.3);
        assert!(sample.period == interval);
        if interval == 0.0 {
            assert!(sample.displacement == 0.0 && sample.velocity == before.velocity);
            assert!(split.transitions().count(0) == 0);
        }
    }
    let sample = split.start();
    assert_abs_diff_eq!(sample.position, one.position, epsilon = 1e-16);
    assert_abs_diff_eq!(sample.velocity, one.velocity, epsilon = 1e-14);
    assert_abs_diff_eq!(split.heat() / whole.heat(), 1.0, epsilon = 1e-13);
    assert!(split.reshape(parts, f64::NAN).is_err() && split.reshape(parts, -1.0).is_err());
}

#[test]
fn bad_parameters_are_named() {
    let parts = Impedance { mass: 0.2, damping: 0.1, stiffness: 80.0 };
    let body = Body::<f64>::new(parts, 1e-3).expect("a body");
    let error = |coulomb, breakaway, speed| {
        let law = law(coulomb, breakaway, speed);
        let error = Friction::new(body, parts, law).err();
        error.map(|ParameterError { parameter, requirement, .. }| (parameter, requirement))
    };
    let (not_negative, positive) = (Requirement::NonNegative, Requirement::Positive);
    assert_eq!(error(-1.0, 1.0, 0.1), Some(("coulomb", not_negative)));
    assert_eq!(error(f64::NAN, 1.0, 0.1), Some(("coulomb", not_negative)));
    assert_eq!(error(0.0, f64::INFINITY, 0.1), Some(("static", not_negative)));
    assert_eq!(error(1.5, 1.0, 0.1), Some(("coulomb", Requirement::AtMost(1.0))));
    assert_eq!(error(0.5, 1.0, 0.0), Some(("stribeck velocity", positive)));
    assert_eq!(error(0.5, 1.0, f64::INFINITY), Some(("stribeck velocity", positive)));
    assert_eq!(error(0.0, 0.0, 0.1), None);
    let parts = Impedance { mass: -1.0, ..parts };
    let error = Friction::new(body, parts, law(0.0, 1.0, 0.1)).expect_err("an error");
    assert_eq!(error.parameter, "mass");
}
