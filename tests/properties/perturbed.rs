//! Disturbances of a body beside its port: motion, grip, jitter and external forces.

use approx::abs_diff_eq;
use nalgebra::Vector2;
use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::lanes::{AutoF32x4, AutoF64x4, WideF64x4};
use lyapunov::{
    ParameterError, Plant, PortSample, Requirement, Scalar, Signal,
    bodies::{
        Body, DampedMass, ElasticJoint, Impedance, OperatedBody, PlantExt, TwoMassBody,
        TwoMassParts,
    },
    trajectories::{Constant, FirstAxis, Pulse, Sine},
};

use crate::support::{Bits, Motion, Port, Real, State, hold, log_between, ordinary, same, unit};

const RATE: f64 = 1000.0;

/// A body that can be made of random parts.
trait Made<V: Signal>: OperatedBody<V> + Copy {
    fn parts(number: impl Fn(usize, f64, f64) -> V::Scalar) -> Self::Parts;

    fn made(parts: Self::Parts, rest: V, position: V, velocity: V) -> Self;
}

fn hand<T: Scalar>(number: &impl Fn(usize, f64, f64) -> T) -> Impedance<T> {
    Impedance {
        mass: number(0, 0.1, 2.0),
        damping: number(1, 0.01, 2.0),
        stiffness: number(2, 10.0, 500.0),
    }
}

impl<V: Signal> Made<V> for Body<V> {
    fn parts(number: impl Fn(usize, f64, f64) -> V::Scalar) -> Self::Parts {
        hand(&number)
    }

    fn made(parts: Self::Parts, rest: V, position: V, velocity: V) -> Self {
        let body = Body::new(parts, V::Scalar::of(1.0 / RATE)).expect("a body");
        body.resting_at(rest).starting(position, velocity)
    }
}

impl<V: Signal> Made<V> for TwoMassBody<V> {
    fn parts(number: impl Fn(usize, f64, f64) -> V::Scalar) -> Self::Parts {
        TwoMassParts {
            operator: hand(&number),
            device: DampedMass { mass: number(3, 0.01, 1.0), damping: number(4, 0.001, 0.5) },
            link: ElasticJoint { stiffness: number(5, 1e3, 1e6), damping: number(6, 0.01, 10.0) },
        }
    }

    fn made(parts: Self::Parts, rest: V, position: V, velocity: V) -> Self {
        let plant = TwoMassBody::new(parts, V::Scalar::of(1.0 / RATE)).expect("two masses");
        plant.resting_at(rest).starting(position, velocity)
    }
}

/// Stand-ins for normal numbers, different in each lane and tick.
fn stub<T: Scalar>(seed: Bits) -> impl FnMut() -> T {
    let mut calls = 0u64;
    move || {
        calls += 1;
        T::from_lanes(|lane| {
            let bits = (seed + 31 * lane as u64 + calls).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            4.0 * unit(bits ^ bits >> 29) - 2.0
        })
    }
}

/// Every number of a sample, with `-0.0` turned into `0.0`.
fn numbers<V: Port>(sample: &PortSample<V>) -> Vec<f64> {
    let PortSample { period, position, velocity, displacement, applied, work } = sample;
    let signals = [position, velocity, displacement, applied, work];
    signals
        .into_iter()
        .flat_map(Port::axes)
        .chain([*period])
        .map(|number| number.f64() + 0.0)
        .collect()
}

mod check {
    use super::*;

    /// Each disturbance at its neutral value, alone and all together: the same bits as without.
    pub(super) fn neutral_values_change_nothing<V: Port>() {
        hold(300, uniform16(any::<Bits>()), |bits| {
            neutral::<V, Body<V>>(bits);
            neutral::<V, TwoMassBody<V>>(bits);
            Ok(())
        });
    }

    fn neutral<V: Port, B: Made<V>>(bits: [Bits; 16]) {
        let of = V::Scalar::of;
        let parts = B::parts(|at, least, most| of(log_between(bits[at], least, most)));
        let signal = |at: usize, scale| V::from_axes(|axis| ordinary(bits[at + axis], scale));
        let (rest, start, flow) = (signal(7, 0.01), signal(8, 0.01), signal(9, 0.3));
        let body = B::made(parts, rest, start, flow);
        let zero = of(0.0);
        let still = move |_: u64| rest;
        let none = FirstAxis::of(Constant::new(0.0).expect("none"), V::zero());
        let pulse = FirstAxis::of(Pulse::new(0.0, 0.002, 0.01, RATE).expect("none"), V::zero());
        let short = FirstAxis::of(Pulse::new(3.0, 0.002, 0.0, RATE).expect("none"), V::zero());
        let same_grip = [(0, parts), (3, parts), (3, parts)];
        let jittered = body.jittered(parts, zero, stub(bits[10])).expect("no jitter");
        let all = body.jittered(parts, zero, stub(bits[10])).expect("no jitter");
        let all =
            all.led_by(still).gripped(parts, same_grip).expect("a grip").pushed(none).pushed(pulse);
        let mut plants: Vec<Box<dyn Plant<V>>> = vec![
            Box::new(jittered),
            Box::new(body.led_by(still)),
            Box::new(body.gripped(parts, same_grip).expect("a grip")),
            Box::new(body.gripped(parts, []).expect("no grip")),
            Box::new(body.pushed(none)),
            Box::new(body.pushed(pulse)),
            Box::new(body.pushed(short)),
            Box::new(all),
        ];
        let mut plain = body;
        for plant in &plants {
            assert_eq!(numbers(&plant.start()), numbers(&plain.start()));
        }
        for tick in 0..20 {
            let effort = signal(11, if tick % 3 == 0 { 0.0 } else { 4.0 });
            let expected = numbers(&plain.advance(effort));
            for (kind, plant) in plants.iter_mut().enumerate() {
                let found = numbers(&plant.advance(effort));
                assert!(found.iter().zip(&expected).all(|(a, b)| same(*a, *b)), "{kind} at {tick}");
            }
        }
    }

    /// The whole chain on lanes with parts of their own: each lane equals its scalar run.
    pub(super) fn lanes_equal_scalars<T: Scalar, R: Real + Port<Scalar = R>>() {
        hold(100, uniform16(any::<Bits>()), |bits| {
            lanes::<T, R, Body<T>, Body<R>>(bits)?;
            lanes::<T, R, TwoMassBody<T>, TwoMassBody<R>>(bits)
        });
    }

    fn lanes<T: Scalar, R: Real, B: Made<T>, C: Made<R>>(
        bits: [Bits; 16],
    ) -> proptest::test_runner::TestCaseResult {
        let draw = |at: usize, lane: usize, least, most| {
            log_between(bits[at].rotate_left(9 * lane as u32), least, most)
        };
        let many = chain::<T, B>(bits, |at, least, most| {
            T::from_lanes(|lane| draw(at, lane, least, most))
        });
        for lane in 0..T::LANES {
            let one = chain::<R, C>(bits, |at, least, most| R::of(draw(at, lane, least, most)));
            // The normal numbers of each lane are those of the first with another seed.
            let one = one(bits[15] + 31 * lane as u64);
            for (many, one) in many(bits[15]).into_iter().zip(one) {
                for (many, one) in many.into_iter().zip(one) {
                    prop_assert!(same(many.lane(lane), one.f64()), "{many:?} is not {one:?}");
                }
            }
        }
        Ok(())
    }

    /// The samples of a body in a chain of everything, as a function of the seed.
    fn chain<T: Scalar, B: Made<T>>(
        bits: [Bits; 16],
        number: impl Fn(usize, f64, f64) -> T,
    ) -> impl Fn(Bits) -> Vec<[T; 5]> {
        let parts = B::parts(&number);
        let firm = B::parts(|at, least, most| number(at + 1, least, most));
        let start = number(9, 1e-4, 1e-2);
        let (deviation, effort) = (number(10, 1e-5, 4e-4), number(11, 0.1, 5.0));
        let amplitude = log_between(bits[12], 1e-3, 1e-2);
        move |seed| {
            let sine = Sine::new(0.001, amplitude, 3.0, RATE).expect("a sine");
            let pulse = Pulse::new(2.0, 0.003, 0.01, RATE).expect("a pulse");
            let body = B::made(parts, T::of(0.0), start, T::of(0.1));
            let mut plant = body
                .jittered(parts, deviation, stub(seed))
                .and_then(|body| body.led_by(sine).gripped(parts, [(7, firm)]))
                .expect("a chain")
                .pushed(Constant::new(0.5).expect("a load"))
                .pushed(pulse);
            (0..20)
                .map(|_| {
                    let sample = plant.advance(effort);
                    let PortSample { period, position, velocity, displacement, work, .. } = sample;
                    [period, position, velocity, displacement, work]
                })
                .collect()
        }
    }
}

crate::support::every_port!(neutral_values_change_nothing);

#[test]
fn lanes_equal_scalars() {
    check::lanes_equal_scalars::<AutoF64x4, f64>();
    check::lanes_equal_scalars::<WideF64x4, f64>();
    check::lanes_equal_scalars::<AutoF32x4, f32>();
}

/// Effort of the references.
fn effort(tick: usize) -> f64 {
    0.5 * ((tick * 7 % 5) as f64 - 1.5)
}

fn sine() -> Sine {
    Sine::new(0.002, 0.01, 3.0, RATE).expect("a sine")
}

/// A load of 1.5 N, a pulse of 4 N, a hand that moves to and fro, and a grip that changes at 0.12 s and at 0.2 s.
fn scene<B: OperatedBody<f64>>(body: B, grips: [B::Parts; 3]) -> impl Plant<f64> {
    let [own, firm, loose] = grips;
    body.led_by(sine())
        .gripped(own, vec![(120, firm), (200, loose)])
        .expect("a grip")
        .pushed(Constant::new(1.5).expect("a load"))
        .pushed(Pulse::new(4.0, 0.1, 0.05, RATE).expect("a pulse"))
}

fn compare(mut plant: impl Plant<f64>, third: [f64; 2], end: [f64; 2], most: [f64; 2]) {
    for tick in 0..300 {
        let sample = plant.advance(effort(tick));
        assert_eq!(
            (sample.applied, sample.work),
            (effort(tick), effort(tick) * sample.displacement)
        );
        let exact = match tick {
            99 => third,
            299 => end,
            _ => continue,
        };
        for ((found, exact), most) in [sample.position, sample.velocity].iter().zip(exact).zip(most)
        {
            let off = (found - exact).abs();
            assert!(off <= 1e-12 * most, "{found} is off by {off:e} of {most:e} at {tick}");
        }
    }
}

/// References of 150 digits, by `scripts/body_references.py`.
#[test]
fn scenes_equal_their_references() {
    let one = |damping, stiffness| Impedance { mass: 0.3, damping, stiffness };
    compare(
        scene(
            Body::new(one(0.201, 50.0), 1.0 / RATE).expect("a body").starting(-0.004, 0.0),
            [one(0.201, 50.0), one(2.001, 400.0), one(0.101, 20.0)],
        ),
        [0.021959776494288253, 0.4654120713413933],
        [-0.09491495296952122, -0.4757700972565052],
        [0.09491495296952122, 1.30492400325953],
    );
    let two = |damping, stiffness| TwoMassParts {
        operator: Impedance { mass: 0.1, damping, stiffness },
        device: DampedMass { mass: 0.2, damping: 0.001 },
        link: ElasticJoint { stiffness: 5000.0, damping: 1.0 },
    };
    compare(
        scene(
            TwoMassBody::new(two(0.2, 50.0), 1.0 / RATE).expect("two masses").starting(-0.004, 0.0),
            [two(0.2, 50.0), two(2.0, 400.0), two(0.1, 20.0)],
        ),
        [0.0220426561726144, 0.46729193289296367],
        [-0.09657997060256574, -0.5094424475242547],
        [0.09657997060256574, 1.3310687896696758],
    );
}

/// Each true interval against the series in double-double, and the nominal one in the sample.
#[test]
fn a_jittered_body_moves_for_the_true_interval() {
    hold(500, uniform16(any::<Bits>()), |bits| {
        let parts = hand(&|at, least, most| log_between(bits[at], least, most));
        let deviation = log_between(bits[3], 1e-6, 1e-3);
        let Impedance { mass, damping, stiffness } = parts;
        let motion = Motion { mass, damping, stiffness, rest: 0.01 };
        let mut state = State { position: ordinary(bits[4], 0.01), velocity: 0.2 };
        let body = Body::new(parts, 1.0 / RATE).expect("a body").resting_at(motion.rest);
        let body = body.starting(state.position, state.velocity);
        let mut plant = body.jittered(parts, deviation, stub(bits[5])).expect("a jitter");
        let mut normal = stub::<f64>(bits[5]);
        prop_assert!(plant.start() == body.start());
        for _ in 0..20 {
            let interval = (1.0 / RATE + deviation * normal()).max(0.0);
            let next = motion.over(interval).step(&motion, state, 1.5);
            let sample = plant.advance(1.5);
            prop_assert!(sample.period == 1.0 / RATE);
            prop_assert!(sample.work == 1.5 * sample.displacement);
            prop_assert!(abs_diff_eq!(sample.position, next.position, epsilon = 1e-15));
            prop_assert!(abs_diff_eq!(sample.velocity, next.velocity, epsilon = 1e-13));
            let moved = next.position - state.position;
            prop_assert!(abs_diff_eq!(sample.displacement, moved, epsilon = 1e-15));
            state = next;
        }
        Ok(())
    });
}

/// No time passes where the jitter takes all of it, or is not a number.
#[test]
fn hostile_jitter_stops_the_body() {
    let parts = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
    let body = Body::new(parts, 1.0 / RATE).expect("a body").starting(0.01, 0.3);
    for wrong in [f64::NAN, f64::NEG_INFINITY, -1e300, -10.0] {
        let mut plant = body.jittered(parts, 1.0, move || wrong).expect("a jitter");
        let sample = plant.advance(1.0);
        assert_eq!((sample.position, sample.velocity), (0.01, 0.3), "{wrong}");
        assert_eq!((sample.displacement, sample.work, sample.period), (0.0, 0.0, 1.0 / RATE));
    }
    let mut plant = body.jittered(parts, 1.0, || f64::INFINITY).expect("a jitter");
    let sample: PortSample<f64> = plant.advance(1.0);
    assert!(sample.finite());
}

/// A grip around a jitter takes effect; of rows with one tick the last counts; a row at tick 0 holds at once.
#[test]
fn a_grip_takes_hold_at_its_tick() {
    let loose = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
    let firm = Impedance { stiffness: 900.0, ..loose };
    let body = |parts| Body::new(parts, 1.0 / RATE).expect("a body").starting(0.01, 0.3);
    let mut plant = body(loose)
        .jittered(loose, 0.0, || 1.0)
        .expect("a jitter")
        .gripped(loose, [(0, loose), (0, firm), (3, firm), (3, loose)])
        .expect("a grip");
    let mut told = body(firm);
    for tick in 0..6 {
        if tick == 3 {
            told.reshape(loose, 1.0 / RATE).expect("loose");
        }
        assert_eq!(plant.advance(0.5), told.advance(0.5), "{tick}");
    }
}

/// A load acts along x only.
#[test]
fn a_load_pushes_along_the_first_axis() {
    let parts = Impedance { mass: 0.5, damping: 0.0, stiffness: 0.0 };
    let load = FirstAxis::of(Constant::new(2.0).expect("a load"), Vector2::zeros());
    let mut plant = Body::new(parts, 0.25).expect("a body").pushed(load);
    let sample = plant.advance(Vector2::new(0.0, 1.0));
    // x = ± f t² / (2 m)
    assert_eq!(sample.position, Vector2::new(0.125, -0.0625));
    assert_eq!(sample.applied, Vector2::new(0.0, 1.0));
    assert_eq!(sample.work, Vector2::new(0.0, -0.0625));
}

#[test]
fn invalid_disturbances_are_refused() {
    let parts = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
    let wrong = Impedance { stiffness: -1.0, ..parts };
    let body = Body::<f64>::new(parts, 1.0 / RATE).expect("a body");
    let grip = |table: &[(u64, Impedance<f64>)]| {
        body.gripped(parts, table).map(|_| ()).expect_err("no grip")
    };
    let named = |error: ParameterError| (error.parameter, error.requirement);
    let falling = grip(&[(5, parts), (4, parts)]);
    assert_eq!(named(falling), ("tick", Requirement::AtLeast(5.0)));
    let active = grip(&[(0, parts), (4, wrong)]);
    assert_eq!(named(active), ("stiffness", Requirement::NonNegative));
    for bad in [-1e-9, f64::NAN, f64::INFINITY] {
        let error = body.jittered(parts, bad, || 0.0).map(|_| ()).expect_err("no jitter");
        assert_eq!(named(error), ("deviation", Requirement::NonNegative));
    }
    let error = body.jittered(wrong, 0.0, || 0.0).map(|_| ()).expect_err("no jitter");
    assert_eq!(named(error), ("stiffness", Requirement::NonNegative));
    let active = body.gripped(wrong, []).map(|_| ()).expect_err("no grip");
    assert_eq!(named(active), ("stiffness", Requirement::NonNegative));
}
