//! Contest of all rows, in turn and round by round.

use indicatif::ProgressBar;

use crate::reference::Reference;
use crate::row::{NOWHERE, Origin, Row, Setting};

/// Measured row.
pub(crate) struct Line {
    pub(crate) origin: Origin,
    pub(crate) method: String,
    pub(crate) setting: Setting,
    /// The largest error against the reference, m.
    pub(crate) error: f64,
    /// ns per simulated second, of each round.
    pub(crate) times: Vec<f64>,
}

impl Line {
    /// The name in reports: `peers/<method>/<setting>`.
    pub(crate) fn id(&self) -> String {
        let method = self.method.replace(' ', "-");
        match self.setting {
            Setting::None => format!("peers/{method}"),
            Setting::Steps(steps) => format!("peers/{method}/{steps}"),
            Setting::Tolerance(_) => format!("peers/{method}/{}", self.setting),
        }
    }

    /// The quartiles of the time, ns per simulated second.
    pub(crate) fn quartiles(&self) -> [f64; 3] {
        quartiles(self.times.clone())
    }

    /// The time as a multiple of `other`'s: the median over rounds, so that a machine that slows down slows both.
    pub(crate) fn over(&self, other: &Self) -> f64 {
        let ratios = self.times.iter().zip(&other.times).map(|(mine, others)| mine / others);
        quartiles(ratios.collect())[1]
    }
}

fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_unstable_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values[(values.len() - 1) * quarter / 4])
}

/// Measured rows, and the failed ones.
pub(crate) struct Contest {
    pub(crate) lines: Vec<Line>,
    /// Rows that failed in their first run, and why.
    pub(crate) skipped: Vec<[String; 2]>,
}

impl Contest {
    /// The contest of `rows`: each runs once for its error, then all that differ run in turn for `rounds` rounds.
    pub(crate) fn held(rows: Vec<Row>, rounds: usize, bar: &ProgressBar) -> Result<Self, String> {
        let reference = Reference::new();
        let (mut rivals, mut lines, mut skipped) = (Vec::new(), Vec::<Line>::new(), Vec::new());
        let mut last = NOWHERE;
        bar.set_length(rows.len() as u64);
        for mut row in rows {
            bar.inc(1);
            let mut positions = NOWHERE;
            if let Err(reason) = (row.run)(&mut positions) {
                skipped.push([format!("{} {}", row.method, row.setting), reason]);
                continue;
            }
            // A tighter tolerance that takes the same steps does not count as a setting.
            let same_method = lines.last().is_some_and(|line| line.method == row.method);
            if same_method && positions == last {
                continue;
            }
            last = positions;
            rivals.push(row.run);
            lines.push(Line {
                origin: row.origin,
                method: row.method,
                setting: row.setting,
                error: reference.error(&positions),
                times: Vec::with_capacity(rounds),
            });
        }
        bar.set_position(0);
        bar.set_length((rounds * lines.len()) as u64);
        for _ in 0..rounds {
            for (line, run) in lines.iter_mut().zip(&mut rivals) {
                let mut positions = NOWHERE;
                line.times.push(run(&mut positions)?);
                bar.inc(1);
            }
        }
        bar.finish_and_clear();
        Ok(Self { lines, skipped })
    }
}
