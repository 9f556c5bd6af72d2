//! Telemetry of a loop of your own: a stabilizer chosen by its name, the last ticks in a ring, energies in a meter.
//!
//! ```text
//! cargo run --example telemetry -- popc | cargo run -p lyapunov-cli -- observe -
//! ```
//!
//! The log goes to standard output, the energies to standard error. Names: none, popc, popc-bounded, energy-bounding.

use std::env;

use lyapunov::{
    DampingLimit, ParameterError, Popc, PortEnergy, Reading, Readings, Stabilizer,
    stabilizers::{EnergyBounding, Member, NoStabilizer, StabilizerExt},
    telemetry::{EnergyMeter, TickRing},
};

const PERIOD: f32 = 1e-3; // s
const MASS: f32 = 0.2; // kg
const DAMPING: f32 = 0.1; // N·s/m
const STRONGEST: f32 = 4.0; // N: what the amplifier can do

/// The stabilizer of that name; none has a box, and all have one type.
fn named(name: &str) -> Result<Option<Member<f32>>, ParameterError> {
    let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, MASS, PERIOD)?);
    Ok(Some(match name {
        "none" => Member::NoStabilizer(NoStabilizer),
        "popc" => Member::Popc(popc),
        "popc-bounded" => Member::Bounded(popc.bounded(1e-4)?),
        "energy-bounding" => Member::EnergyBounding(EnergyBounding::of_damping(DAMPING, PERIOD)?),
        _ => return Ok(None),
    }))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = env::args().nth(1).unwrap_or("popc".into());
    let mut stabilizer = named(&name)?
        .ok_or_else(|| format!("`{name}` is none of none, popc, popc-bounded, energy-bounding"))?;
    let (mut ring, mut meter) = (TickRing::<f32, 600>::new(), EnergyMeter::new());

    let mut readings = Readings::every(PERIOD)?;
    let (mut position, mut velocity, mut applied) = (-0.002_f32, 0.05_f32, 0.0_f32);
    for _ in 0..1000 {
        let sample = readings.read(Reading { position, applied }).sample;

        let wall = 3000.0 * position.max(0.0);
        let correction = stabilizer.stabilize(&sample, wall);
        ring.push(&sample, &correction);
        meter.add(&sample, &correction);

        applied = correction.effort.clamp(-STRONGEST, STRONGEST);
        let hand = -20.0 * (position - 0.0005);
        velocity += PERIOD * (hand - DAMPING * velocity - applied) / MASS;
        position += PERIOD * velocity;
    }
    print!("{}", ring.csv());
    eprintln!("{} after {} ticks: {:#?}", stabilizer.name(), ring.seen(), meter.summary());
    Ok(())
}
