//! Figure of a tuning.

use lyapunov_figures::{Figure, Panel, Series};

use super::objective::Objective;
use super::study::Tuned;
use crate::text::file_name;

/// Height of a stabilizer's pair of bars, in pixels of the drawing.
const ROW: f64 = 40.0;

/// Distance of the two bars of a row from its middle, in rows.
const APART: f64 = 0.17;

/// The mean cost of the default and of the tuned setting of each stabilizer, on runs that the search never saw.
pub fn figure(name: &str, objective: Objective, tuned: &[Tuned]) -> Figure {
    let unit = objective.unit();
    let label = if unit.is_empty() { "mean cost".to_owned() } else { format!("mean cost, {unit}") };
    let bars = |which: usize, side: f64| -> Vec<(f64, f64, f64)> {
        let rows = tuned.iter().enumerate();
        let told = rows.filter_map(|(row, one)| Some((row, one.judged[which].cost()?)));
        told.map(|(row, cost)| (0.0, cost, side - row as f64)).collect()
    };
    let panel = Panel::new("default (upper bar) and tuned (lower bar)", label, "")
        .with_series(Series::bars("default", 0, &bars(0, APART)))
        .with_series(Series::bars("tuned", 1, &bars(1, -APART)))
        .with_rows(tuned.iter().map(|one| one.name.name().to_owned()).collect());
    let height = (ROW * tuned.len() as f64).max(2.0 * ROW);
    Figure::new(file_name(name)).with_width(960.0).with_panel_height(height).with_panel(panel)
}
