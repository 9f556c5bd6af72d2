//! Run of a fitted scene beside its log.

use super::recording::Recording;
use crate::files::Scene;
use crate::simulate::Rollout;

/// Run of a fitted scene beside its log.
#[derive(Clone, Debug)]
pub(super) struct Replay {
    /// Time from the log's first row on, s, and position, m.
    pub(super) points: Vec<(f64, f64)>,
    /// Difference to the log, root mean square, m.
    pub(super) error: f64,
}

impl Replay {
    /// The run of the scene `toml`; none where it cannot be run in the range of numbers.
    pub(super) fn of(toml: &str, recording: &Recording) -> Option<Self> {
        let scene = Scene::parse(toml, "identified").ok()?;
        let start = *recording.stretches.first()?.times.first()?;
        let run = Rollout::<f64>::of(&scene).ok()?;
        let points: Vec<(f64, f64)> = run.map(|tick| (tick.time, tick.truth.position)).collect();
        let rows = recording.stretches.iter().flat_map(|it| it.times.iter().zip(&it.positions));
        let (mut at, mut sum, mut count) = (0, 0.0, 0_u32);
        for (time, position) in rows {
            let time = time - start;
            while points.get(at + 1).is_some_and(|next| next.0 <= time) {
                at += 1;
            }
            let before = points.get(at)?;
            let after = points.get(at + 1).unwrap_or(before);
            // Between ticks the motion is a straight line.
            let share =
                if after.0 > before.0 { (time - before.0) / (after.0 - before.0) } else { 0.0 };
            sum += (before.1 - recording.origin + share * (after.1 - before.1) - position).powi(2);
            count += 1;
        }
        let error = (sum / f64::from(count)).sqrt();
        error.is_finite().then_some(Self { points, error })
    }
}
