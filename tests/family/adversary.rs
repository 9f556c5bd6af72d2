//! Motions and wishes that take as much as they can out of a held force and the device's damper.

use std::collections::VecDeque;

use lyapunov::{HeldTick, PortSample, Stabilizer};

use crate::support::{Dice, PERIOD};

/// The damping of the device, N·s/m.
pub(crate) const DAMPING: f64 = 0.5;

/// The least of `Σ F Δx + b Δx² / T` over 400 runs of 200 ticks, in shares of all that crossed, with the force acting `late`
/// ticks late; half of the runs move by the worst displacement, `−F T / (2 b)`.
pub(crate) fn least<S: Stabilizer<f64>>(make: impl Fn() -> S, late: usize) -> f64 {
    least_over(make, late, 1.0)
}

/// The same with periods of any length between one and `longest` of [`PERIOD`].
pub(crate) fn least_over<S: Stabilizer<f64>>(
    make: impl Fn() -> S,
    late: usize,
    longest: f64,
) -> f64 {
    (0..400).map(|seed| run(make(), seed, late, longest)).fold(f64::INFINITY, f64::min)
}

fn run(mut stabilizer: impl Stabilizer<f64>, seed: u64, late: usize, longest: f64) -> f64 {
    let (mut dice, mut lengths) = (Dice::of(seed), Dice::of(!seed));
    let mut pipe = VecDeque::from(vec![0.0; late]);
    let mut sample = PortSample::starting(PERIOD, 0.0, 0.0);
    let (mut energy, mut size, mut least) = (0f64, 0f64, 0f64);
    let stroke = 1e-4 * 10f64.powf(dice.within(1.0));
    for tick in 0..200 {
        pipe.push_back(stabilizer.stabilize(&sample, dice.within(5.0)).effort);
        let force = pipe.pop_front().unwrap_or(0.0);
        let period = PERIOD * (1.0 + (longest - 1.0) * lengths.within(1.0).abs());
        let worst = -force * period / (2.0 * DAMPING);
        let moved = match (seed % 4, tick % 3) {
            (0 | 2, _) | (3, 0) => dice.within(stroke),
            _ if worst == 0.0 => dice.within(stroke),
            _ => worst,
        };
        let change = force * moved + DAMPING * moved * moved / period;
        energy += change;
        size += (force * moved).abs() + DAMPING * moved * moved / period;
        least = least.min(energy / size.max(f64::MIN_POSITIVE));
        sample = HeldTick {
            period,
            position: sample.position + moved,
            velocity: moved / period,
            displacement: moved,
            applied: force,
        }
        .sample();
    }
    least
}
