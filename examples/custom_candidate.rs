//! A candidate of your own on the paper's wall: credit that decays with time.

use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, OnePort, ParameterError, Plant, PortSample,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
};

/// The port's energy, of which a surplus decays with a time constant.
struct Forgetful {
    surplus: f64, // J
    time: f64,    // s
}

impl LyapunovCandidate<f64> for Forgetful {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        let forgotten = self.surplus.max(0.0) * sample.period / self.time;
        self.surplus += sample.work - forgotten;
        sample.work - forgotten
    }
}

fn main() -> Result<(), ParameterError> {
    let (period, mass) = (1e-3, 0.3);
    let hand = Impedance { mass, damping: 0.201, stiffness: 50.0 };
    let mut plant = Body::new(hand, period)?.starting(-0.004, 0.0);
    let limit = DampingLimit::of_mass(0.5, mass, period)?;
    let stabilizer = Lolc::new(Forgetful { surplus: 0.0, time: 0.05 }, limit);
    // The wall responds at 100 Hz, the stabilizer watches at 1 kHz.
    let mut port = Wall::new(8000.0, 2.0)?.held(10)?.stabilized(stabilizer).differenced();
    let mut sample = plant.start();
    for tick in 0..=8000 {
        if tick % 1000 == 0 {
            println!("t {} s  x {:8.4} mm", tick / 1000, 1e3 * sample.position);
        }
        sample = plant.advance(port.respond(&sample));
    }
    Ok(())
}
