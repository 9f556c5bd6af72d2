//! Energy that follows a reference, on a held spring that is pressed and released at a steady speed.

use approx::abs_diff_eq;
use lyapunov::{
    Popc, PortEnergy, PortSample, Stabilizer, StorageFunction, stabilizers::ReferenceFollowing,
};

use crate::support::{PERIOD, limit, popc};

const STIFFNESS: f64 = 1000.0;
const SPEED: f64 = 0.1;
const TICKS: usize = 100;

/// The corrections on each tick of pressing in and of letting go.
fn corrections(mut stabilizer: impl Stabilizer<f64>) -> Vec<f64> {
    let (mut x, mut sample) = (0.0, PortSample::starting(PERIOD, 0.0, SPEED));
    (0..2 * TICKS)
        .map(|tick| {
            let velocity = if tick < TICKS { SPEED } else { -SPEED };
            let force = STIFFNESS * x;
            let effort = stabilizer.stabilize(&sample, force).effort;
            let moved = velocity * PERIOD;
            x += moved;
            sample = PortSample::new(PERIOD, x, velocity, moved, effort);
            effort - force
        })
        .collect()
}

/// A held spring leaks `k Δx² / 2` a tick, which a correction of `k |Δx| / 2` pays.
#[test]
fn corrections_are_half_a_tick_of_spring() {
    let stored = |x: f64, _v: f64| 0.5 * STIFFNESS * x * x;
    let candidate = (PortEnergy, StorageFunction::starting(stored, 0.0, 0.0));
    let following = corrections(ReferenceFollowing::new(candidate, limit()));
    let half = 0.5 * STIFFNESS * SPEED * PERIOD;
    for (tick, correction) in following.iter().enumerate() {
        // Nothing has moved on the first tick. On the first one back the correction of the way there pushes along,
        // which the next correction pays.
        let turned = if tick == TICKS + 1 { 3.0 } else { 1.0 };
        let expected = match tick {
            0 => 0.0,
            tick if tick <= TICKS => half,
            _ => -half * turned,
        };
        assert!(abs_diff_eq!(*correction, expected, epsilon = 1e-9), "{correction} on tick {tick}");
    }
}

/// POPC waits until the port has given more than it took, and then needs forces as large as the spring's.
#[test]
fn popc_pays_all_of_it_at_the_end() {
    let alone: Popc<f64> = popc();
    let corrections = corrections(alone);
    let half = 0.5 * STIFFNESS * SPEED * PERIOD;
    let largest = corrections.iter().fold(0f64, |largest, c| largest.max(c.abs()));
    let first = corrections.iter().position(|c| *c != 0.0).expect("a correction");
    assert!(first > TICKS + TICKS / 2, "on tick {first}");
    assert!(largest > 10.0 * half, "{largest} N");
}
