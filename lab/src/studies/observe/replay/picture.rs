//! Figure of the forces that stabilizers would have added.

use lyapunov_figures::{Figure, Guide, Panel, Series};

use super::Replay;

impl Replay {
    /// Figure with a panel for each stabilizer that would have acted, on the same scales; none where nobody would have.
    pub fn figure(&self, title: &str) -> Option<Figure> {
        let mut figure = Figure::new(title).with_width(840.0).with_panel_height(130.0);
        let acts = self.groups().into_iter().filter(|group| group.row.active_ticks > 0);
        let curves: Vec<(String, Vec<(f64, f64)>)> =
            acts.map(|group| (group.name(), self.traces[group.index].points().collect())).collect();
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
