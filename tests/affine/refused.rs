//! Refusal of invalid parameters, by name.

use lyapunov::{
    ParameterError, Requirement, Scalar,
    integrators::RungeKutta4,
    lanes::AutoF64x4,
    models::{
        AdmittanceDevice, AffinePlant, ArmEnergy, DcMotor, Decay, Ground, InvertedPendulum,
        LegEnergy, LyapunovFunction, MeasuredPlant, MotorEnergy, MotorParts, ProstheticLeg,
        QuadraticForm, RigidLink, TwoLinkArm, UprightEnergy, VanDerPol,
    },
};
use nalgebra::{Vector2, Vector4};

use crate::{Draw, arm, leg, motor, pendulum};

fn name<X>(refused: Result<X, ParameterError>) -> &'static str {
    refused.err().map_or("nothing", |error| error.parameter)
}

#[test]
fn parameters_are_refused_by_name() {
    assert_eq!(name(VanDerPol::new(-1.0)), "mu");
    assert_eq!(name(AdmittanceDevice::new(0.0)), "stiffness");
    assert_eq!(name(AdmittanceDevice::new(1e-40_f32)), "stiffness");
    assert_eq!(name(AdmittanceDevice::new(1.0).and_then(|it| it.energy(0.0))), "mass");
    assert_eq!(name(InvertedPendulum::new(0.0, 1.0, 0.0)), "mass");
    assert_eq!(name(InvertedPendulum::new(1.0, f64::NAN, 0.0)), "length");
    assert_eq!(name(InvertedPendulum::new(1.0, 1.0, -1.0)), "damping");
    assert_eq!(name(InvertedPendulum::new(1e-30_f32, 1e-10, 0.0)), "mass");
    assert_eq!(name(UprightEnergy::new(pendulum::<f64>(), 1.9)), "stiffness");
    assert_eq!(name(UprightEnergy::new(pendulum::<f64>(), 2.0)), "nothing");
    let parts = motor::<f64>().parts();
    assert_eq!(name(DcMotor::new(MotorParts { inertia: 0.0, ..parts })), "inertia");
    assert_eq!(name(DcMotor::new(MotorParts { friction: -1.0, ..parts })), "friction");
    assert_eq!(name(DcMotor::new(MotorParts { inductance: 0.0, ..parts })), "inductance");
    assert_eq!(name(MotorEnergy::new(motor::<f64>(), 0.0, 0.1)), "stiffness");
    assert_eq!(name(MotorEnergy::new(motor::<f64>(), 1.0, -0.1)), "damping");
    // The current would be infinite.
    assert_eq!(name(MotorEnergy::new(motor::<f32>(), 3e38, 0.1)), "stiffness");
    assert_eq!(name(MotorEnergy::new(motor::<f32>(), 1.0, 3e38)), "damping");
    let rod = RigidLink::rod(1.0, 0.5);
    assert_eq!(name(TwoLinkArm::new(RigidLink { mass: 0.0, ..rod }, rod)), "mass");
    assert_eq!(name(TwoLinkArm::new(rod, RigidLink { centre: -0.1, ..rod })), "centre");
    assert_eq!(name(ArmEnergy::new(arm::<f64>(), [1.0, -1.0])), "stiffness");
    let ground = Ground { stiffness: 1e4, damping: 0.5, drag: 0.2 };
    let stand = |posture, ground| ProstheticLeg::new(rod, rod, posture, ground);
    assert_eq!(name(stand([f64::INFINITY, 0.0], ground)), "posture");
    assert_eq!(name(stand([0.0; 2], Ground { drag: -1.0, ..ground })), "drag");
    assert_eq!(name(LegEnergy::new(leg::<f64>(), [0.0, 1.0])), "stiffness");
}

/// Each lane has a pendulum and a spring of its own: 4 and 9 N·m/rad to hold, 5 and 10 that hold them.
#[test]
fn a_lane_of_springs_is_refused_as_a_scalar_is() {
    let lanes = |even: f64, odd: f64| AutoF64x4::from_lanes(|lane| [even, odd][lane % 2]);
    // By `m g l` with 1 m.
    let gravity = InvertedPendulum::new(1.0, 1.0, 0.0).expect("a pendulum").weight();
    let masses = lanes(4.0 / gravity, 9.0 / gravity);
    let pendulum = InvertedPendulum::new(masses, lanes(1.0, 1.0), lanes(0.0, 0.0));
    let pendulum = pendulum.expect("a pendulum");
    assert!(UprightEnergy::new(pendulum, lanes(5.0, 10.0)).is_ok());
    let error = UprightEnergy::new(pendulum, lanes(5.0, 8.0)).expect_err("too soft");
    assert_eq!((error.parameter, error.value), ("stiffness", 8.0));
    assert!(UprightEnergy::new(pendulum, lanes(3.0, 10.0)).is_err());
}

/// The least curvature over all directions of `energy` in the posture, by second differences, with springs softer by `less`.
fn least_curvature(energy: LegEnergy<f64>, less: [f64; 2]) -> f64 {
    let step = 1e-3;
    let along = |way: f64| {
        let (hip, knee) = (step * way.cos(), step * way.sin());
        let value = |hip: f64, knee: f64| energy.value(Vector4::new(hip, knee, 0.0, 0.0));
        let softer = less[0] * hip * hip + less[1] * knee * knee;
        (value(hip, knee) + value(-hip, -knee) - softer) / (step * step)
    };
    (0..2000).map(|way| along(f64::from(way) * 0.00157)).fold(f64::INFINITY, f64::min)
}

#[test]
fn springs_that_do_not_hold_the_leg_against_gravity_are_refused() {
    let air = Ground { stiffness: 0.0, damping: 0.0, drag: 0.0 };
    let [thigh, shank] = [(4.0, 0.4), (2.5, 0.45)].map(|(m, l)| RigidLink::rod(m, l));
    let (mut draw, mut held, mut refused) = (Draw(9), 0, 0);
    for _ in 0..300 {
        let drawn: Vector4<f64> = draw.vector(1.0);
        let posture = [3.2 * drawn[0], 3.2 * drawn[1]];
        let leg = ProstheticLeg::new(thigh, shank, posture, air).expect("a leg");
        // These hold the leg in any posture.
        let stiff = LegEnergy::new(leg, [1000.0; 2]).expect("an energy");
        let pull = 1000.0 - least_curvature(stiff, [0.0; 2]);
        if pull > 0.1 {
            let error = LegEnergy::new(leg, [0.99 * pull; 2]).expect_err("too soft");
            let Requirement::AtLeast(least) = error.requirement else { panic!("{error}") };
            assert!((least / pull - 1.0).abs() < 1e-4, "{least} is not {pull}");
            assert_eq!(name(LegEnergy::new(leg, [1.01 * pull; 2])), "nothing");
        }
        let springs = [20.0 + 19.9 * drawn[2], 20.0 + 19.9 * drawn[3]];
        let least = least_curvature(stiff, springs.map(|spring| 1000.0 - spring));
        if least.abs() > 0.01 {
            let is_held = LegEnergy::new(leg, springs).is_ok();
            assert_eq!(is_held, least > 0.0, "{posture:?} {springs:?} {least}");
            if is_held { held += 1 } else { refused += 1 }
        }
    }
    assert!(held > 50 && refused > 50, "{held} {refused}");
}

#[test]
fn forms_periods_and_rates_are_refused_by_name() {
    let form = |a, b, c, d| name(QuadraticForm::new([Vector2::new(a, b), Vector2::new(c, d)]));
    assert_eq!(form(2.0, 1.0, 1.0, 1.0), "nothing");
    assert_eq!(form(2.0, 1.0, 0.9, 1.0), "P less its transpose");
    assert_eq!(form(1.0, 2.0, 2.0, 1.0), "P's pivot");
    assert_eq!(form(0.0, 0.0, 0.0, 1.0), "P's pivot");
    assert_eq!(form(f64::NAN, 0.0, 0.0, 1.0), "P");
    let circle = QuadraticForm::<f64, 2>::sum_of_squares();
    let oscillator = VanDerPol::new(1.0).expect("a parameter");
    let moved =
        |period, steps| name(AffinePlant::new(oscillator, circle, RungeKutta4, period, steps));
    assert_eq!(moved(0.0, 1), "period");
    assert_eq!(moved(0.01, 0), "steps");
    assert_eq!(name(MeasuredPlant::new(oscillator, circle, f64::NAN, Vector2::zeros())), "period");
    assert_eq!(name(Decay::new(circle, -1.0)), "rate");
}
