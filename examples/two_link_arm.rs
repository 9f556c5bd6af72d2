//! An arm of two links, held by springs that are too stiff for a slow controller.
//!
//! ```text
//! M(q) q̈ + c(q, q̇) + G(q) = u,  u = −K q, computed 50 times a second and held
//! V = the energy of arm and springs, the flow L_g V is q̇: one stabilizer for both joints
//! ```

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{AffinePlant, ArmEnergy, Decay, RigidLink, StateFeedback, TwoLinkArm, decrease_of},
};
use nalgebra::{Vector2, Vector4};

const PERIOD: f64 = 1e-3; // s
const SLOW: u32 = 20; // ticks
const START: Vector4<f64> = Vector4::new(0.3, -0.2, 0.0, 0.0); // rad, rad/s

/// The arm's energy at the end of each second, as a multiple of the initial one.
fn run(damping_cap: f64) -> Result<[f64; 6], ParameterError> {
    let arm = TwoLinkArm::new(RigidLink::rod(2.0, 0.4), RigidLink::rod(1.0, 0.3))?; // kg, m
    let stiffness = [40.0, 10.0]; // N·m/rad
    let energy = ArmEnergy::new(arm, stiffness)?;
    let mut plant = AffinePlant::new(arm, energy, RungeKutta4, PERIOD, 1)?.starting(START);
    let began = plant.value();

    // The apparent mass of the port is the smallest inertia that a torque can meet.
    let limit = DampingLimit::of_mass(damping_cap, arm.least_inertia(), PERIOD)?;
    let mut port = StateFeedback::new(|x: Vector4<f64>| {
        Vector2::new(-stiffness[0] * x[0], -stiffness[1] * x[1])
    })
    .held(SLOW)?
    .stabilized(Lolc::new((decrease_of(energy, START), Decay::new(energy, 1.0)?), limit));

    let mut sample = plant.start();
    let mut energies = [0.0; 6];
    for tick in 0..6000 {
        sample = plant.advance(port.respond(&sample));
        energies[tick / 1000] = plant.value() / began;
    }
    Ok(energies)
}

fn main() -> Result<(), ParameterError> {
    println!("energy at the end of each second, by what it began with");
    let without = run(0.0)?;
    println!("without stabilizer  {without:8.2?}");
    let with = run(0.5)?;
    println!("with                {with:8.2?}");
    assert!(without[5] > 10.0, "gains energy");
    assert!(with[0] < 1.0 && with[5] < 0.05, "loses it");
    Ok(())
}
