//! Log in memory, without what cannot be used.

use std::io::Read;

use super::Settings;
use super::stretch::Stretch;
use crate::files::log::{BadRows, Column, Entry, Log, LogError, Sample, TimeStep, median_period};
use crate::measure::Oddity;
use crate::measure::sanity::LogSigns;

/// The most rows of a log.
const MOST: usize = 200_000;

/// Fewest rows of a stretch that is fitted to.
pub(super) const FEWEST_OF_STRETCH: usize = 8;

/// The good rows of a log, in stretches without a gap.
#[derive(Clone, Debug)]
pub struct Recording {
    /// The rows, their positions from the origin on.
    pub(super) stretches: Vec<Stretch>,
    /// The gaps of the log, also those beside stretches that are too short.
    pub(super) gaps: usize,
    /// The log's position nearest to 0, m: squares of positions far from it leave no digits.
    pub(super) origin: f64,
    /// The median period, s.
    pub(super) period: f64,
    /// The columns as they were read, and whether their numbers have decimal commas.
    pub(super) columns: Vec<Column>,
    pub(super) decimal_commas: bool,
    /// A sentence about axes that were not read.
    pub(super) unread_axes: Option<String>,
    pub(super) bad_rows: BadRows,
    /// The signs of a mistake in it.
    pub(super) look_at: Vec<Oddity>,
}

impl Recording {
    /// Reads the log called `name` to its end.
    ///
    /// # Errors
    /// A log without the requested columns, one that is too long or too short, a time that does not increase, and a stream
    /// that fails.
    pub fn read(log: impl Read, name: &str, settings: &Settings) -> Result<Self, LogError> {
        let mut log = Log::open(log, name, &settings.columns, &settings.scales)?;
        let mut bad_rows = BadRows::default();
        let (mut rows, mut spans): (Vec<(Sample, bool)>, bool) = (Vec::new(), false);
        let mut signs = LogSigns::new(None);
        while let Some(entry) = log.read().map_err(|error| LogError::unreadable(name, &error))? {
            match entry {
                Entry::Bad(bad) => {
                    bad_rows.add(bad.line, &bad.reason);
                    spans = true;
                }
                Entry::Good(sample) => {
                    if let Some(reason) = rows.last().and_then(|(last, _)| last.disorder(&sample)) {
                        let help = reason.remedy();
                        return Err(LogError::at(name, sample.line, reason).with_help(help));
                    }
                    signs.add(&sample);
                    rows.push((sample, std::mem::take(&mut spans)));
                }
            }
            if rows.len() > MOST {
                return Err(LogError::about(name, format!("more than {MOST} rows")).with_help(
                    "cut the log: some contacts and free motion between them are enough",
                ));
            }
        }
        if rows.len() < 2 {
            return Err(LogError::too_few(name, &bad_rows));
        }
        let period = median_period(rows.windows(2).map(|pair| step(&pair[0], &pair[1])));
        let look_at = signs.finish(period, bad_rows.count);
        let origin = origin(&rows);
        let (stretches, gaps) = stretches(&rows, origin, period);
        Ok(Self {
            stretches,
            gaps,
            origin,
            period,
            columns: log.columns().to_vec(),
            decimal_commas: log.has_decimal_commas(),
            unread_axes: log.unread_axes().map(str::to_owned),
            bad_rows,
            look_at,
        })
    }

    /// The number of rows that are fitted to.
    pub(super) fn rows(&self) -> usize {
        self.stretches.iter().map(Stretch::len).sum()
    }

    /// The first and the last of these rows' times since the log's first row, s.
    pub(super) fn times(&self) -> Option<(f64, f64)> {
        Some((*self.stretches.first()?.times.first()?, *self.stretches.last()?.times.last()?))
    }

    /// The mean time step within the stretches, s: of stamps that are rounded or late now and then, the clock behind them.
    pub(super) fn mean_period(&self) -> f64 {
        let time: f64 = self.stretches.iter().map(|it| it.times[it.len() - 1] - it.times[0]).sum();
        let steps: usize = self.stretches.iter().map(|it| it.len() - 1).sum();
        if steps > 0 { time / steps as f64 } else { self.period }
    }

    /// The deviation of the time steps within the stretches from their mean, root mean square, s.
    pub(super) fn scatter(&self) -> f64 {
        let mean = self.mean_period();
        let steps = || self.stretches.iter().flat_map(|it| it.times.windows(2));
        let squares: f64 = steps().map(|it| (it[1] - it[0] - mean).powi(2)).sum();
        (squares / steps().count().max(1) as f64).sqrt()
    }

    /// The largest magnitude of the force, N.
    pub(super) fn largest_force(&self) -> f64 {
        self.stretches.iter().flat_map(|it| &it.forces).fold(0.0_f64, |most, it| most.max(it.abs()))
    }

    /// The least and the largest position, from the origin on, m.
    pub(super) fn ends(&self) -> [f64; 2] {
        let positions = || self.stretches.iter().flat_map(|it| &it.positions);
        let low = positions().copied().fold(f64::INFINITY, f64::min);
        [low, positions().copied().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The way from the least to the largest position, m.
    pub(super) fn travel(&self) -> f64 {
        let [low, high] = self.ends();
        high - low
    }

    /// The step of the grid on which all positions lie, m: an encoder's, or that of the digits written.
    pub(super) fn resolution(&self) -> Option<f64> {
        self.grid(|it| &it.positions)
    }

    /// The step of the grid on which all forces lie, N.
    pub(super) fn force_step(&self) -> Option<f64> {
        self.grid(|it| &it.forces)
    }

    fn grid(&self, values: impl Fn(&Stretch) -> &[f64]) -> Option<f64> {
        let moved = |stretch: &Stretch| {
            let pairs = values(stretch).windows(2);
            pairs.map(|it| (it[1] - it[0]).abs()).filter(|it| *it > 0.0).collect::<Vec<_>>()
        };
        let moves: Vec<f64> = self.stretches.iter().flat_map(moved).collect();
        let step = moves.iter().copied().reduce(f64::min)?;
        // A step of which a move has a million is the rounding of a number, and not that of an encoder.
        let is_grid = |step: f64| {
            moves.iter().all(|it| ((it / step).round() - it / step).abs() < 1e-3 && it / step < 1e6)
        };
        if moves.len() < 8 || !is_grid(step) {
            return None;
        }
        let (steps, way) =
            moves.iter().fold((0.0, 0.0), |sum, it| (sum.0 + (it / step).round(), sum.1 + it));
        Some(way / steps)
    }
}

/// The time step from a row to the next.
fn step(row: &(Sample, bool), next: &(Sample, bool)) -> TimeStep {
    TimeStep { length: next.0.since - row.0.since, spans: next.1 }
}

/// The position nearest to 0 between the ends of the log, m.
fn origin(rows: &[(Sample, bool)]) -> f64 {
    let low = rows.iter().map(|it| it.0.x).fold(f64::INFINITY, f64::min);
    let high = rows.iter().map(|it| it.0.x).fold(low, f64::max);
    low.max(0.0).min(high)
}

/// The stretches that are long enough, and the number of gaps.
fn stretches(rows: &[(Sample, bool)], origin: f64, period: f64) -> (Vec<Stretch>, usize) {
    let goes_on = |row: &(Sample, bool), next: &(Sample, bool)| {
        let step = step(row, next);
        !step.spans && !step.is_gap(period)
    };
    let parts = || rows.chunk_by(goes_on);
    let long = parts().filter(|it| it.len() >= FEWEST_OF_STRETCH);
    let stretch = |rows: &[(Sample, bool)]| Stretch {
        times: rows.iter().map(|it| it.0.since).collect(),
        positions: rows.iter().map(|it| it.0.x - origin).collect(),
        forces: rows.iter().map(|it| it.0.f).collect(),
        velocities: rows.iter().filter_map(|it| it.0.v).collect(),
    };
    (long.map(stretch).collect(), parts().count() - 1)
}
