//! Figure of error against time.

use super::Study;
use super::setting::Number;
use super::study::Row;
use crate::text::file_name;
use lyapunov_figures::{Figure, Numbering, Panel, Series};

/// The propagators, in the order of their colours.
const PROPAGATORS: [&str; 6] =
    ["exact", "semi-implicit-euler", "implicit-midpoint", "rk4", "dopri5", "dop853"];

impl Study {
    /// Error against time, both as powers of ten: one panel per scalar.
    pub fn figure(&self) -> Figure {
        let (x, y) = (span(self.points(|point| point.0)), span(self.points(|point| point.1)));
        let mut figure = Figure::new(format!("{}: error against time", file_name(&self.name)))
            .with_width(960.0)
            .with_panel_height(320.0);
        for number in [Number::F64, Number::F32, Number::F32WithWideLedger] {
            if !self.rows.iter().any(|row| row.setting.number == number) {
                continue;
            }
            let mut panel =
                Panel::new(number.name(), "time per simulated second, ns", "largest error, m")
                    .with_numbers(Numbering::PowersOfTen, Numbering::PowersOfTen)
                    .with_x_range(x.0, x.1)
                    .with_y_range(y.0, y.1);
            for (colour, propagator) in PROPAGATORS.into_iter().enumerate() {
                let points = self.curve(number, propagator);
                // The name stands at the line, which is easier to see than a dot.
                let (line, dots) =
                    if points.len() > 1 { (propagator, "") } else { ("", propagator) };
                if points.len() > 1 {
                    panel = panel.with_series(Series::line(line, colour, points.clone()));
                }
                if !points.is_empty() {
                    panel = panel.with_series(Series::dots(dots, colour, points));
                }
            }
            figure = figure.with_panel(panel);
        }
        figure
    }

    pub(super) fn curve(&self, number: Number, propagator: &str) -> Vec<(f64, f64)> {
        let of = |row: &&Row| {
            row.setting.number == number && row.setting.integrator.name() == propagator
        };
        let mut rows: Vec<&Row> = self.rows.iter().filter(of).collect();
        // From the coarsest step or tolerance to the finest.
        let fineness = |row: &Row| {
            let integrator = row.setting.integrator;
            let steps = integrator.steps_per_tick().map(f64::from);
            steps.or(integrator.tolerance().map(f64::recip)).unwrap_or(0.0)
        };
        rows.sort_by(|one, other| fineness(one).total_cmp(&fineness(other)));
        rows.into_iter().filter_map(point).collect()
    }

    fn points(&self, part: fn((f64, f64)) -> f64) -> impl Iterator<Item = f64> {
        self.rows.iter().filter_map(point).map(part)
    }
}

/// Exponents of time and error.
fn point(row: &Row) -> Option<(f64, f64)> {
    let error = row.max_error.filter(|error| *error > 0.0)?;
    Some((row.time.median.log10(), error.log10()))
}

/// The whole powers of ten that enclose the values.
fn span(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (value.min(low), value.max(high))
    });
    if low > high { (0.0, 1.0) } else { ((low - 0.3).floor(), (high + 0.3).ceil()) }
}
