//! Figure of master and slave over time, one panel per entrant.

use super::comparison::Comparison;
use super::table::setting;
use crate::measure::Verdict;
use crate::measure::summary::MILLI;
use crate::measure::teleoperation::Outcome;
use crate::text::file_name;
use lyapunov_figures::{Figure, Guide, Panel, Series};

/// Positions over time, all panels over one range: that of the runs that do not grow, and of one and a half times the start.
pub(super) fn of(comparison: &Comparison) -> Figure {
    let file = &comparison.file;
    let wall = file.slave.wall.map(|wall| MILLI * wall.position.get());
    let grows = |outcome: &&Outcome| outcome.score.verdict == Verdict::Grows;
    let others = comparison.outcomes.iter().filter(|outcome| !grows(outcome));
    let seen = others.flat_map(|it| it.curves.master.iter().chain(&it.curves.slave));
    let start = MILLI * file.master.start.get().abs();
    let largest = seen.fold(1.5 * start, |most, (_, x)| most.max(1.05 * MILLI * x.abs()));
    let mut figure = Figure::new(format!("{}: {}", file_name(&comparison.name), setting(file)))
        .with_columns(2)
        .with_width(1000.0)
        .with_panel_height(200.0);
    for outcome in &comparison.outcomes {
        let (score, curves) = (&outcome.score, &outcome.curves);
        let more = if grows(&outcome) { " (grows)" } else { "" };
        let mut panel =
            Panel::new(format!("{}{more}", score.stabilizer), "time, s", "position, mm")
                .with_x_range(0.0, file.duration.get())
                .with_y_range(-largest, largest);
        if let Some(surface) = wall {
            panel = panel.with_guide(Guide::horizontal(surface, "wall"));
        }
        for (index, (name, curve)) in
            [("master", &curves.master), ("slave", &curves.slave)].into_iter().enumerate()
        {
            let points = curve.iter().map(|(t, x)| (*t, MILLI * x)).collect();
            panel = panel.with_series(Series::line(name, index, points));
        }
        figure = figure.with_panel(panel);
    }
    figure
}
