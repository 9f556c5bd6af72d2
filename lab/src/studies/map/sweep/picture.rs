//! Curves of a sweep.

use lyapunov_figures::{Figure, Numbering, PALETTE, Panel, Series};

use super::Sweep;
use crate::measure::Verdict;
use crate::studies::compare::{Column, Score};
use crate::studies::map::picture::{Shown, label};
use crate::text::file_name;

/// Height of a stabilizer's row of verdicts, in pixels of the drawing.
const ROW: f64 = 18.0;

/// The most values that are marked one by one.
const MARKED: usize = 64;

/// The curves: title, name of the axis, column.
const CURVES: [(&str, &str, Column); 5] = [
    ("settling time", "settling time, s", Column::SettlingTime),
    ("force error", "force error, N rms", Column::ForceError),
    ("force felt", "force felt, %", Column::ForceFelt),
    ("stiffness felt", "stiffness felt, %", Column::StiffnessPercent),
    ("energy given by the port", "energy given, mJ", Column::EnergyGiven),
];

/// Colours of the verdicts among [`PALETTE`].
const VERDICTS: [usize; 4] = [2, 4, 1, 6];

/// The number of the first stabilizer that a curve belongs to, the names of all, and its points.
type Shared = (usize, String, Vec<(f64, f64)>);

impl Sweep {
    /// The verdict at each value, a row for each stabilizer.
    pub fn verdicts(&self) -> Figure {
        let names = self.stabilizers.iter().map(|member| member.name().to_owned()).collect();
        let shown = Shown::of(&self.x);
        let panel = Verdict::ALL.into_iter().fold(self.panel("verdict", ""), |panel, verdict| {
            let points = self.points.iter().flat_map(|point| {
                let told = point.scores.iter().enumerate().filter(|(_, it)| it.verdict == verdict);
                told.map(|(row, _)| (shown.place(point.value), -(row as f64))).collect::<Vec<_>>()
            });
            let points: Vec<(f64, f64)> = points.collect();
            if points.is_empty() {
                return panel;
            }
            panel.with_series(Series::dots(verdict.word(), VERDICTS[verdict as usize], points))
        });
        let height = (ROW * self.stabilizers.len() as f64).max(3.0 * ROW);
        Figure::new(file_name(&self.name))
            .with_width(960.0)
            .with_panel_height(height)
            .with_panel(panel.with_rows(names))
    }

    /// Settling time, force error, force and stiffness felt and energy given over the number: a curve for each stabilizer,
    /// equal ones once.
    pub fn curves(&self) -> Figure {
        let figure = Figure::new(file_name(&self.name)).with_width(960.0).with_panel_height(230.0);
        let drawn = |(_, curves): &(_, Vec<Shared>)| !curves.is_empty();
        let panels = CURVES.map(|panel| (panel, self.shared(panel.2)));
        // Where nothing is told, one panel says so.
        let told = panels.iter().any(drawn);
        let panels = panels.into_iter().enumerate();
        let panels = panels.filter(|(at, panel)| drawn(panel) || !told && *at == 0);
        let panels = panels.map(|(_, ((title, label, _), curves))| {
            curves.into_iter().fold(self.panel(title, label), |panel, (at, names, points)| {
                // Between gaps a line would hide a single value.
                let dots = points.len() <= MARKED;
                let panel = panel.with_series(Series::line(names, at, points.clone()));
                if dots {
                    panel.with_series(Series::dots("", at % PALETTE.len(), points))
                } else {
                    panel
                }
            })
        });
        panels.fold(figure, Figure::with_panel)
    }

    /// The curves of a column with some value.
    fn shared(&self, column: Column) -> Vec<Shared> {
        let mut curves: Vec<(usize, String, Vec<Option<f64>>)> = Vec::new();
        for (index, member) in self.stabilizers.iter().enumerate() {
            // A run that grows only shows how long it ran, and would flatten the others.
            let of =
                |score: &Score| column.value(score).filter(|_| score.verdict != Verdict::Grows);
            let values: Vec<_> = self.points.iter().map(|point| of(&point.scores[index])).collect();
            if values.iter().all(Option::is_none) {
                continue;
            }
            match curves.iter_mut().find(|(.., known)| *known == values) {
                Some((_, names, _)) => *names += &format!(" = {member}"),
                None => curves.push((index, member.name().to_owned(), values)),
            }
        }
        let shown = Shown::of(&self.x);
        let placed = |values: Vec<Option<f64>>| {
            let points = self.points.iter().zip(values);
            points.map(|(at, value)| (shown.place(at.value), value.unwrap_or(f64::NAN))).collect()
        };
        curves.into_iter().map(|(at, names, values)| (at, names, placed(values))).collect()
    }

    fn panel(&self, title: &str, of: &str) -> Panel {
        let shown = Shown::of(&self.x);
        Panel::new(title, label(&self.x), of)
            .with_numbers(shown.numbering, Numbering::Plain)
            .with_x_range(shown.range.0, shown.range.1)
    }
}
