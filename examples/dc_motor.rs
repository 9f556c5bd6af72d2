//! A motor's position loop at three times the gain that its winding allows.
//!
//! ```text
//! θ̇ = ω,  J ω̇ = K i − b ω,  L di/dt = u − R i − K ω,  u = −gain θ
//! V = ½ k θ² + ½ J ω² + ½ L (i − i*)²,  i* = −(k θ + d ω) / K        the flow L_g V is i − i*
//! ```
//!
//! The current lags the voltage, and the loop runs away. The flow here is not a velocity: it is the difference between
//! the current and the one that would act like a spring and a damper.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant,
    integrators::RungeKutta4,
    models::{AffinePlant, DcMotor, Decay, MotorEnergy, MotorParts, StateFeedback, decrease_of},
};
use nalgebra::{Vector1, Vector3};

const PERIOD: f64 = 1e-3; // s
const START: Vector3<f64> = Vector3::new(1.0, 0.0, 0.0); // rad, rad/s, A

/// The largest |θ| in each tenth of a second, rad.
fn run(damping_cap: f64) -> Result<[f64; 8], ParameterError> {
    let parts = MotorParts {
        inertia: 1e-4,         // kg·m²
        friction: 1e-5,        // N·m·s/rad
        torque_constant: 0.05, // N·m/A
        resistance: 1.0,       // Ω
        inductance: 0.02,      // H
    };
    let motor = DcMotor::new(parts)?;
    let gain = 3.0 * motor.critical_gain();
    let energy = MotorEnergy::new(motor, 0.05, 0.004)?;
    let mut plant = AffinePlant::new(motor, energy, RungeKutta4, PERIOD, 1)?.starting(START);

    // The apparent mass of the port is L.
    let limit = DampingLimit::of_mass(damping_cap, parts.inductance, PERIOD)?;
    let mut port = StateFeedback::new(|x: Vector3<f64>| Vector1::new(-gain * x[0]))
        .stabilized(Lolc::new((decrease_of(energy, START), Decay::new(energy, 10.0)?), limit));

    let mut sample = plant.start();
    let mut swings = [0.0_f64; 8];
    for tick in 0..800 {
        sample = plant.advance(port.respond(&sample));
        swings[tick / 100] = swings[tick / 100].max(plant.state()[0].abs());
    }
    Ok(swings)
}

fn main() -> Result<(), ParameterError> {
    println!("largest angle in each tenth of a second, rad, from 1");
    let without = run(0.0)?;
    println!("without stabilizer  {without:9.2?}");
    let with = run(0.5)?;
    println!("with                {with:9.2?}");
    assert!(without[7] > 100.0, "runs away");
    assert!(with.iter().all(|&swing| swing < 1.01), "never farther than it began");
    assert!(with[7] < 0.1, "and arrives");
    Ok(())
}
