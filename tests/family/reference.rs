//! Energy that follows a reference, on a held spring that is pressed and released at a steady speed.

use approx::abs_diff_eq;
use lyapunov::{
    DampingLimit, HeldTick, LyapunovCandidate, Popc, PortEnergy, PortSample, Scalar, Stabilizer,
    StorageFunction, stabilizers::ReferenceDamper, stabilizers::ReferenceFollowing,
};

use crate::support::{PERIOD, limit, popc};
use crate::worked::{A, B, felt, near};

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
            sample = HeldTick {
                period: PERIOD,
                position: x,
                velocity,
                displacement: moved,
                applied: effort,
            }
            .sample();
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

fn rows<T: Scalar>() {
    let stored = |x: T, _v: T| T::of(2500.0) * x * x;
    let candidate = (PortEnergy, StorageFunction::starting(stored, T::of(0.0), T::of(0.0)));
    let limit = DampingLimit::at(T::of(100.0)).expect("a limit");
    let following = ReferenceFollowing::new(candidate, limit);
    let row = [0.0, 0.75, 1.875, 3.625, 4.8125, 4.0, 1.6875, 1.1875, -0.15625, -0.90625];
    near(&felt::<T>(following, A), &row);
    near(&felt::<T>(following, B), &[2.0, 2.0, 2.0, -1.0, 2.0, 3.0, -2.5, 0.0, 2.0, 2.0]);
    let popc = Popc::<T>::new(PortEnergy, limit);
    let row = [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 3.0, -0.333333, -1.91667, -2.91667];
    near(&felt::<T>(popc, A), &row);
    near(&felt::<T>(popc, B), &B);
}

crate::worked::each_scalar!(the_worked_rows, rows);

/// `K = 1000, T = 1 ms, v = 0.1`: from the second tick on the law is the damper `K T / 2`.
#[test]
fn it_is_the_damper_that_pays_the_hold() {
    let stored = |x: f64, _v: f64| 0.5 * STIFFNESS * x * x;
    let candidate = (PortEnergy, StorageFunction::starting(stored, 0.0, 0.0));
    let mut following = ReferenceFollowing::new(candidate, limit());
    let (mut sample, mut x) = (PortSample::starting(PERIOD, 0.0, SPEED), 0.0);
    for tick in 0..100 {
        let correction = following.stabilize(&sample, STIFFNESS * x);
        let expected = if tick == 0 { 0.0 } else { STIFFNESS * PERIOD / 2.0 };
        assert!((correction.alpha - expected).abs() < 1e-9, "{} on tick {tick}", correction.alpha);
        x += SPEED * PERIOD;
        sample = HeldTick {
            period: PERIOD,
            position: x,
            velocity: SPEED,
            displacement: SPEED * PERIOD,
            applied: correction.effort,
        }
        .sample();
    }
}

/// A wall with damping is asked to burn what it would: at a steady speed a held spring that forgets its damper is served
/// `B + K T / 2`, in the wall and nowhere else.
#[test]
fn the_reference_burns_what_the_wall_does() {
    let (damping, surface) = (5.0, 2e-3);
    let depth = move |x: f64| (x - surface).max(0.0);
    let stored = move |x: f64, _v: f64| 0.5 * STIFFNESS * depth(x) * depth(x);
    let reference = (
        StorageFunction::starting(stored, 0.0, 0.0),
        ReferenceDamper::starting(damping, depth, 0.0).expect("a damper"),
    );
    let mut following = ReferenceFollowing::new((PortEnergy, reference), limit());
    let (mut sample, mut x) = (PortSample::starting(PERIOD, 0.0, SPEED), 0.0);
    for tick in 0..100 {
        let correction = following.stabilize(&sample, STIFFNESS * depth(x));
        // Half a tick of the wall's edge, which is on a tick.
        let expected = match depth(x) {
            inside if inside > 1e-9 => damping + STIFFNESS * PERIOD / 2.0,
            _ => 0.0,
        };
        assert!((correction.alpha - expected).abs() < 1e-6, "{} on tick {tick}", correction.alpha);
        x = SPEED * PERIOD * f64::from(tick + 1);
        sample = HeldTick {
            period: PERIOD,
            position: x,
            velocity: SPEED,
            displacement: SPEED * PERIOD,
            applied: correction.effort,
        }
        .sample();
    }
    // A motion that is as fast within the tick burns as much or more: the reference is a lower bound.
    let mut damper = ReferenceDamper::starting(damping, |x: f64| x, 0.0).expect("a damper");
    let (mut asked, mut burnt) = (0.0, 0.0);
    for tick in 0..1000 {
        let now = f64::from(tick + 1) * PERIOD;
        let position = |time: f64| 1e-3 * (300.0 * time).sin();
        let sample = HeldTick {
            period: PERIOD,
            position: position(now),
            velocity: 0.0,
            displacement: 0.0,
            applied: 0.0,
        }
        .sample();
        asked -= damper.decrease(&sample);
        for step in 0..100 {
            let time = now - PERIOD + PERIOD * (f64::from(step) + 0.5) / 100.0;
            let velocity = 0.3 * (300.0 * time).cos();
            burnt += damping * velocity * velocity * PERIOD / 100.0;
        }
        assert!(asked <= burnt * (1.0 + 1e-9));
    }
    assert!(asked > 0.98 * burnt);
    assert!(ReferenceDamper::starting(-1.0, |x: f64| x, 0.0).is_err());
}
