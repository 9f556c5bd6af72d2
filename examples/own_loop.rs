//! A stabilizer in a control loop of your own, by plain calls: no scene, no port, no plant of ours.
//!
//! ```text
//! encoder ── x ──▶ own controller ── force ──▶ stabilizer ── effort ──▶ amplifier
//!                                                  ▲                       │
//!                                                  └─── applied force ─────┘
//! ```

use lyapunov::{
    DampingLimit, Dissipation, Lolc, ParameterError, PortEnergy, Reading, Readings, Stabilizer,
};

const PERIOD: f64 = 1e-3; // s
const MASS: f64 = 0.2; // kg: the smallest mass that moves with the device
const DAMPING: f64 = 0.1; // N·s/m: the smallest viscous damping of the device
const STRONGEST: f64 = 40.0; // N: what the amplifier can do
const FASTEST: f64 = 10.0; // m/s: no hand moves the device faster, so a reading that says so is wrong

fn main() -> Result<(), ParameterError> {
    println!("largest swing in each half second, mm");
    for (name, cap) in [("only observed", 0.0), ("stabilized", 0.5)] {
        print!("{name:14}");
        for swing in run(cap)? {
            print!("{:9.3}", 1e3 * swing);
        }
        println!();
    }
    Ok(())
}

/// Four seconds of the loop.
fn run(damping_cap: f64) -> Result<[f64; 8], ParameterError> {
    let limit = DampingLimit::of_mass(damping_cap, MASS, PERIOD)?;
    let mut stabilizer = Lolc::new((PortEnergy, Dissipation::of(DAMPING)?), limit);

    let mut device = Device { position: 0.0, velocity: 0.02 };
    let mut readings = Readings::every(PERIOD)?.no_faster_than(FASTEST)?;
    let mut applied = 0.0;
    let mut swings = [0.0; 8];
    for tick in 0..4000 {
        // `applied` is the force after the amplifier's limit, not the commanded one: the stabilizer books that.
        let sample = readings.read(Reading { position: device.read(), applied }).sample;

        // Your own controller: a spring to the origin, so stiff that at this rate it returns more energy than it took.
        let wanted = 5_000.0 * sample.position;

        let correction = stabilizer.stabilize(&sample, wanted);
        applied = correction.effort.clamp(-STRONGEST, STRONGEST);
        device.push(applied);

        let swing: &mut f64 = &mut swings[tick / 500];
        *swing = swing.max(sample.position.abs());
    }
    Ok(swings)
}

/// Stand-in for the hardware: a mass with some damping and an encoder of 1 µm.
struct Device {
    position: f64,
    velocity: f64,
}

impl Device {
    fn read(&self) -> f64 {
        (self.position / 1e-6).round() * 1e-6
    }

    fn push(&mut self, force: f64) {
        let steps = 100;
        let step = PERIOD / f64::from(steps);
        for _ in 0..steps {
            self.velocity += step * (-DAMPING * self.velocity - force) / MASS;
            self.position += step * self.velocity;
        }
    }
}
