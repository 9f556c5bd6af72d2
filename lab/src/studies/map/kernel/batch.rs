//! Scalars that rollouts run on, and how many of them side by side.

use lyapunov::lanes::{AutoF32x16, AutoF64x8};
use pulp::NullaryFnOnce;

use super::backward::Fuse;
use crate::simulate::Aligned;

/// A scalar that rollouts run on.
pub(super) trait Batch: Fuse {
    /// Groups of lanes that run side by side: one computes while another waits for a quotient.
    const BESIDE: usize;

    /// Whether a loop over the ticks keeps its groups, one or two, in registers; else they stay where they are in memory.
    const IN_REGISTERS: bool;

    /// Runs `job` compiled for the instructions of the lanes.
    fn run<J: NullaryFnOnce>(job: J) -> J::Output;
}

macro_rules! plain {
    ($($scalar:ty, $beside:literal, $registers:literal);+ $(;)?) => {$(
        impl Batch for $scalar {
            const BESIDE: usize = $beside;
            const IN_REGISTERS: bool = $registers;

            fn run<J: NullaryFnOnce>(job: J) -> J::Output {
                job.call()
            }
        }
    )+};
}

// One rollout at a time is the reference for the speed of the lanes.
plain! {
    f32, 1, true;
    f64, 1, true;
    Aligned<AutoF64x8>, 4, false;
    Aligned<AutoF32x16>, 4, false;
}
