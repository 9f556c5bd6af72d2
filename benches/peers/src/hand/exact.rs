//! Closed form of the motion, by hand.

use crate::scene::{DAMPING, MASS, PERIOD, Positions, STIFFNESS, rollout};

/// Textbook motion of a mass on a damped spring under a held force: an oscillation about `−f / k`.
#[inline(never)]
pub(crate) fn exact(positions: &mut Positions) {
    let decay = DAMPING / (2.0 * MASS);
    let frequency = (STIFFNESS / MASS - decay * decay).sqrt();
    let left = (-decay * PERIOD).exp();
    let (sine, cosine) = (frequency * PERIOD).sin_cos();
    let by_velocity = left * sine / frequency;
    let [stay, keep] = [1.0, -1.0].map(|sign| left * cosine + sign * decay * by_velocity);
    let pull = -STIFFNESS / MASS * by_velocity;
    let (shift, push) = ((stay - 1.0) / STIFFNESS, pull / STIFFNESS);
    rollout(positions, |[x, v], force| {
        [stay * x + by_velocity * v + shift * force, pull * x + keep * v + push * force]
    });
}
