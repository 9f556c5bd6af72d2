//! The way from a model to its loop.

use lyapunov::{
    ParameterError, Scalar,
    models::{
        AdmittanceDevice, ArmEnergy, DcMotor, Ground, InvertedPendulum, LegEnergy, MotorEnergy,
        MotorParts, ProstheticLeg, QuadraticForm, TwoLinkArm, UprightEnergy, VanDerPol,
    },
};
use nalgebra::SVector;

use super::rig::{Loop, Parts, rig};
use crate::files::models::{Model, Plant, plant};
use crate::files::scene::{self, Coordinates, Refused};

/// The loop of `model`, in the scalar that it names.
pub(crate) fn built(model: &Model) -> Result<Box<dyn Loop>, Refused> {
    match model.scalar {
        scene::Scalar::F64 => built_in::<f64>(model),
        scene::Scalar::F32 => built_in::<f32>(model),
    }
}

fn built_in<T: Scalar>(model: &Model) -> Result<Box<dyn Loop>, Refused> {
    let none = SVector::from([T::of(0.0)]);
    match &model.plant {
        Plant::VanDerPol(it) => {
            let plant = VanDerPol::new(T::of(it.mu.get())).map_err(in_table(model))?;
            let function = QuadraticForm::<T, 2>::sum_of_squares();
            rig(model, Parts { plant, function, mass: T::of(1.0), holding: none })
        }
        Plant::InvertedPendulum(it) => {
            let [mass, length] = [it.mass, it.length].map(|it| T::of(it.get()));
            let plant = InvertedPendulum::new(mass, length, T::of(it.damping.get()))
                .map_err(in_table(model))?;
            let [stiffness, _] = springs(model);
            let function = UprightEnergy::new(plant, stiffness).map_err(of_springs)?;
            rig(model, Parts { plant, function, mass: plant.inertia(), holding: none })
        }
        Plant::DcMotor(it) => {
            let parts = motor_parts(it);
            let plant = DcMotor::new(parts).map_err(in_table(model))?;
            let (stiffness, damping) = (it.wanted_stiffness.get(), it.wanted_damping.get());
            let function = MotorEnergy::new(plant, T::of(stiffness), T::of(damping))
                .map_err(|error| ("plant.dc-motor.wanted_stiffness", error))?;
            rig(model, Parts { plant, function, mass: parts.inductance, holding: none })
        }
        Plant::AdmittanceDevice(it) => {
            let device = AdmittanceDevice::new(T::of(it.hand_stiffness.get()));
            let plant = device.map_err(in_table(model))?;
            let function = plant.energy(T::of(it.wanted_mass.get())).map_err(in_table(model))?;
            rig(model, Parts { plant, function, mass: plant.compliance(), holding: none })
        }
        Plant::TwoLinkArm(it) => {
            let plant = TwoLinkArm::new(it.upper.rigid_link(), it.lower.rigid_link())
                .map_err(in_table(model))?;
            let function = ArmEnergy::new(plant, springs(model)).map_err(of_springs)?;
            let mass = plant.least_inertia();
            rig(model, Parts { plant, function, mass, holding: SVector::from([T::of(0.0); 2]) })
        }
        Plant::ProstheticLeg(it) => {
            let plant = leg::<T>(it).map_err(in_table(model))?;
            let function = LegEnergy::new(plant, springs(model)).map_err(of_springs)?;
            let (mass, holding) = (plant.least_inertia(), plant.holding());
            rig(model, Parts { plant, function, mass, holding })
        }
    }
}

fn motor_parts<T: Scalar>(motor: &plant::DcMotor) -> MotorParts<T> {
    MotorParts {
        inertia: T::of(motor.inertia.get()),
        friction: T::of(motor.friction.get()),
        torque_constant: T::of(motor.torque_constant.get()),
        resistance: T::of(motor.resistance.get()),
        inductance: T::of(motor.inductance.get()),
    }
}

fn leg<T: Scalar>(leg: &plant::ProstheticLeg) -> Result<ProstheticLeg<T>, ParameterError> {
    let ground = Ground {
        stiffness: T::of(leg.ground.stiffness.get()),
        damping: T::of(leg.ground.damping.get()),
        drag: T::of(leg.ground.drag.get()),
    };
    let posture = leg.posture.map(|angle| T::of(angle.get()));
    ProstheticLeg::new(leg.thigh.rigid_link(), leg.shank.rigid_link(), posture, ground)
}

/// The controller's springs, which are also terms of V.
fn springs<T: Scalar>(model: &Model) -> [T; 2] {
    let gains: &Coordinates = &model.controller.proportional;
    [0, 1].map(|input| T::of(gains.axis(input)))
}

fn of_springs(error: ParameterError) -> Refused {
    ("controller.proportional", error)
}

fn in_table(model: &Model) -> impl Fn(ParameterError) -> Refused {
    let table = match model.plant {
        Plant::VanDerPol(_) => "plant.van-der-pol",
        Plant::InvertedPendulum(_) => "plant.inverted-pendulum",
        Plant::DcMotor(_) => "plant.dc-motor",
        Plant::AdmittanceDevice(_) => "plant.admittance-device",
        Plant::TwoLinkArm(_) => "plant.two-link-arm",
        Plant::ProstheticLeg(_) => "plant.prosthetic-leg",
    };
    move |error| (table, error)
}
