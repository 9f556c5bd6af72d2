//! The other models against the loops of their examples.

use lyapunov::{
    DampingLimit, Lolc, OnePort, Plant,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{
        AdmittanceDevice, AffinePlant, ArmEnergy, ControlAffine, DcMotor, Decay, Ground, LegEnergy,
        LyapunovFunction, MotorEnergy, MotorParts, ProstheticLeg, RigidLink, StateFeedback,
        TwoLinkArm, WithState, decrease_of,
    },
};
use lyapunov_lab::models::Entrant;
use nalgebra::{SVector, Vector1, Vector2, Vector3, Vector4};

use crate::models::shipped::{compared, curve, model};

const PERIOD: f64 = 1e-3;

/// Loop of an example, under LOLC with a decay or without a stabilizer.
struct Example<P, F, const N: usize> {
    plant: P,
    energy: F,
    start: SVector<f64, N>,
    steps: u32,
    mass: f64,
    decay: f64,
    ticks: usize,
}

impl<P, F, const N: usize> Example<P, F, N> {
    fn values<const M: usize>(
        &self,
        cap: f64,
        controller: impl OnePort<WithState<f64, N, M>>,
    ) -> Vec<f64>
    where
        P: ControlAffine<f64, N, M> + Copy,
        F: LyapunovFunction<SVector<f64, N>> + Copy,
    {
        let Self { plant, energy, start, steps, .. } = *self;
        let plant = AffinePlant::new(plant, energy, RungeKutta4, PERIOD, steps);
        let mut plant = plant.unwrap().starting(start);
        let limit = DampingLimit::of_mass(cap, self.mass, PERIOD).unwrap();
        let decay = Decay::new(energy, self.decay).unwrap();
        let lolc = Lolc::new((decrease_of(energy, start), decay), limit);
        let mut port = controller.stabilized(lolc);
        let mut sample = plant.start();
        let mut values = vec![plant.value()];
        for _ in 0..self.ticks {
            sample = plant.advance(port.respond(&sample));
            values.push(plant.value());
        }
        values
    }

    fn equals<const M: usize>(
        &self,
        name: &str,
        controller: impl OnePort<WithState<f64, N, M>> + Clone,
    ) where
        P: ControlAffine<f64, N, M> + Copy,
        F: LyapunovFunction<SVector<f64, N>> + Copy,
    {
        let comparison = compared(&model(name));
        for (entrant, cap) in [(Entrant::None, 0.0), (Entrant::Decay, 0.5)] {
            let (told, example) =
                (curve(&comparison, entrant), self.values(cap, controller.clone()));
            assert_eq!(told.len(), example.len());
            let began = example[0];
            for (tick, (told, example)) in told.iter().zip(&example).enumerate() {
                let off = (told - example).abs() / example.max(began);
                assert!(off <= 1e-9, "{name}, {entrant:?} at {tick}: {told}, {example}");
            }
        }
    }
}

#[test]
fn the_motor_matches_its_example() {
    let parts = MotorParts {
        inertia: 1e-4,
        friction: 1e-5,
        torque_constant: 0.05,
        resistance: 1.0,
        inductance: 0.02,
    };
    let motor = DcMotor::new(parts).unwrap();
    let gain = 3.0 * motor.critical_gain();
    let example = Example {
        plant: motor,
        energy: MotorEnergy::new(motor, 0.05, 0.004).unwrap(),
        start: Vector3::new(1.0, 0.0, 0.0),
        steps: 1,
        mass: parts.inductance,
        decay: 10.0,
        ticks: 800,
    };
    example
        .equals("dc-motor", StateFeedback::new(move |x: Vector3<f64>| Vector1::new(-gain * x[0])));
}

#[test]
fn the_admittance_device_matches_its_loop_in_a_program() {
    let device = AdmittanceDevice::new(1000.0).unwrap();
    let example = Example {
        plant: device,
        energy: device.energy(0.2).unwrap(),
        start: Vector2::new(5e-3, 0.0),
        steps: 1,
        mass: 1e-3,
        decay: 4.0,
        ticks: 2000,
    };
    let rendered = StateFeedback::new(|x: Vector2<f64>| Vector1::new(x[1] * 5.0));
    example.equals("admittance-device", rendered.delayed::<2>(2).unwrap());
}

#[test]
fn the_arm_matches_its_example() {
    let arm = TwoLinkArm::new(RigidLink::rod(2.0, 0.4), RigidLink::rod(1.0, 0.3)).unwrap();
    let stiffness = [40.0, 10.0];
    let example = Example {
        plant: arm,
        energy: ArmEnergy::new(arm, stiffness).unwrap(),
        start: Vector4::new(0.3, -0.2, 0.0, 0.0),
        steps: 1,
        mass: arm.least_inertia(),
        decay: 1.0,
        ticks: 6000,
    };
    let law = move |x: Vector4<f64>| Vector2::new(-stiffness[0] * x[0], -stiffness[1] * x[1]);
    example.equals("two-link-arm", StateFeedback::new(law).held(20).unwrap());
}

#[test]
fn the_leg_matches_its_example() {
    let ground = Ground { stiffness: 2e4, damping: 0.5, drag: 0.2 };
    let (thigh, shank) = (RigidLink::rod(4.0, 0.4), RigidLink::rod(2.5, 0.45));
    let leg = ProstheticLeg::new(thigh, shank, [0.3, -0.6], ground).unwrap();
    let (stiffness, damping) = ([300.0, 150.0], [4.0, 2.0]);
    let example = Example {
        plant: leg,
        energy: LegEnergy::new(leg, stiffness).unwrap(),
        start: Vector4::new(0.3, -0.4, 0.0, 0.0),
        steps: 4,
        mass: leg.least_inertia(),
        decay: 2.0,
        ticks: 3000,
    };
    let holding = leg.holding();
    let law = move |x: Vector4<f64>| {
        let joint = |j: usize| holding[j] - stiffness[j] * x[j] - damping[j] * x[2 + j];
        Vector2::new(joint(0), joint(1))
    };
    example.equals("prosthetic-leg", StateFeedback::new(law).delayed::<20>(20).unwrap());
}
