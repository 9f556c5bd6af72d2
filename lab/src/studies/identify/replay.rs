//! Run of a fitted scene beside its log.

use super::recording::Recording;
use crate::files::Scene;
use crate::simulate::Rollout;

/// Run of a fitted scene, row by row beside the log's first stretch.
#[derive(Clone, Debug)]
pub(super) struct Replay {
    /// Time from the first row on, s, and position, m.
    pub(super) points: Vec<(f64, f64)>,
    /// Difference to the log, root mean square, m.
    pub(super) error: f64,
}

impl Replay {
    /// The run of the scene `toml`; none where it cannot be run in the range of numbers.
    pub(super) fn of(toml: &str, recording: &Recording) -> Option<Self> {
        let scene = Scene::parse(toml, "identified").ok()?;
        let stretch = recording.stretches.first()?;
        let start = *stretch.times.first()?;
        let run = Rollout::<f64>::of(&scene).ok()?;
        let points: Vec<_> =
            run.take(stretch.len()).map(|tick| (tick.time, tick.measured.position)).collect();
        let of_log = stretch.times.iter().map(|it| it - start).zip(&stretch.positions);
        let mut sum = 0.0;
        let mut count = 0_u32;
        let mut ticks = points.iter().peekable();
        for (time, position) in of_log {
            while ticks.next_if(|it| it.0 < time - 0.5 * recording.period).is_some() {}
            let Some((_, run)) = ticks.peek() else { break };
            sum += (run - position).powi(2);
            count += 1;
        }
        let error = (sum / f64::from(count)).sqrt();
        error.is_finite().then_some(Self { points, error })
    }
}
