//! Report of a run: a table for the terminal, and the same as JSON.

use std::fmt::{self, Display, Formatter};

use serde::Serialize;

use crate::contest::{Contest, Line};
use crate::marks::Mark;
use crate::row::{Origin, Setting};

/// Report of a run.
pub(crate) struct Report {
    contest: Contest,
    marks: Vec<Mark>,
    rounds: usize,
    versions: Vec<[String; 2]>,
    skipped: Vec<[String; 2]>,
}

/// Errors, m, under which the fastest setting of a peer is shown.
const LEVELS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-11];

impl Report {
    /// The report of `contest` over so many rounds, with the packages that were found and those that were not.
    pub(crate) fn new(
        mut contest: Contest,
        rounds: usize,
        versions: Vec<[String; 2]>,
        mut skipped: Vec<[String; 2]>,
    ) -> Self {
        skipped.append(&mut contest.skipped);
        let marks = Mark::all(&contest.lines);
        Self { contest, marks, rounds, versions, skipped }
    }

    /// Every row, with the marks.
    pub(crate) fn document(&self) -> Result<String, serde_json::Error> {
        let exact = &self.contest.lines[0];
        let rows = self.contest.lines.iter().map(|line| {
            let [lower, median, upper] = line.quartiles();
            let (steps_per_period, tolerance) = match line.setting {
                Setting::None => (None, None),
                Setting::Steps(steps) => (Some(steps), None),
                Setting::Tolerance(tolerance) => (None, Some(tolerance)),
            };
            Record {
                id: line.id(),
                method: &line.method,
                steps_per_period,
                tolerance,
                max_error: line.error,
                ns_per_simulated_second: median,
                quartiles: [lower, upper],
                over_exact: line.over(exact),
            }
        });
        let document = Document {
            rounds: self.rounds,
            rows: rows.collect(),
            marks: &self.marks,
            versions: &self.versions,
            skipped: &self.skipped,
        };
        serde_json::to_string_pretty(&document).map(|text| text + "\n")
    }

    /// The lines to show: all of ours and by hand, and of each peer's method the fastest below each level of error.
    fn shown(&self) -> impl Iterator<Item = &Line> {
        let fastest = |line: &Line| {
            let better = |level: f64| {
                let rivals = self.contest.lines.iter().filter(|it| it.method == line.method);
                rivals
                    .filter(|it| it.error < level)
                    .min_by(|a, b| a.quartiles()[1].total_cmp(&b.quartiles()[1]))
            };
            LEVELS
                .iter()
                .any(|&level| better(level).is_some_and(|best| best.setting == line.setting))
        };
        let kept = move |line: &&Line| match (line.origin, line.setting) {
            (Origin::Ours, _) | (Origin::Hand, Setting::Steps(_)) => true,
            (Origin::Hand | Origin::Crate | Origin::Python, _) => fastest(line),
        };
        self.contest.lines.iter().filter(kept)
    }
}

#[derive(Serialize)]
struct Document<'a> {
    rounds: usize,
    rows: Vec<Record<'a>>,
    marks: &'a [Mark],
    versions: &'a [[String; 2]],
    skipped: &'a [[String; 2]],
}

#[derive(Serialize)]
struct Record<'a> {
    id: String,
    method: &'a str,
    steps_per_period: Option<u32>,
    tolerance: Option<f64>,
    max_error: f64,
    ns_per_simulated_second: f64,
    quartiles: [f64; 2],
    over_exact: f64,
}

impl Display for Report {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        let exact = &self.contest.lines[0];
        writeln!(
            formatter,
            "{:<30} {:>9} {:>12} {:>12} {:>8} {:>10}",
            "method", "setting", "max error, m", "ns per sim s", "spread", "over exact"
        )?;
        for line in self.shown() {
            let [lower, median, upper] = line.quartiles();
            let spread = format!("{:.0} %", (upper - lower) / median * 100.0);
            writeln!(
                formatter,
                "{:<30} {:>9} {:>12.1e} {median:>12.0} {spread:>8} {:>10}",
                line.method,
                line.setting,
                line.error,
                ratio(line.over(exact)),
            )?;
        }
        writeln!(formatter)?;
        for [what, why] in &self.skipped {
            writeln!(formatter, "SKIPPED: {what}: {why}")?;
        }
        for mark in &self.marks {
            let (Some(by), Some(found), Some(met)) = (&mark.by, mark.found, mark.met) else {
                writeln!(formatter, "SKIPPED  {}: nothing to judge by", mark.demand)?;
                continue;
            };
            let found = if found < 0.01 { format!("{found:.1e}") } else { ratio(found) };
            let verdict = if met { "met" } else { "MISSED" };
            writeln!(formatter, "{verdict:<8} {}: {found} ({by})", mark.demand)?;
        }
        Ok(())
    }
}

/// `value` with three digits.
fn ratio(value: f64) -> String {
    let decimals = (2.0 - value.abs().log10().floor()).clamp(0.0, 2.0) as usize;
    format!("{value:.decimals$}")
}
