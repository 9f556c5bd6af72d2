//! Steps in `f32` as functions of their own, whose instructions and bytes `scripts/cortex-m4f.sh` counts.
#![no_std]

use lyapunov_core::{Correction, PortEnergy, PortSample, Stabilizer};
use lyapunov_stabilizers::{ForceBound, Popc, Tank};

/// A step of POPC, with its cap.
#[inline(never)]
pub fn popc(popc: &mut Popc<f32>, sample: &PortSample<f32>, effort: f32) -> Correction<f32> {
    popc.stabilize(sample, effort)
}

/// A step of a force bound.
#[inline(never)]
pub fn force_bound(bound: &mut ForceBound<f32>, sample: &PortSample<f32>, effort: f32) -> f32 {
    bound.stabilize(sample, effort).effort
}

/// A step of a tank.
#[inline(never)]
pub fn tank(tank: &mut Tank<f32, PortEnergy>, sample: &PortSample<f32>, effort: f32) -> f32 {
    tank.stabilize(sample, effort).effort
}

/// A step of POPC, of which the loop takes the effort alone.
#[inline(never)]
pub fn popc_effort(popc: &mut Popc<f32>, sample: &PortSample<f32>, effort: f32) -> f32 {
    popc.stabilize(sample, effort).effort
}

/// Observed energy of the form by hand.
#[derive(Clone, Copy, Debug)]
pub struct Sum(pub f32);

/// The same step by hand without a cap: no limit, and no check of what comes in.
#[inline(never)]
pub fn uncapped(sum: &mut Sum, sample: &PortSample<f32>, effort: f32) -> f32 {
    let velocity = sample.velocity;
    let square = velocity * velocity * sample.period;
    sum.0 += sample.work;
    let debt = if sum.0 < 0.0 && square > f32::MIN_POSITIVE { -sum.0 } else { 0.0 };
    let divisor = if square > f32::MIN_POSITIVE { square } else { f32::MIN_POSITIVE };
    effort + debt / divisor * velocity
}
