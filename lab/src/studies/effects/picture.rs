//! Figure of the costs.

use lyapunov_figures::{Figure, Numbering, Panel, Series};

use super::{Column, Cost, Costs, Difference};

/// Height of an effect's row, in pixels of the drawing.
const ROW: f64 = 18.0;

impl Costs {
    /// A dot for the cost of each effect alone and with all others, a panel for each kind of number; a cost that cannot
    /// be told from zero has no dot.
    pub fn figure(&self) -> Figure {
        let title = self.scene.as_deref().unwrap_or("What each effect costs");
        let rows = self.scalars.first().map_or(0, |column| column.effects.len());
        let figure = Figure::new(title)
            .with_width(960.0)
            .with_columns(2)
            .with_panel_height((ROW * rows as f64).max(4.0 * ROW));
        let costs = self.scalars.iter().flat_map(|column| &column.effects);
        let told = costs.flat_map(|cost| [cost.alone, cost.composed]).filter(Difference::is_told);
        let exponents: Vec<f64> = told.map(|cost| cost.ns_per_step.log10()).collect();
        let low = exponents.iter().copied().fold(0.0, f64::min).floor();
        let high = exponents.iter().copied().fold(1.0, f64::max).ceil();
        let panels = self.scalars.iter().map(panel).map(|panel| panel.with_x_range(low, high));
        panels.fold(figure, Figure::with_panel)
    }
}

fn panel(column: &Column) -> Panel {
    let dots = |of: fn(&Cost) -> Difference| -> Vec<(f64, f64)> {
        let rows = column.effects.iter().enumerate();
        let told = rows.map(|(row, cost)| (of(cost), -(row as f64)));
        let told = told.filter(|(cost, _)| cost.is_told());
        told.map(|(cost, row)| (cost.ns_per_step.log10(), row)).collect()
    };
    let names = column.effects.iter().map(|cost| cost.effect.to_owned()).collect();
    Panel::new(column.scalar, "ns per step more than without", "")
        .with_numbers(Numbering::PowersOfTen, Numbering::Plain)
        .with_series(Series::dots("alone", 0, dots(|cost| cost.alone)))
        .with_series(Series::dots("with all others", 1, dots(|cost| cost.composed)))
        .with_rows(names)
}
