//! Refusal of invalid parameters, by name.

use lyapunov::{
    ParameterError,
    integrators::RungeKutta4,
    models::{
        AdmittanceDevice, AffinePlant, ArmEnergy, DcMotor, Decay, Ground, InvertedPendulum,
        LegEnergy, MeasuredPlant, MotorEnergy, MotorParts, ProstheticLeg, QuadraticForm, RigidLink,
        TwoLinkArm, UprightEnergy, VanDerPol,
    },
};
use nalgebra::Vector2;

use crate::{arm, leg, motor, pendulum};

fn name<X>(refused: Result<X, ParameterError>) -> &'static str {
    refused.err().map_or("nothing", |error| error.parameter)
}

#[test]
fn parameters_are_refused_by_name() {
    assert_eq!(name(VanDerPol::new(-1.0)), "mu");
    assert_eq!(name(AdmittanceDevice::new(0.0)), "stiffness");
    assert_eq!(name(AdmittanceDevice::new(1e-40_f32)), "1 / stiffness");
    assert_eq!(name(AdmittanceDevice::new(1.0).and_then(|it| it.energy(0.0))), "mass");
    assert_eq!(name(InvertedPendulum::new(0.0, 1.0, 0.0)), "mass");
    assert_eq!(name(InvertedPendulum::new(1.0, f64::NAN, 0.0)), "length");
    assert_eq!(name(InvertedPendulum::new(1.0, 1.0, -1.0)), "damping");
    assert_eq!(name(InvertedPendulum::new(1e-30_f32, 1e-10, 0.0)), "inertia");
    assert_eq!(name(UprightEnergy::new(pendulum::<f64>(), 1.9)), "stiffness");
    assert_eq!(name(UprightEnergy::new(pendulum::<f64>(), 2.0)), "nothing");
    let parts = motor::<f64>().parts();
    assert_eq!(name(DcMotor::new(MotorParts { inertia: 0.0, ..parts })), "inertia");
    assert_eq!(name(DcMotor::new(MotorParts { friction: -1.0, ..parts })), "friction");
    assert_eq!(name(DcMotor::new(MotorParts { inductance: 0.0, ..parts })), "inductance");
    assert_eq!(name(MotorEnergy::new(motor::<f64>(), 0.0, 0.1)), "stiffness");
    assert_eq!(name(MotorEnergy::new(motor::<f64>(), 1.0, -0.1)), "damping");
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

#[test]
fn forms_periods_and_rates_are_refused_by_name() {
    let form = |a, b, c, d| name(QuadraticForm::new([Vector2::new(a, b), Vector2::new(c, d)]));
    assert_eq!(form(2.0, 1.0, 1.0, 1.0), "nothing");
    assert_eq!(form(2.0, 1.0, 0.9, 1.0), "P less its transpose");
    assert_eq!(form(1.0, 2.0, 2.0, 1.0), "pivot of P");
    assert_eq!(form(0.0, 0.0, 0.0, 1.0), "pivot of P");
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
