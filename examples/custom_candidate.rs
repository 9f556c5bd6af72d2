//! A candidate of one's own on the paper's wall: quadratic drag of the device, credited as burnt.

use lyapunov::{
    Adapt, Body, DampingLimit, Drive, Impedance, Lolc, LyapunovCandidate, OnePort, ParameterError,
    Plant, Wall,
};

/// `−ΔV`: the port's energy, and what a drag `c |v| v` must have burnt, J.
struct Drag {
    coefficient: f64, // N·s²/m²
}

impl LyapunovCandidate<f64> for Drag {
    fn decrease(&mut self, drive: &Drive<f64>) -> f64 {
        let v = drive.velocity;
        drive.work + self.coefficient * v.abs() * v * v * drive.period
    }
}

fn main() -> Result<(), ParameterError> {
    let (period, mass) = (1e-3, 0.3);
    let hand = Impedance { mass, damping: 0.201, stiffness: 50.0 };
    let mut plant = Body::new(hand, period)?.starting(-0.004, 0.0);
    let limit = DampingLimit::of_mass(0.5, mass, period)?;
    let stabilizer = Lolc::new(Drag { coefficient: 0.5 }, limit);
    // The wall answers at 100 Hz, the stabilizer watches at 1 kHz.
    let mut port = Wall::new(8000.0, 2.0)?.held(10)?.stabilized(stabilizer).differenced();

    let mut drive = plant.start();
    for tick in 0..=5000 {
        let force = port.respond(&drive);
        if tick % 1000 == 0 {
            println!("t {} s  x {:8.4} mm  f {force:7.3} N", tick / 1000, 1e3 * drive.position);
        }
        drive = plant.advance(force);
    }
    Ok(())
}
