//! A candidate of your own on the paper's wall: credit for the device's own dry friction.

use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, OnePort, ParameterError, Plant, PortSample,
    bodies::{Body, Friction, Impedance, Stribeck},
    effects::OnePortExt,
    environments::Wall,
    laws,
};

/// The port's energy plus the energy that dry friction must have dissipated: `−ΔV = f Δx + F |Δx|`.
///
/// The path between two samples is at least `|Δx|` long, so the credit is a lower bound as long as the device has at
/// least this friction.
#[derive(Clone)]
struct DryFriction {
    force: f64, // N
}

impl LyapunovCandidate<f64> for DryFriction {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        sample.work + self.force * sample.displacement.abs()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (period, mass) = (1e-3, 0.3);
    let candidate = DryFriction { force: 0.02 };
    laws::candidate(&candidate, laws::Samples::new(period))?;
    println!("t, s   x, mm, with the candidate   x, mm, only observed");
    let mut runs = [run(period, mass, 0.5, &candidate)?, run(period, mass, 0.0, &candidate)?];
    for second in 0..=4 {
        let [stabilized, observed] = runs.each_mut().map(|run| 1e3 * run.remove(0));
        println!("{second:4}   {stabilized:26.4}   {observed:20.4}");
    }
    Ok(())
}

/// The position at each full second of a hand on a wall that responds at 100 Hz, watched at 1 kHz.
fn run(
    period: f64,
    mass: f64,
    cap: f64,
    candidate: &DryFriction,
) -> Result<Vec<f64>, ParameterError> {
    let hand = Impedance { mass, damping: 0.201, stiffness: 50.0 };
    let friction = Stribeck { coulomb: 0.02, breakaway: 0.02, stribeck_velocity: 0.01 };
    let body = Body::new(hand, period)?.starting(-0.004, 0.0);
    let mut plant = Friction::new(body, hand, friction)?;
    let limit = DampingLimit::of_mass(cap, mass, period)?;
    let stabilizer = Lolc::new(candidate.clone(), limit);
    let mut port = Wall::new(8000.0, 2.0)?.held(10)?.stabilized(stabilizer).differenced();
    let mut sample = plant.start();
    let mut positions = Vec::new();
    for tick in 0..=4000 {
        if tick % 1000 == 0 {
            positions.push(sample.position);
        }
        sample = plant.advance(port.respond(&sample));
    }
    Ok(positions)
}
