//! Study of all settings of one scene.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use lyapunov::{Scalar, accumulators::DoubleDouble};
use rayon::prelude::*;

use super::horizon::{BELIEVED, Growth};
use super::ledger::{self, LedgerRow};
use super::reference::{References, SURE, Second, off};
use super::setting::{Number, Setting};
use super::timing::{self, Time};
use super::trace::{Progress, trace};
use super::{AccuracyError, table};
use crate::files::Scene;
use crate::simulate::{Assembly, Space};

/// The most ticks of a scene that are examined.
const MOST_TICKS: u64 = 100_000;

/// Accuracy and time of all settings on one scene; its `Display` is the table of `lyapunov accuracy`.
#[derive(Clone, Debug)]
pub struct Study {
    /// The scene's name, usually the path of its file.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// One row per setting, the fastest first.
    pub rows: Vec<Row>,
    /// One row per ledger.
    pub ledger: Vec<LedgerRow>,
    pub(super) basis: Basis,
}

/// Reference of the errors, and the ticks that they count over.
#[derive(Clone, Debug)]
pub(super) struct Basis {
    pub(super) second: Second,
    /// The distance of the references over `ticks`, m.
    pub(super) distance: f64,
    /// Ticks over which errors count.
    pub(super) ticks: usize,
    /// Ticks that were examined, as far as the motion stays finite.
    pub(super) all_ticks: usize,
    /// The largest error of a trace that is still believed, m.
    pub(super) believed: f64,
    /// The ticks over which the references agree well enough to judge that.
    pub(super) agreeing: usize,
    pub(super) growth: Growth,
    /// Rounds that were timed.
    pub(super) rounds: usize,
}

/// The result of one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The setting.
    pub setting: Setting,
    /// The largest error of the position, m; none where the motion leaves the range of the scalar before.
    pub max_error: Option<f64>,
    /// Whether the error exceeds the distance of the references by enough to be known.
    pub is_known: bool,
    /// The time from which the position is off by more than a hundredth of the motion's reach, s; none where it never
    /// is.
    pub horizon: Option<f64>,
    /// The time per simulated second, ns.
    pub time: Time,
    /// Whether no other setting is both as fast and as accurate.
    pub is_on_front: bool,
}

impl Study {
    /// Computes `scene` in every setting; `watch` receives the share that is done, and may end the study.
    ///
    /// # Errors
    /// See [`AccuracyError`].
    pub fn watched(
        name: &str,
        scene: &Scene,
        watch: &(dyn Fn(f64) -> ControlFlow<()> + Sync),
    ) -> Result<Self, AccuracyError> {
        if scene.dimensions() > 1 {
            return Err(AccuracyError::Space { scene: name.to_owned() });
        }
        Self::of(name, scene, Progress::new(watch)).map_err(|error| error.on(scene))
    }

    fn of(name: &str, scene: &Scene, progress: Progress<'_>) -> Result<Self, AccuracyError> {
        let ticks = (scene.ticks() + 1).min(MOST_TICKS) as usize;
        let references = References::of(scene, ticks, progress.part(0.0, 0.15))?;
        let growth = Growth::of(scene, &references, progress.part(0.15, 0.25))?;
        let all_ticks = references.first.len();
        let window = growth.grown_at;
        let (believed, settings) = (BELIEVED * references.reach(), Setting::all(scene));
        let distance = references.distance(window);
        let done = AtomicUsize::new(0);
        let row = |(setting, scene): &(Setting, Scene)| -> Result<Row, AccuracyError> {
            let part = done.load(Relaxed) as f64 / settings.len() as f64;
            let part = progress.part(0.25, 0.45).part(part, part);
            let errors = errors(scene, setting.number, &references, part)?;
            done.fetch_add(1, Relaxed);
            let max_error = largest(&errors, window);
            let left = errors.iter().position(|error| error.is_nan() || *error > believed);
            let horizon = left.map(|tick| tick as f64 * scene.period());
            Ok(Row::untimed(*setting, max_error, SURE * distance, horizon))
        };
        let mut rows = settings.par_iter().map(row).collect::<Result<Vec<_>, _>>()?;
        let (times, rounds) = timing::times(&settings, ticks, progress.part(0.45, 0.85))?;
        let ledger = ledger::rows(progress.part(0.85, 1.0))?;
        for (row, time) in rows.iter_mut().zip(times) {
            row.time = time;
        }
        rank(&mut rows);
        let agreeing = references.agree_within(believed / SURE);
        let second = references.second;
        let basis = Basis {
            second,
            distance,
            ticks: window,
            all_ticks,
            believed,
            agreeing,
            growth,
            rounds,
        };
        Ok(Self { name: name.to_owned(), scene: scene.clone(), rows, ledger, basis })
    }

    /// The fastest setting whose error is at most `metres`.
    pub fn cheapest(&self, metres: f64) -> Option<&Row> {
        self.rows.iter().find(|row| row.max_error.is_some_and(|error| error <= metres))
    }

    /// The most accurate setting, and of several the fastest.
    pub fn nearest(&self) -> Option<&Row> {
        let known = self.rows.iter().filter_map(|row| Some((row, row.max_error?)));
        known.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(row, _)| row)
    }

    /// The setting to choose for an error of at most `metres`, in words and as the keys of a scene file.
    pub fn advice(&self, metres: f64) -> String {
        let (row, which) = match (self.cheapest(metres), self.nearest()) {
            (Some(row), _) => (row, format!("the fastest within {metres:e} m")),
            (None, Some(row)) => (row, format!("no setting is within {metres:e} m; the nearest")),
            (None, None) => return "every setting leaves the range of its scalar\n".to_owned(),
        };
        let (setting, error) = (row.setting, row.error());
        let (name, number) = (setting.integrator.name(), setting.number.name());
        format!("{which} is {name} in {number}, off by {error}:\n{}", setting.keys(&self.scene))
    }
}

impl Row {
    fn untimed(
        setting: Setting,
        max_error: Option<f64>,
        least_known: f64,
        horizon: Option<f64>,
    ) -> Self {
        let is_known = max_error.is_some_and(|error| error >= least_known);
        let time = Time { median: 0.0, spread: 0.0 };
        Self { setting, max_error, is_known, horizon, time, is_on_front: false }
    }
}

impl std::fmt::Display for Study {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        table::write(self, f)
    }
}

/// Puts the fastest first and marks the front.
fn rank(rows: &mut [Row]) {
    rows.sort_by(|one, other| one.time.median.total_cmp(&other.time.median));
    let points: Vec<_> = rows.iter().map(|row| (row.time.median, row.max_error)).collect();
    for (row, is_on_front) in rows.iter_mut().zip(front(&points)) {
        row.is_on_front = is_on_front;
    }
}

/// The error of `scene` in numbers like these at every tick of the reference, m; NaN once it has left the range of its
/// scalar.
fn errors(
    scene: &Scene,
    number: Number,
    references: &References,
    progress: Progress<'_>,
) -> Result<Vec<f64>, AccuracyError> {
    match number {
        Number::F64 => errors_of::<f64>(scene, references, progress),
        Number::F32 | Number::F32WithWideLedger => errors_of::<f32>(scene, references, progress),
    }
}

fn errors_of<T: Space + Scalar<Real = f64>>(
    scene: &Scene,
    references: &References,
    progress: Progress<'_>,
) -> Result<Vec<f64>, AccuracyError> {
    let first = &references.first;
    let run = trace::<T>(Assembly::of(scene)?, first.len(), progress)?;
    let mut errors = vec![f64::NAN; first.len()];
    for ((error, reference), state) in errors.iter_mut().zip(first).zip(&run) {
        *error = off(reference[0], DoubleDouble::of(state[0]));
    }
    Ok(errors)
}

/// The largest of the first `ticks` errors, if all are finite.
fn largest(errors: &[f64], ticks: usize) -> Option<f64> {
    let within = &errors[..ticks.min(errors.len())];
    let all = within.iter().all(|error| error.is_finite());
    all.then(|| within.iter().copied().fold(0.0, f64::max))
}

/// Marks the points that no other beats: no other is at least as cheap and as accurate, and better in one of the two.
pub(super) fn front(points: &[(f64, Option<f64>)]) -> Vec<bool> {
    let worst = |error: Option<f64>| error.unwrap_or(f64::INFINITY);
    let beats = |(cost, error): &(f64, Option<f64>), than: &(f64, Option<f64>)| {
        let (error, other) = (worst(*error), worst(than.1));
        *cost <= than.0 && error <= other && (*cost < than.0 || error < other)
    };
    let kept = |point: &(f64, Option<f64>)| {
        point.1.is_some() && !points.iter().any(|other| beats(other, point))
    };
    points.iter().map(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_holds_the_points_that_no_other_beats() {
        let points = [
            (1.0, Some(1e-3)),
            (2.0, Some(1e-6)),
            (2.0, Some(1e-5)),
            (3.0, Some(1e-6)),
            (0.5, None),
            (9.0, Some(0.0)),
        ];
        assert_eq!(front(&points), [true, true, false, false, false, true]);
    }
}
