//! Velocity estimates from positions.

use crate::effects::scene::{Filter, Scene};

/// The velocity on one axis after positions `x`, the latest last; `before` is the velocity one tick earlier.
pub(crate) fn velocity(scene: &Scene, x: &[f64], before: f64) -> f64 {
    let n = x.len() - 1;
    let period = scene.period();
    if n == 0 {
        return 0.0;
    }
    let difference = (x[n] - x[n - 1]) / period;
    match scene.filter {
        None => difference,
        Some(Filter::Cutoff(cutoff)) => {
            let w = std::f64::consts::TAU * cutoff;
            let share = w * period / (1.0 + w * period);
            before + share * (difference - before)
        }
        Some(Filter::Window(ticks)) => {
            let band = scene.encoder.unwrap_or(0.0);
            let fits = |length: usize| {
                let slope = (x[n] - x[n - length]) / length as f64;
                // Counts that are off by one lie on the edge of the band, so the edge needs some room for rounding.
                let room = 1e-9 * band + 1e-15 * x[n].abs();
                (1..length)
                    .all(|back| (x[n] - slope * back as f64 - x[n - back]).abs() <= band + room)
            };
            let longest = (2..=ticks.min(n)).take_while(|&length| fits(length)).last();
            let length = longest.unwrap_or(1);
            (x[n] - x[n - length]) / (length as f64 * period)
        }
    }
}
