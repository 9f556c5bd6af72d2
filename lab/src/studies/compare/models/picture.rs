//! Figure of V of all entrants, overlaid.

use super::comparison::Comparison;
use super::table::setting;
use crate::measure::Verdict;
use crate::measure::models::BOUND;
use crate::text::file_name;
use crate::text::names::Named;
use lyapunov_figures::{Figure, Guide, Numbering, Panel, Series};

/// The most decades that are shown below and above V at the start.
const DECADES: f64 = 4.0;

/// V over time, as a share of V at the start, on a logarithmic axis.
pub(super) fn of(comparison: &Comparison) -> Figure {
    let end = comparison.model.duration.get();
    let mut panel = Panel::new("V, as a share of V at the start", "time, s", "V / V(0)")
        .with_numbers(Numbering::Plain, Numbering::PowersOfTen)
        .with_guide(Guide::horizontal(libm::log10(BOUND), "bound"));
    if end > 0.0 {
        panel = panel.with_x_range(0.0, end);
    }
    let (mut low, mut high) = (-1.0_f64, 1.0_f64);
    for (index, (entrant, curve)) in comparison.curves().enumerate() {
        let points: Vec<(f64, f64)> = curve
            .iter()
            .map(|(t, value)| (*t, libm::log10((value / comparison.began).max(0.0))))
            .collect();
        for (_, decades) in points.iter().filter(|point| point.1.is_finite()) {
            (low, high) = (low.min(*decades), high.max(*decades));
        }
        let grows = comparison.outcomes[index].score.verdict == Verdict::Grows;
        let name = format!("{}{}", entrant.name(), if grows { " (grows)" } else { "" });
        panel = panel.with_series(Series::line(name, index, points));
    }
    panel = panel.with_y_range(low.max(-DECADES), high.min(DECADES));
    Figure::new(format!("{}: {}", file_name(&comparison.name), setting(comparison)))
        .with_width(960.0)
        .with_panel_height(320.0)
        .with_panel(panel)
}
