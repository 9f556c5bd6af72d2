//! Timing of loops in turns.

use std::ops::ControlFlow;
use std::time::Duration;

use lyapunov::ParameterError;

use super::CostsError;
use crate::files::Scene;
use crate::measure::timing::{Rounds, count_for, runs};
use crate::simulate::{F64x8, Instructions, in_space};

/// Rounds over all loops.
pub(super) const ROUNDS: usize = 41;

/// Ticks of a run: the way to the wall and the first contact.
pub(super) const TICKS: usize = 250;

/// The least duration of the runs of a round: long compared with one reading of the clock.
const WHILE: Duration = Duration::from_micros(200);

/// The times of a step of every loop, one run at a time.
pub(super) fn alone(
    scenes: &[Scene],
    instructions: Instructions,
    watch: &dyn Fn() -> ControlFlow<()>,
) -> Result<Rounds, CostsError> {
    times(
        scenes,
        watch,
        |scene, count| in_space!(scene, Axes => runs::<Axes>(scene, instructions, TICKS, count)),
    )
}

/// The times of a step of every loop, all of them on a line, on eight lanes.
pub(super) fn on_lanes(
    scenes: &[Scene],
    instructions: Instructions,
    watch: &dyn Fn() -> ControlFlow<()>,
) -> Result<Rounds, CostsError> {
    times(scenes, watch, |scene, count| runs::<F64x8>(scene, instructions, TICKS, count))
}

/// The times of a step of every loop, of which `lap` makes so many runs; the round before the first warms up, and shows
/// how many runs are long enough.
fn times(
    scenes: &[Scene],
    watch: &dyn Fn() -> ControlFlow<()>,
    lap: impl Fn(&Scene, u32) -> Result<Duration, ParameterError>,
) -> Result<Rounds, CostsError> {
    let watched = |elapsed| match watch() {
        ControlFlow::Continue(()) => Ok(elapsed),
        ControlFlow::Break(()) => Err(CostsError::Stopped),
    };
    let counts = scenes.iter().map(|scene| Ok(count_for(WHILE, watched(lap(scene, 1)?)?)));
    let counts = counts.collect::<Result<Vec<_>, CostsError>>()?;
    Rounds::of(scenes.len(), ROUNDS, |_, at| {
        let elapsed = watched(lap(&scenes[at], counts[at])?)?;
        Ok(elapsed.as_secs_f64() * 1e9 / (counts[at] as usize * TICKS) as f64)
    })
}
