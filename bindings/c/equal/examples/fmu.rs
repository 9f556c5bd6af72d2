//! The reference for the units of fmu/, by the library in Rust alone: a line of inputs in, a line of outputs out, as bits.
//!
//! `fmu popc|lolc PERIOD FASTEST DAMPING_LIMIT [DEVICE_DAMPING] BUDGET`; lines are position, applied, effort.

use std::error::Error;
use std::io::{Write, stdin, stdout};

use lyapunov::{DampingLimit, Dissipation, Lolc, Popc, PortEnergy, Reading, Readings, Stabilizer};

fn answer(
    period: f64,
    fastest: f64,
    mut stabilizer: impl Stabilizer<f64>,
) -> Result<(), Box<dyn Error>> {
    let mut readings = Readings::every(period)?.no_faster_than(fastest)?;
    let mut out = stdout().lock();
    for line in stdin().lines() {
        let bits: Result<Vec<u64>, _> =
            line?.split_whitespace().map(|word| u64::from_str_radix(word, 16)).collect();
        let [position, applied, effort] = bits?[..] else {
            return Err("a line is position, applied, effort".into());
        };
        let [position, applied, effort] = [position, applied, effort].map(f64::from_bits);
        let read = readings.read(Reading { position, applied });
        let told = stabilizer.stabilize(&read.sample, effort);
        for number in [told.effort, told.observed_energy, told.alpha, told.shortfall] {
            write!(out, "{:016x} ", number.to_bits())?;
        }
        writeln!(out, "{}", u8::from(told.accepted))?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let told: Vec<String> = std::env::args().skip(1).collect();
    let (block, numbers) = told.split_first().ok_or("the block's name comes first")?;
    let numbers: Result<Vec<f64>, _> = numbers.iter().map(|number| number.parse()).collect();
    match (block.as_str(), &numbers?[..]) {
        ("popc", &[period, fastest, limit, budget]) => answer(
            period,
            fastest,
            Popc::new(PortEnergy, DampingLimit::at(limit)?).budgeted(budget)?,
        ),
        ("lolc", &[period, fastest, limit, damping, budget]) => {
            let candidate = (PortEnergy, Dissipation::of(damping)?);
            answer(
                period,
                fastest,
                Lolc::new(candidate, DampingLimit::at(limit)?).budgeted(budget)?,
            )
        }
        _ => Err("popc takes four numbers, lolc five".into()),
    }
}
