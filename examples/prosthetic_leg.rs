//! A leg on a test stand, which a controller 20 ms late puts down on padded ground.
//!
//! ```text
//! hip and knee:  u = holding − K δ − D q̇ towards a posture in which the foot just touches, 20 ms late
//! V = the energy of leg, ground and springs, less the work of the holding torques; the flow L_g V is q̇
//! ```
//!
//! [`lyapunov::models::ProstheticLeg`] says what the model leaves out.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{
        AffinePlant, Decay, Ground, LegEnergy, ProstheticLeg, RigidLink, StateFeedback, decrease_of,
    },
};
use nalgebra::{Vector2, Vector4};

const PERIOD: f64 = 1e-3; // s
const LATE: u32 = 20; // ticks
const START: Vector4<f64> = Vector4::new(0.3, -0.4, 0.0, 0.0); // lifted, rad; at rest, rad/s

/// The leg's energy at the end of each half second, J, and the largest depth of the foot, mm.
fn run(damping_cap: f64) -> Result<([f64; 6], f64), ParameterError> {
    let ground = Ground { stiffness: 2e4, damping: 0.5, drag: 0.2 }; // N/m, s/m, s/m
    let (thigh, shank) = (RigidLink::rod(4.0, 0.4), RigidLink::rod(2.5, 0.45)); // kg, m
    let leg = ProstheticLeg::new(thigh, shank, [0.3, -0.6], ground)?;
    let (stiffness, damping) = ([300.0, 150.0], [4.0, 2.0]); // N·m/rad, N·m·s/rad
    let energy = LegEnergy::new(leg, stiffness)?;
    let mut plant = AffinePlant::new(leg, energy, RungeKutta4, PERIOD, 4)?.starting(START);

    let limit = DampingLimit::of_mass(damping_cap, leg.least_inertia(), PERIOD)?;
    let holding = leg.holding();
    let mut port = StateFeedback::new(|x: Vector4<f64>| {
        let joint = |j: usize| holding[j] - stiffness[j] * x[j] - damping[j] * x[2 + j];
        Vector2::new(joint(0), joint(1))
    })
    .delayed::<32>(LATE)?
    .stabilized(Lolc::new((decrease_of(energy, START), Decay::new(energy, 2.0)?), limit));

    let mut sample = plant.start();
    let (mut energies, mut deepest) = ([0.0; 6], 0.0_f64);
    for tick in 0..3000 {
        sample = plant.advance(port.respond(&sample));
        energies[tick / 500] = plant.value();
        deepest = deepest.max(1e3 * leg.depth(plant.state()));
    }
    Ok((energies, deepest))
}

fn main() -> Result<(), ParameterError> {
    println!("energy at the end of each half second, J");
    let (without, _) = run(0.0)?;
    println!("without stabilizer  {without:10.2?}");
    let (with, deepest) = run(0.5)?;
    println!("with                {with:10.2?}, the foot never deeper than {deepest:.0} mm");
    assert!(without[5] > 1e3, "kicks about");
    assert!(with[5] < 0.5 && deepest < 30.0, "stands");
    Ok(())
}
