//! Timing of loops in turns.

use std::ops::ControlFlow;
use std::time::Duration;

use lyapunov::{ParameterError, Scalar};
use nalgebra::SVector;

use super::CostsError;
use super::calls::Call;
use crate::measure::timing::{Rounds, count_for, runs};
use crate::simulate::{Instructions, Space};

/// Rounds over all loops.
pub(super) const ROUNDS: usize = 41;

/// Ticks of a run: the way to the wall and the first contact.
pub(super) const TICKS: usize = 250;

/// The least duration of the runs of a round: long compared with one reading of the clock.
const WHILE: Duration = Duration::from_micros(200);

/// The time of `count` runs of the loop of `call` in the scalar `T`.
fn lap<T: Space + Scalar>(
    call: &Call,
    instructions: Instructions,
    count: u32,
) -> Result<Duration, ParameterError> {
    let runs = match call.scene.dimensions() {
        3 => runs::<SVector<T, 3>>,
        2 => runs::<SVector<T, 2>>,
        _ => runs::<T>,
    };
    runs(&call.scene, instructions, TICKS, count)
}

/// The time of a step of every loop; the round before the first warms up, and shows how many runs are long enough.
pub(super) fn times<T: Space + Scalar>(
    calls: &[Call],
    instructions: Instructions,
    watch: &dyn Fn() -> ControlFlow<()>,
) -> Result<Rounds, CostsError> {
    let watched = |elapsed| match watch() {
        ControlFlow::Continue(()) => Ok(elapsed),
        ControlFlow::Break(()) => Err(CostsError::Stopped),
    };
    let counts =
        calls.iter().map(|call| Ok(count_for(WHILE, watched(lap::<T>(call, instructions, 1)?)?)));
    let counts = counts.collect::<Result<Vec<_>, CostsError>>()?;
    Rounds::of(calls.len(), ROUNDS, |_, at| {
        let elapsed = watched(lap::<T>(&calls[at], instructions, counts[at])?)?;
        Ok(elapsed.as_secs_f64() * 1e9 / (counts[at] as usize * TICKS) as f64)
    })
}
