//! Models against closed forms, published numbers and the invariants of mechanics.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    Plant,
    integrators::RungeKutta4,
    models::{
        AffinePlant, ArmEnergy, ControlAffine, LegEnergy, LyapunovFunction, MotorEnergy,
        QuadraticForm, RigidLink, TwoLinkArm, UprightEnergy, VanDerPol, WithState,
    },
};
use nalgebra::{SVector, Vector1, Vector2, Vector3, Vector4};

use crate::{Draw, leg, motor};

const GRAVITY: f64 = 9.80665;

/// Limit cycle at μ = 1: amplitude 2.00862 and period 6.66329.
#[test]
fn van_der_pol_goes_to_the_published_limit_cycle() {
    for start in [Vector2::new(0.01, 0.0), Vector2::new(0.0, -4.0)] {
        let oscillator = VanDerPol::new(1.0).expect("a parameter");
        let circle = QuadraticForm::sum_of_squares();
        let step = 1e-3;
        let mut plant = AffinePlant::new(oscillator, circle, RungeKutta4, step, 1)
            .expect("a plant")
            .starting(start);
        let (mut amplitude, mut crossings) = (0.0_f64, Vec::new());
        for tick in 0..120_000 {
            let before = plant.state()[0];
            plant.advance(WithState::of_input(Vector1::new(0.0)));
            let now = plant.state()[0];
            if tick > 60_000 {
                amplitude = amplitude.max(now);
                if before < 0.0 && now >= 0.0 {
                    crossings.push(step * (f64::from(tick) + before / (before - now)));
                }
            }
        }
        assert!(abs_diff_eq!(amplitude, 2.00862, epsilon = 1e-4), "{amplitude}");
        let period = crossings[1] - crossings[0];
        assert!(abs_diff_eq!(period, 6.66329, epsilon = 1e-4), "{period}");
    }
}

/// Near upright and without friction the angle is θ₀ cosh(√(g / l) t).
#[test]
fn the_pendulum_falls_as_its_linearisation_does() {
    let pendulum = lyapunov::models::InvertedPendulum::new(0.5, 0.4, 0.0).expect("a pendulum");
    let energy = UprightEnergy::new(pendulum, 6.0).expect("an energy");
    let lean = 1e-7;
    let mut plant = AffinePlant::new(pendulum, energy, RungeKutta4, 1e-3, 1)
        .expect("a plant")
        .starting(Vector2::new(lean, 0.0));
    for _ in 0..1000 {
        plant.advance(WithState::of_input(Vector1::new(0.0)));
    }
    let exact = lean * (GRAVITY / 0.4_f64).sqrt().cosh();
    assert_abs_diff_eq!(plant.state()[0] / exact, 1.0, epsilon = 1e-8);
}

/// Held over a tick, `x⁺ = x + T u` and `q⁺ = q − k (T x + T² u / 2)` with `u = q / m`: a map with the determinant
/// `1 + k T² / (2 m)`, so the hold alone makes it gain.
#[test]
fn the_admittance_device_moves_as_its_map_does() {
    let (stiffness, mass, period) = (1000.0_f64, 0.2, 1e-3);
    let device = lyapunov::models::AdmittanceDevice::new(stiffness).expect("a device");
    let energy = device.energy(mass).expect("an energy");
    let start = Vector2::new(5e-3, 0.0);
    let mut plant =
        AffinePlant::new(device, energy, RungeKutta4, period, 1).expect("a plant").starting(start);
    assert_eq!(energy.value(start), 0.5 * stiffness * 5e-3 * 5e-3);
    let (mut place, mut impulse) = (5e-3, 0.0);
    for _ in 0..2000 {
        let flow = impulse / mass;
        assert_eq!(device.flow(&energy, plant.state())[0], stiffness * plant.state()[0]);
        plant.advance(WithState::of_input(Vector1::new(-plant.state()[1] / mass)));
        impulse -= stiffness * (period * place + 0.5 * period * period * flow);
        place += period * flow;
        let off = (plant.state() - Vector2::new(place, impulse)).abs();
        assert!(off[0] < 1e-12 && off[1] < 1e-11, "{off}");
    }
    let rotation = (stiffness / mass).sqrt();
    let gained = energy.value(plant.state()) / energy.value(start);
    let expected = (1.0 + 0.5 * (rotation * period).powi(2)).powi(2000);
    assert!((gained / expected).ln().abs() < 0.05, "{gained} {expected}");
}

#[test]
fn the_motor_runs_at_the_speed_of_its_data_sheet_and_its_loop_at_rouths_limit() {
    let rest = MotorEnergy::new(motor(), 0.05, 0.004).expect("a function");
    let turned = |gain: f64, push: f64, start: Vector3<f64>, ticks: u32| {
        let mut plant =
            AffinePlant::new(motor(), rest, RungeKutta4, 1e-5, 1).expect("a plant").starting(start);
        let mut largest = 0.0_f64;
        for tick in 0..ticks {
            let voltage = push - gain * plant.state()[0];
            plant.advance(WithState::of_input(Vector1::new(-voltage)));
            if tick > ticks / 2 {
                largest = largest.max(plant.state()[0].abs());
            }
        }
        (plant.state(), largest)
    };
    // ω = K u / (b R + K²), i = b ω / K.
    let (state, _) = turned(0.0, 6.0, Vector3::zeros(), 200_000);
    let speed = 0.05 * 6.0 / (1e-5 + 0.0025);
    assert!(
        abs_diff_eq!(state[1] / speed, 1.0, epsilon = 1e-9)
            && abs_diff_eq!(state[2] * 0.05 / (1e-5 * speed), 1.0, epsilon = 1e-6)
    );
    let critical: f64 = motor().critical_gain();
    let start = Vector3::new(1.0, 0.0, 0.0);
    let swing = |gain: f64| turned(gain, 0.0, start, 200_000).1;
    assert!(swing(0.9 * critical) < 0.5, "{}", swing(0.9 * critical));
    assert!(swing(1.1 * critical) > 2.0, "{}", swing(1.1 * critical));
}

/// Two points at the ends of rods without mass, in Cartesian coordinates: energy and moment about the shoulder.
fn points(state: Vector4<f64>, [one, two]: [(f64, f64); 2]) -> (f64, f64) {
    let ((m1, l1), (m2, l2)) = (one, two);
    let (a, b) = (state[0], state[0] + state[1]);
    let (da, db) = (state[2], state[2] + state[3]);
    let first = [l1 * a.sin(), -l1 * a.cos()];
    let first_moves = [l1 * a.cos() * da, l1 * a.sin() * da];
    let second = [first[0] + l2 * b.sin(), first[1] - l2 * b.cos()];
    let second_moves = [first_moves[0] + l2 * b.cos() * db, first_moves[1] + l2 * b.sin() * db];
    let point = |mass: f64, at: [f64; 2], moves: [f64; 2]| {
        let kinetic = 0.5 * mass * (moves[0] * moves[0] + moves[1] * moves[1]);
        (kinetic + mass * GRAVITY * at[1], mass * (at[0] * moves[1] - at[1] * moves[0]))
    };
    let ((e1, p1), (e2, p2)) = (point(m1, first, first_moves), point(m2, second, second_moves));
    (e1 + e2, p1 + p2)
}

#[test]
fn an_arm_of_points_has_the_energy_of_its_points_and_keeps_the_invariants() {
    let parts = [(1.5, 0.4), (0.8, 0.3)];
    let [upper, lower] = parts.map(|(mass, length)| RigidLink::point(mass, length));
    let hanging = TwoLinkArm::new(upper, lower).expect("an arm");
    let energy = ArmEnergy::new(hanging, [0.0; 2]).expect("an energy");
    let mut draw = Draw(5);
    let (lowest, _) = points(Vector4::zeros(), parts);
    for _ in 0..1000 {
        let state = draw.vector(3.0);
        let (exact, _) = points(state, parts);
        assert_abs_diff_eq!(energy.value(state), exact - lowest, epsilon = 1e-12);
    }
    let start = Vector4::new(2.0, -1.0, 0.5, 3.0);
    let none = WithState::of_input(Vector2::zeros());
    let mut plant =
        AffinePlant::new(hanging, energy, RungeKutta4, 1e-3, 4).expect("a plant").starting(start);
    for _ in 0..10_000 {
        plant.advance(none);
    }
    let (before, now) = (points(start, parts).0, points(plant.state(), parts).0);
    assert!(abs_diff_eq!(now, before, epsilon = 1e-6), "{now} is not {before}");
    assert!((plant.state() - start).norm() > 0.1);

    let level = hanging.horizontal();
    let energy = ArmEnergy::new(level, [0.0; 2]).expect("an energy");
    let mut plant =
        AffinePlant::new(level, energy, RungeKutta4, 1e-3, 4).expect("a plant").starting(start);
    for _ in 0..10_000 {
        plant.advance(none);
    }
    let (_, turning) = points(start, parts);
    let (_, now) = points(plant.state(), parts);
    assert!(
        abs_diff_eq!(now, turning, epsilon = 1e-7),
        "the moment about the shoulder: {now} is not {turning}"
    );
    assert_abs_diff_eq!(energy.value(plant.state()), energy.value(start), epsilon = 1e-7);
}

/// A stiff arm of rods is one rod: `M₁₁` of the stretched arm is that of the rod about its end.
#[test]
fn two_like_rods_in_line_are_one_rod() {
    let half = RigidLink::rod(1.0, 0.5);
    let arm = TwoLinkArm::new(half, half).expect("an arm");
    let energy = ArmEnergy::new(arm.horizontal(), [0.0; 2]).expect("an energy");
    let rate = Vector4::new(0.3, 0.0, 1.0, 0.0);
    let whole: f64 = 2.0 * 1.0 / 3.0; // kg·m²: m l² / 3
    assert_abs_diff_eq!(energy.value(rate), 0.5 * whole, epsilon = 1e-15);
    // The least inertia against the smallest value of the quadratic form over all directions and postures.
    let least = (0..200)
        .flat_map(|elbow| (0..2000).map(move |way| (elbow, way)))
        .map(|(elbow, way)| {
            let (elbow, way) = (f64::from(elbow) * 0.0314, f64::from(way) * 0.00157);
            2.0 * energy.value(Vector4::new(0.0, elbow, way.cos(), way.sin()))
        })
        .fold(f64::INFINITY, f64::min);
    assert!(
        abs_diff_eq!(arm.least_inertia() / least, 1.0, epsilon = 1e-4),
        "{} {least}",
        arm.least_inertia()
    );
}

#[test]
fn the_leg_stands_where_it_is_held_and_its_foot_is_where_geometry_puts_it() {
    let leg = leg::<f64>();
    let held = leg.rate(SVector::zeros(), leg.holding());
    assert!(held.norm() < 1e-12, "{held}");
    let mut draw = Draw(6);
    let foot = |hip: f64, knee: f64| 0.4 * hip.cos() + 0.45 * (hip + knee).cos();
    for _ in 0..1000 {
        let state: Vector4<f64> = draw.vector(1.0);
        let exact = foot(0.3 + state[0], -0.6 + state[1]) - foot(0.3, -0.6);
        assert_abs_diff_eq!(leg.depth(state), exact, epsilon = 1e-14);
    }
}

/// Under a light upper link that carries a point, `M₁₁ M₂₂ − M₁₂²` would lose every digit in `f32`.
#[test]
fn a_light_upper_link_keeps_its_inertia_in_single_precision() {
    let point = RigidLink::point(1.0_f32, 0.5);
    for mass in [1e-3_f32, 1e-6, 1e-9] {
        let arm = TwoLinkArm::new(RigidLink::rod(mass, 0.5), point).expect("an arm");
        // The determinant m₁ l₁² m₂ l₂² / 3 over the trace 5 m₂ l²: to first order in the light mass.
        let exact = f64::from(mass) * 0.25 * 0.25 / 3.0 / (5.0 * 0.25);
        assert_abs_diff_eq!(f64::from(arm.least_inertia()) / exact, 1.0, epsilon = 1e-3);
    }
}

/// Folded, its ends meet: what is left of the inertia about the shoulder is the light link's.
#[test]
fn a_folded_arm_of_a_light_upper_link_keeps_its_inverse_in_single_precision() {
    let point = |mass| RigidLink::point(mass, 0.5);
    for mass in [1e-3, 1e-6, 1e-9] {
        let of =
            |mass: f32| TwoLinkArm::new(RigidLink::rod(mass, 0.5), point(1.0)).expect("an arm");
        for elbow in [std::f32::consts::PI, 3.1, -2.5] {
            let found = of(mass).input_fields(Vector4::new(0.0, elbow, 0.0, 0.0));
            let (light, turned) = (f64::from(mass) * 0.25 / 3.0, f64::from(elbow));
            // M of a rod and of a point at the elbow's distance 2 l |cos(q₂ / 2)|, by Cramer's rule.
            let reach = (2.0 * 0.5 * (turned / 2.0).cos()).powi(2);
            let exact = (light + reach) / (light * 0.25 + (0.25 * turned.sin()).powi(2));
            assert_abs_diff_eq!(f64::from(found[1][3]) / exact, 1.0, epsilon = 1e-4);
        }
    }
}

/// Each of a thousand short steps is far below what an angle of 1 rad can tell in `f32`.
#[test]
fn many_short_steps_of_an_arm_lose_no_motion() {
    let rod = RigidLink::rod(1.0_f32, 0.5);
    let arm = TwoLinkArm::new(rod, rod).expect("an arm").horizontal();
    let energy = ArmEnergy::new(arm, [0.0; 2]).expect("an energy");
    for steps in [1, 100, 1000] {
        let plant = AffinePlant::new(arm, energy, RungeKutta4, 1e-3, steps).expect("a plant");
        let mut plant = plant.starting(Vector4::new(1.0, 0.0, 5e-3, 0.0));
        for _ in 0..1000 {
            plant.advance(WithState::of_input(Vector2::zeros()));
        }
        // Stretched and turning as one, but for what the elbow opens.
        let turned = f64::from(plant.state()[0]) - 1.0;
        assert!((turned / 5e-3 - 1.0).abs() < 5e-3, "{steps} steps: {turned} rad");
    }
}

/// A difference of two sines of gravity would have two digits left.
#[test]
fn the_legs_gradient_keeps_its_digits_near_the_posture() {
    let energy = LegEnergy::new(leg::<f32>(), [200.0_f32, 150.0]).expect("an energy");
    let exact = LegEnergy::new(leg::<f64>(), [200.0, 150.0]).expect("an energy");
    let apart = Vector4::new(-3e-6_f32, 2e-6, 0.0, 0.0);
    let (found, true_one) = (energy.gradient(apart), exact.gradient(apart.cast::<f64>()));
    for joint in 0..2 {
        let error = f64::from(found[joint]) / true_one[joint] - 1.0;
        assert!(error.abs() < 1e-5, "{joint}: {found:?}, {true_one:?}");
    }
}

/// Without delay, spring and damper take `q̇ᵀ D q̇` from V, and the ground never adds: in the air to the last digits.
#[test]
fn the_ground_under_the_leg_only_dissipates() {
    let leg = leg::<f64>();
    let (stiffness, damping) = ([150.0, 80.0], 3.0);
    let energy = LegEnergy::new(leg, stiffness).expect("an energy");
    let (mut draw, mut standing) = (Draw(7), 0);
    for _ in 0..20_000 {
        let state: Vector4<f64> = draw.vector(0.5);
        let spring = |joint: usize| -stiffness[joint] * state[joint] - damping * state[2 + joint];
        let input = leg.holding() + Vector2::new(spring(0), spring(1));
        let rate = energy.gradient(state).dot(&leg.rate(state, input));
        let braked = -damping * (state[2] * state[2] + state[3] * state[3]);
        if leg.depth(state) < 0.0 {
            assert!(abs_diff_eq!(rate, braked, epsilon = 1e-10), "{rate} is not {braked}");
        } else {
            standing += 1;
            assert!(rate < braked + 1e-9, "{rate} is above {braked}");
        }
    }
    assert!(standing > 1000);
}

/// `Jᵀ F` with the differences of the foot's place for `J`.
#[test]
fn the_ground_pushes_the_leg_by_its_law() {
    let leg = leg::<f64>();
    let arm = TwoLinkArm::new(RigidLink::rod(4.0, 0.4), RigidLink::rod(2.5, 0.45)).expect("an arm");
    let posture = Vector4::new(0.3, -0.6, 0.0, 0.0);
    let place = |q: Vector4<f64>| {
        let (hip, shank) = (q[0], q[0] + q[1]);
        let over = 0.4 * hip.sin() + 0.45 * shank.sin();
        Vector2::new(over, -(0.4 * hip.cos() + 0.45 * shank.cos()))
    };
    let (mut draw, mut standing) = (Draw(8), 0);
    for _ in 0..1000 {
        let state: Vector4<f64> = draw.vector(0.5);
        let q = state + posture;
        let column = |joint: usize| {
            let step = Vector4::from_fn(|row, _| if row == joint { 1e-6 } else { 0.0 });
            (place(q + step) - place(q - step)) / 2e-6
        };
        let [hip, knee] = [column(0), column(1)];
        let velocity = hip * q[2] + knee * q[3];
        let depth = (place(posture) - place(q))[1].max(0.0);
        standing += usize::from(depth > 0.0);
        let load = 2e4 * depth * (1.0 - 0.5 * velocity[1]).max(0.0);
        let force = Vector2::new(-0.2 * load * velocity[0], load);
        let [first, second] = arm.input_fields(q);
        let pushed = first * hip.dot(&force) + second * knee.dot(&force);
        let expected = arm.drift(q) + pushed;
        let off = (leg.drift(state) - expected).norm();
        assert!(off < 1e-6 * (1.0 + expected.norm()), "{state}: off by {off}");
    }
    assert!(standing > 100);
}

/// A leg in the air is the arm, in other coordinates.
#[test]
fn in_the_air_the_leg_is_an_arm() {
    let leg = leg::<f64>();
    let arm = TwoLinkArm::new(RigidLink::rod(4.0, 0.4), RigidLink::rod(2.5, 0.45)).expect("an arm");
    let (state, posture) = (Vector4::new(0.3, -0.9, 1.0, -2.0), Vector4::new(0.3, -0.6, 0.0, 0.0));
    assert!(leg.depth(state) < 0.0);
    assert!((leg.drift(state) - arm.drift(state + posture)).norm() < 1e-12);
}

#[test]
fn along_its_spring_and_damper_the_motors_function_falls_as_by_hand() {
    // With i = i*, V̇ = −(b + d) ω² + L (i − i*) … = −(b + d) ω².
    let energy = MotorEnergy::new(motor(), 0.05, 0.004).expect("a function");
    let mut draw = Draw(8);
    for _ in 0..100 {
        let (angle, rate) = (draw.next(), 10.0 * draw.next());
        let wanted = -(0.05 * angle + 0.004 * rate) / 0.05;
        let state = Vector3::new(angle, rate, wanted);
        let rate_of_v = energy.gradient(state).dot(&motor().drift(state));
        assert_abs_diff_eq!(rate_of_v, -(1e-5 + 0.004) * rate * rate, epsilon = 1e-9);
        let flow = motor().flow(&energy, state + Vector3::new(0.0, 0.0, 0.7));
        assert!(abs_diff_eq!(flow[0], 0.7, epsilon = 1e-12), "the flow is the current's error");
    }
}
