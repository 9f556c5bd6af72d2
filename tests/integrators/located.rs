//! Steps that end where the motion switches.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::laws::Samples;
use lyapunov::{
    Plant, Requirement, Scalar,
    bodies::{Body, Friction, Impedance, IntegratedPlant, Stribeck, Transition},
    integrators::{
        Adaptive, DormandPrince5, DormandPrince8, EventLocating, Exact, ImplicitMidpoint,
        Integrator, Oscillator, RungeKuttaNystrom4, SemiImplicitEuler, State, StickSlipOscillator,
        WalledOscillator,
    },
};

use crate::orders::{damped, slope};
use crate::{hand, moved};

/// A hand without damping, in front of a wall that is 40 times as stiff, with its surface at 1 mm.
const FREE: Impedance<f64> = Impedance { mass: 0.3, damping: 0.0, stiffness: 50.0 };
const WALL: f64 = 2000.0;
const SURFACE: f64 = 0.001;
const START: [f64; 2] = [-0.004, 0.05];
const PERIOD: f64 = 0.5;

/// The instant at which the closed form of one piece is first on the other side, by bisection between `near` and `far`.
fn crossing(beyond: impl Fn(f64) -> bool, mut near: f64, mut far: f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (near + far);
        if beyond(middle) { far = middle } else { near = middle }
    }
    far
}

/// The motion against the wall and back, piece by piece in closed form, and the number of contacts.
fn bounced(t: f64) -> ([f64; 2], u32) {
    let touching = Impedance { stiffness: FREE.stiffness + WALL, ..FREE };
    let (mut state, mut left, mut contact, mut touched) = (START, t, false, 0);
    loop {
        let (parts, force) = if contact { (touching, -WALL * SURFACE) } else { (FREE, 0.0) };
        let at = |time: f64| damped(parts, state, force, time);
        let beyond = |time: f64| (at(time)[0] > SURFACE) != contact;
        // No piece is shorter than a millisecond, so none is stepped over.
        let found = (1..).map(|n| 1e-3 * f64::from(n)).take_while(|&time| time < left + 1e-3);
        let Some(after) = found.into_iter().find(|&time| beyond(time)) else {
            return (at(left), touched);
        };
        let instant = crossing(beyond, after - 1e-3, after);
        if instant >= left {
            return (at(left), touched);
        }
        (state, left, contact) = (at(instant), left - instant, !contact);
        touched += u32::from(contact);
    }
}

/// The order with which errors fall from one count of steps to the next, for many positions of the impact within a
/// step.
fn order(integrator: impl Integrator<f64, WalledOscillator<f64>> + Copy, counts: [u32; 4]) -> f64 {
    slope(counts.map(|steps| {
        let ends = [0.0, 0.013, 0.026, 0.039].map(|more| {
            let period = PERIOD + more;
            let ([x, v], touched) = bounced(period);
            assert!(touched >= 1);
            let dynamics = WalledOscillator::new(FREE, WALL, SURFACE).expect("parts");
            let mut plant = moved::<f64, _, _>(dynamics, integrator, period, steps)
                .starting(START[0], START[1]);
            let sample = plant.advance(0.0);
            (sample.position - x).hypot((sample.velocity - v) / 80.0)
        });
        (1.0 / f64::from(steps), ends.iter().map(|end| end * end).sum::<f64>().sqrt())
    }))
}

#[test]
fn the_order_is_kept_across_an_impact_and_falls_without_a_located_instant() {
    let at_least = |order: f64, expected: f64| {
        assert!(order > expected - 0.3, "{order}, not {expected}");
    };
    at_least(order(EventLocating::new(RungeKuttaNystrom4), [128, 256, 512, 1024]), 4.0);
    at_least(order(EventLocating::new(ImplicitMidpoint), [128, 256, 512, 1024]), 2.0);
    at_least(order(EventLocating::new(SemiImplicitEuler), [512, 1024, 2048, 4096]), 1.0);
    at_least(order(EventLocating::new(DormandPrince5), [128, 181, 256, 362]), 5.0);
    let blind = order(RungeKuttaNystrom4, [128, 256, 512, 1024]);
    assert!(blind < 3.0, "{blind}");
}

#[test]
fn adaptive_steps_meet_their_tolerance_across_an_impact() {
    let ([x, _], _) = bounced(PERIOD);
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let pair = Adaptive::new(DormandPrince8, tolerance).expect("a tolerance");
        let dynamics = WalledOscillator::new(FREE, WALL, SURFACE).expect("parts");
        let mut plant = moved::<f64, _, _>(dynamics, EventLocating::new(pair), PERIOD, 50)
            .starting(START[0], START[1]);
        let error = (plant.advance(0.0).position - x).abs();
        assert!(error < 100.0 * tolerance, "{error:e} at {tolerance:e}");
    }
}

/// Exact in each piece, and cut between them: the closed form to rounding, however long the step.
#[test]
fn exact_pieces_are_the_closed_form() {
    for more in [0.0, 0.013, 0.026, 0.039] {
        let ([x, v], touched) = bounced(PERIOD + more);
        assert!(touched >= 1);
        for steps in [50, 77, 512] {
            let dynamics = WalledOscillator::new(FREE, WALL, SURFACE).expect("parts");
            let mut plant = moved::<f64, _, _>(
                dynamics,
                EventLocating::new(Exact::new()),
                PERIOD + more,
                steps,
            )
            .starting(START[0], START[1]);
            let sample = plant.advance(0.0);
            let error = (sample.position - x).hypot((sample.velocity - v) / 80.0);
            assert!(error < 1e-13, "{error:e} in {steps} steps");
        }
    }
}

fn law<T: Scalar>() -> Stribeck<T> {
    Stribeck { coulomb: T::of(0.5), breakaway: T::of(1.0), stribeck_velocity: T::of(0.02) }
}

fn block<T: Scalar>() -> Impedance<T> {
    Impedance { mass: T::of(0.5), damping: T::of(0.4), stiffness: T::of(200.0) }
}

/// The instant within `period` at which a step from `from` first ends the motion in the direction `sense`, by
/// bisection.
fn first<I>(integrator: I, from: State<f64>, effort: f64, period: f64, sense: f64) -> f64
where
    I: Integrator<f64, StickSlipOscillator<f64>> + Copy,
{
    let dynamics = StickSlipOscillator::new(block(), law()).expect("parts");
    let ended = |time: f64| {
        let gain = { integrator }.step(&dynamics, from, effort, time);
        sense * (from.velocity + gain.velocity) <= 0.0
    };
    crossing(ended, 0.0, period)
}

#[test]
fn it_sticks_and_slips_where_and_when_the_exact_body_does() {
    let period = 1e-3;
    let rubbing = StickSlipOscillator::new(block(), law()).expect("parts");
    let mut plant = moved::<f64, _, _>(rubbing, EventLocating::new(DormandPrince8), period, 8)
        .starting(0.02_f64, 0.0);
    let body = Body::new(block(), period).expect("a body").starting(0.02, 0.0);
    let mut exact = Friction::new(body, block(), law()).expect("friction");
    let (mut stuck, mut slipped, mut reversed) = (0, 0, 0);
    let mut before = State { position: 0.02_f64, velocity: 0.0_f64 };
    for tick in 0..20_000_u32 {
        let effort = 1.5 * (f64::from(tick) * 0.005).sin() + 0.7 * (f64::from(tick) * 0.023).sin();
        // Each tick starts from the same state: friction that falls with speed is a negative damper and amplifies
        // differences.
        plant = plant.starting_from(before);
        let (one, other) = (plant.advance(effort), exact.advance(effort));
        assert!(abs_diff_eq!(one.position, other.position, epsilon = 1e-12), "{tick}");
        assert!(abs_diff_eq!(one.velocity, other.velocity, epsilon = 1e-11), "{tick}");
        let all: Vec<_> = exact.transitions().last(0).collect();
        for &(instant, transition) in all.iter().take(1) {
            match transition {
                Transition::Slip => {
                    slipped += 1;
                    assert!(instant == 0.0 && before.velocity == 0.0, "{tick}");
                }
                Transition::Stick | Transition::Reverse => {
                    let sense = before.velocity.signum();
                    let found =
                        first(EventLocating::new(DormandPrince8), before, effort, period, sense);
                    assert!(
                        abs_diff_eq!(found, instant, epsilon = 1e-9),
                        "{tick}: {found} for {instant}"
                    );
                    let sticks = transition == Transition::Stick;
                    (stuck, reversed) = (stuck + u32::from(sticks), reversed + u32::from(!sticks));
                    assert!(all.len() > 1 || (one.velocity == 0.0) == sticks, "{tick}");
                }
                Transition::Cut => panic!("{tick}"),
            }
        }
        before = State { position: other.position, velocity: other.velocity };
    }
    assert!(stuck > 10 && slipped > 10, "{stuck} {slipped} {reversed}");
}

#[test]
fn a_stuck_mass_does_not_move_by_a_bit_and_zero_friction_changes_nothing() {
    let rubbing = StickSlipOscillator::new(block::<f64>(), law()).expect("parts");
    let mut plant =
        moved(rubbing, EventLocating::new(ImplicitMidpoint), 1e-3, 3).starting(0.004, 0.0);
    for effort in [0.0, 0.1, -1.7, 0.15] {
        let sample = plant.advance(effort);
        assert_eq!((sample.position, sample.velocity), (0.004, 0.0));
    }
    assert!(plant.advance(-2.0).velocity > 0.0);
    let none = Stribeck { coulomb: 0.0, breakaway: 0.0, stribeck_velocity: 1.0 };
    let rubbing = StickSlipOscillator::new(block(), none).expect("parts");
    let free = Oscillator::new(block::<f64>()).expect("parts");
    let mut plant = moved::<f64, _, _>(rubbing, EventLocating::new(ImplicitMidpoint), 1e-3, 1)
        .starting(0.004_f64, 0.1);
    let mut other = moved::<f64, _, _>(free, ImplicitMidpoint, 1e-3, 1).starting(0.004_f64, 0.1);
    for _ in 0..1000 {
        let (one, other) = (plant.advance(0.1), other.advance(0.1));
        // Cutting a step where the motion turns changes its error, by (h ω)³ / 12 of the swing at each turn.
        assert_abs_diff_eq!(one.position, other.position, epsilon = 1e-6);
    }
}

#[test]
fn the_implicit_rule_resolves_a_friction_that_falls() {
    let exact = || {
        let body = Body::new(block(), 0.1).expect("a body").starting(0.02, 0.0);
        Friction::new(body, block(), law()).expect("friction").advance(0.0)
    };
    let [x, v] = [exact().position, exact().velocity];
    let order = slope([64, 128, 256, 512].map(|steps| {
        let rubbing = StickSlipOscillator::new(block(), law()).expect("parts");
        let plant = moved::<f64, _, _>(rubbing, EventLocating::new(ImplicitMidpoint), 0.1, steps);
        let sample = plant.starting(0.02, 0.0).advance(0.0);
        let error = (sample.position - x).hypot((sample.velocity - v) / 20.0);
        (1.0 / f64::from(steps), error)
    }));
    assert!(abs_diff_eq!(order, 2.0, epsilon = 0.2), "{order}");
}

#[test]
fn every_step_ends_whatever_the_state() {
    let rubbing = StickSlipOscillator::new(block::<f64>(), law()).expect("parts");
    let wall = WalledOscillator::new(FREE, 1e300, 0.0).expect("parts");
    for value in [f64::NAN, f64::INFINITY, 1e308, -1e308, 1e-308, 0.0] {
        for (x, v, f) in [(value, 0.1, 0.1), (0.1, value, 0.1), (-0.1, 0.1, value)] {
            let from = State { position: x, velocity: v };
            let mut pair =
                EventLocating::new(Adaptive::new(DormandPrince5, 1e-6).expect("a tolerance"));
            EventLocating::new(RungeKuttaNystrom4).step(&rubbing, from, f, 1e-3);
            pair.step(&rubbing, from, f, 1e-3);
            EventLocating::new(RungeKuttaNystrom4).step(&wall, from, f, 1e-3);
        }
    }
    let error =
        StickSlipOscillator::new(block(), Stribeck { coulomb: 2.0, ..law() }).expect_err("law");
    assert_eq!((error.parameter, error.requirement), ("coulomb", Requirement::AtMost(1.0)));
    let error = WalledOscillator::new(FREE, -1.0, 0.0).expect_err("no wall");
    assert_eq!((error.parameter, error.requirement), ("wall stiffness", Requirement::NonNegative));
    let stiff = Impedance { stiffness: 5e307, ..FREE };
    let error = WalledOscillator::new(stiff, 1.5e308, 0.0).expect_err("out of range together");
    assert_eq!((error.parameter, error.value), ("wall stiffness", 1.5e308));
    let error = WalledOscillator::new(FREE, 1.0, f64::NAN).expect_err("no surface");
    assert_eq!((error.parameter, error.requirement), ("surface", Requirement::Finite));
}

fn lanes_are_scalars<T: Scalar, L: Scalar>() {
    let place = |lane: usize| 0.01 * lane as f64 - 0.03;
    macro_rules! with {
        ($($dynamics:ident($($part:expr),+), $integrator:expr);+ $(;)?) => {$({
            let wide = $dynamics::new($($part),+).expect("parts");
            let wide = IntegratedPlant::<L, _, _>::new(wide, $integrator, L::of(0.02), 2).expect("a plant");
            let mut wide = wide.starting(L::from_lanes(place), L::of(0.3));
            let scalar = |lane| {
                let one = $dynamics::new($($part),+).expect("parts");
                let one = IntegratedPlant::<T, _, _>::new(one, $integrator, T::of(0.02), 2).expect("a plant");
                one.starting(T::of(place(lane)), T::of(0.3))
            };
            let mut scalars: Vec<_> = (0..L::LANES).map(scalar).collect();
            for (_, effort) in Samples::<L>::new(L::of(1e-3)) {
                let sample = wide.advance(effort);
                for (lane, scalar) in scalars.iter_mut().enumerate() {
                    let alone = scalar.advance(T::of(effort.lane(lane)));
                    let (one, other) = (sample.position.lane(lane), alone.position.lane(0));
                    assert_eq!(one.to_bits(), other.to_bits());
                    let (one, other) = (sample.velocity.lane(lane), alone.velocity.lane(0));
                    assert_eq!(one.to_bits(), other.to_bits());
                }
            }
        })+};
    }
    with!(
        StickSlipOscillator(block(), law()), EventLocating::new(RungeKuttaNystrom4);
        StickSlipOscillator(block(), law()), EventLocating::new(ImplicitMidpoint);
        StickSlipOscillator(block(), law()),
            EventLocating::new(Adaptive::new(DormandPrince5, Scalar::of(1e-6)).expect("a tolerance"));
        WalledOscillator(hand(), Scalar::of(2000.0), Scalar::of(0.001)), EventLocating::new(RungeKuttaNystrom4);
        WalledOscillator(hand(), Scalar::of(2000.0), Scalar::of(0.001)), EventLocating::new(Exact::new());
        WalledOscillator(hand(), Scalar::of(2000.0), Scalar::of(0.001)),
            EventLocating::new(Adaptive::new(DormandPrince8, Scalar::of(1e-6)).expect("a tolerance"));
    );
}

#[test]
fn each_lane_has_its_own_instants_and_is_its_scalar_run_bit_for_bit() {
    lanes_are_scalars::<f64, AutoF64x4>();
    lanes_are_scalars::<f64, WideF64x4>();
    lanes_are_scalars::<f32, AutoF32x8>();
}
