//! Figure of the forces that stabilizers would have added.

use lyapunov_figures::{Figure, Guide, Panel, Series};

use super::{Replay, Replayed};
use crate::text::found;

impl Replay {
    /// Stabilizers that show the same numbers: their names, and the row that stands for all.
    pub(super) fn groups(&self) -> Vec<(String, &Replayed)> {
        let mut groups: Vec<(String, &Replayed)> = Vec::new();
        for row in &self.stabilizers {
            match groups.iter_mut().find(|(_, first)| shown(first) == shown(row)) {
                Some((names, _)) => *names += &format!(" = {}", row.stabilizer),
                None => groups.push((row.stabilizer.to_owned(), row)),
            }
        }
        groups
    }

    /// Figure with a panel for each stabilizer that would have acted, on the same scales; none where nobody would have.
    pub fn figure(&self, title: &str) -> Option<Figure> {
        let mut figure = Figure::new(title).with_width(840.0).with_panel_height(130.0);
        let acts = self.groups().into_iter().filter(|(_, row)| row.active_ticks > 0);
        let curves: Vec<(String, Vec<(f64, f64)>)> = acts
            .map(|(names, row)| {
                let at = self.stabilizers.iter().position(|it| it.stabilizer == row.stabilizer);
                let curve = at.map(|at| self.traces[at].points().collect()).unwrap_or_default();
                (names, curve)
            })
            .collect();
        let values = || curves.iter().flat_map(|(_, curve)| curve.iter().map(|point| point.1));
        let [low, high] = [values().fold(0.0, f64::min), values().fold(0.0, f64::max)];
        let room = 0.05 * (high - low);
        for (names, curve) in curves {
            let panel = Panel::new(names, "time, s", "force, N")
                .with_y_range(low - room, high + room)
                .with_series(Series::steps("", figure.panels.len() % 6, curve))
                .with_guide(Guide::horizontal(0.0, ""));
            figure = figure.with_panel(panel);
        }
        let columns = if figure.panels.len() > 4 { 2 } else { 1 };
        (!figure.panels.is_empty()).then(|| figure.with_columns(columns))
    }

    /// The sentence under the figure.
    pub(in crate::studies::observe) fn caption(&self) -> String {
        let idle: Vec<&str> = self
            .stabilizers
            .iter()
            .filter(|it| it.active_ticks == 0)
            .map(|it| it.stabilizer)
            .collect();
        let mut text = "The force that each would have added to the recorded one.".to_owned();
        if !idle.is_empty() {
            text += &format!(" Without a force: {}.", idle.join(", "));
        }
        text
    }
}

/// The numbers of a row as they are shown.
fn shown(row: &Replayed) -> Vec<String> {
    let number = |value: f64| found(value).to_string();
    let at = |time: Option<f64>| time.map_or_else(String::new, number);
    let sizes =
        [row.largest_force, row.rms_force, row.energy_taken, row.shortfall, row.energy_given];
    let times = [row.first_at, row.largest_force_at].map(at);
    sizes.map(number).into_iter().chain(times).chain([row.active_ticks.to_string()]).collect()
}
