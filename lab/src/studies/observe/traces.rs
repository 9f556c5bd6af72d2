//! Curves of a log, thinned while it is read.

use super::marks::Marks;
use super::report::Report;
use crate::files::log::Sample;
use crate::show::envelope::Envelope;
use crate::text::{file_name, prefix};
use lyapunov_figures::{Figure, Guide, Inset, Panel, Series};

/// Curves of a log, in a bounded number of points.
#[derive(Clone, Debug)]
pub struct Traces {
    position: Envelope,
    force: Envelope,
    held: Envelope,
    sampled: Envelope,
    gaps: Marks,
    bad_rows: Marks,
}

/// The least width of a mark, as a share of the log.
const MARK: f64 = 0.006;

impl Traces {
    pub(super) fn new() -> Self {
        let empty = Envelope::new();
        let (gaps, bad_rows) = (Marks::default(), Marks::default());
        let [position, force, held] = [0; 3].map(|_| empty.clone());
        Self { position, force, held, sampled: empty, gaps, bad_rows }
    }

    /// Adds a row with the observed energies up to it.
    pub(super) fn add(&mut self, sample: &Sample, held: f64, sampled: f64) {
        self.position.add(sample.t, sample.x);
        self.held.add(sample.t, held);
        self.sampled.add(sample.t, sampled);
    }

    /// Adds the force applied from a row on. The force of a log's last row acts over no step.
    pub(super) fn push(&mut self, time: f64, force: f64) {
        self.force.add(time, force);
    }

    /// Marks a gap.
    pub(super) fn gap(&mut self, from: f64, to: f64) {
        self.gaps.add(from, to);
    }

    /// Marks the time from the good row before some bad ones to the good row after them.
    pub(super) fn bad_rows(&mut self, from: f64, to: f64) {
        self.bad_rows.add(from, to);
    }

    /// Whether a gap or a bad row is marked.
    pub(super) fn has_marks(&self) -> bool {
        !(self.gaps.is_empty() && self.bad_rows.is_empty())
    }

    /// Panel of the gaps and bad rows.
    fn marks(&self, label: &str, origin: f64, report: &Report) -> Panel {
        let width = MARK * report.duration;
        let bars = |name: &str, marks: &Marks, row: usize| {
            let mut bars = marks.bars(-(row as f64), width);
            bars.iter_mut().for_each(|bar| (bar.0, bar.1) = (bar.0 - origin, bar.1 - origin));
            Series::bars(name, row, &bars)
        };
        Panel::new("(d) gaps and bad rows", label, "")
            .with_x_range(report.start - origin, report.end - origin)
            .with_rows(vec!["gap".to_owned(), "bad rows".to_owned()])
            .with_series(bars("gap", &self.gaps, 0))
            .with_series(bars("bad rows", &self.bad_rows, 1))
    }

    /// Figure of force, observed energies and position over time, and of gaps and bad rows where there are any.
    pub(super) fn figure(&self, report: &Report) -> Figure {
        // On an axis far from zero the numbers would be too long to distinguish.
        let far = report.start.abs() > 100.0 * report.duration;
        let origin = if far { report.start } else { 0.0 };
        let label =
            if far { format!("time after {} s, s", report.start) } else { "time, s".to_owned() };
        let curve = |envelope: &Envelope, factor: f64| -> Vec<(f64, f64)> {
            envelope.points().map(|(time, value)| (time - origin, value * factor)).collect()
        };
        let (metre, metres) = prefix(largest([&self.position]));
        let (joule, joules) = prefix(largest([&self.held, &self.sampled]));
        let energy = Panel::new("(b) observed energy", &label, format!("energy, {joules}J"))
            .with_series(
                Series::line("the paper's own sum, sampled", 1, curve(&self.sampled, joule))
                    .dashed(),
            )
            .with_series(Series::line("held", 0, curve(&self.held, joule)))
            .with_guide(Guide::horizontal(0.0, ""));
        let energy = match report.observed_energy.negative_at {
            Some(time) => {
                let width = (30.0 * report.median_period).max(0.04 * report.duration);
                let start = (time - width / 3.0).max(report.start) - origin;
                energy
                    .with_guide(Guide::vertical(time - origin, "first below zero"))
                    .with_inset(Inset::over(start, start + width))
            }
            None => energy,
        };
        let figure = Figure::new(file_name(&report.log))
            .with_width(840.0)
            .with_panel_height(190.0)
            .with_panel(
                Panel::new("(a) force of the environment", &label, "force, N")
                    .with_series(Series::steps("", 0, curve(&self.force, 1.0))),
            )
            .with_panel(energy)
            .with_panel(
                Panel::new("(c) position", &label, format!("position, {metres}m"))
                    .with_series(Series::line("", 0, curve(&self.position, metre))),
            );
        if self.has_marks() {
            figure.with_panel(self.marks(&label, origin, report))
        } else {
            figure
        }
    }
}

fn largest<'a>(envelopes: impl IntoIterator<Item = &'a Envelope>) -> f64 {
    let points = envelopes.into_iter().flat_map(Envelope::points);
    points.fold(0.0, |largest, (_, value)| value.abs().max(largest))
}
