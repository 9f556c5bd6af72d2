//! An inverted pendulum controlled over a slow line, with a stabilizer at its motor.
//!
//! ```text
//! far away:      u = −k θ − d θ̇, which arrives 120 ms late
//! at the motor:  V = ½ m l² θ̇² + ½ k θ² − m g l (1 − cos θ), the flow L_g V is θ̇
//! ```
//!
//! Without delay the controller is a spring and a damper, and V falls. With it, the spring raises V more than the
//! damper lowers it. The stabilizer makes V decay. It needs the pendulum's V and a sensor of its own; of line and
//! controller it needs only `k`.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{AffinePlant, Decay, InvertedPendulum, StateFeedback, UprightEnergy, decrease_of},
};
use nalgebra::{Vector1, Vector2};

const PERIOD: f64 = 1e-3; // s
const LATE: u32 = 120; // ticks
const START: Vector2<f64> = Vector2::new(0.1, 0.0); // rad, rad/s

/// The largest lean in each of eight seconds, degrees; 180 is hanging.
fn run(most_damping: f64) -> Result<[f64; 8], ParameterError> {
    let pendulum = InvertedPendulum::new(0.5, 0.4, 0.002)?; // kg, m, N·m·s/rad
    let (stiffness, damping) = (6.0, 0.4); // N·m/rad, N·m·s/rad
    let energy = UprightEnergy::new(pendulum, stiffness)?;
    let mut plant = AffinePlant::new(pendulum, energy, RungeKutta4, PERIOD, 1)?.starting(START);

    let limit = DampingLimit::at(most_damping)?;
    let mut port =
        StateFeedback::new(|x: Vector2<f64>| Vector1::new(-stiffness * x[0] - damping * x[1]))
            .delayed::<128>(LATE)?
            .stabilized(Lolc::new((decrease_of(energy, START), Decay::new(energy, 1.0)?), limit));

    let mut sample = plant.start();
    let mut leans = [0.0_f64; 8];
    for tick in 0..8000 {
        sample = plant.advance(port.respond(&sample));
        let lean = plant.state()[0].abs().to_degrees().min(180.0);
        leans[tick / 1000] = leans[tick / 1000].max(lean);
    }
    Ok(leans)
}

fn main() -> Result<(), ParameterError> {
    println!("largest lean in each second, degrees, from 5.7");
    let without = run(0.0)?;
    println!("without stabilizer  {without:8.1?}");
    // Near critical damping, 2 √((k − m g l) m l²): far above it the pendulum would creep back, late as well.
    let with = run(1.0)?;
    println!("with                {with:8.1?}");
    assert!(without[1] == 180.0, "falls over within two seconds");
    assert!(with[0] < 7.0, "a degree more while the first command is on its way");
    assert!(with[7] < 0.5, "and then ever less");
    Ok(())
}
