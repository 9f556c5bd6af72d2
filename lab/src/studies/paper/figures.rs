//! The paper's figures 6 to 9.

use super::{Case, PaperError};
use crate::simulate::Row;
use lyapunov_figures::{Figure, Guide, Inset, Panel, Series};

/// A figure, with the name of its files without an ending and the cases that it is drawn from.
pub type PaperFigure = (&'static str, Figure, &'static [Case]);

/// The names of the figures.
pub const FIGURES: [&str; 4] = ["figure-6", "figure-7", "figure-8", "figure-9"];

/// The paper's figures 6 to 9.
///
/// # Errors
/// None as long as the shipped scene files are valid.
pub fn figures() -> Result<[PaperFigure; 4], PaperError> {
    let plain8k = Case::Plain8k.rows()?;
    let lolc8k = Case::Lolc8k.rows()?;
    let (popc50k, lolc50k) = (Case::Popc50k.rows()?, Case::Lolc50k.rows()?);
    const STIFF: &[Case] = &[Case::Popc50k, Case::Lolc50k];
    Ok([
        (FIGURES[0], figure_6(&plain8k), &[Case::Plain8k]),
        (FIGURES[1], figure_7(&lolc8k), &[Case::Lolc8k]),
        (FIGURES[2], figure_8(&popc50k, &lolc50k), STIFF),
        (FIGURES[3], figure_9(&popc50k, &lolc50k), STIFF),
    ])
}

fn points(rows: &[Row], y: impl Fn(&Row) -> f64) -> Vec<(f64, f64)> {
    rows.iter().map(|row| (row.t, y(row))).collect()
}

const TIME: &str = "time, s";
const SURFACE: &str = "wall surface";

/// The colours that both have in a comparison with no stabilizer, which comes first there.
const POPC: usize = 1;
const LOLC: usize = 2;

fn figure_6(plain: &[Row]) -> Figure {
    let shown = 2.0;
    let title = "8 kN/m, 2 N·s/m, without control; the curve is cut off at ±60 mm";
    let panel = Panel::new(title, TIME, "position, mm")
        .with_series(Series::line("no control", 0, points(plain, |row| 1e3 * row.x)))
        .with_guide(Guide::horizontal(0.0, SURFACE))
        .with_x_range(0.0, shown)
        .with_y_range(-60.0, 60.0);
    Figure::new("Figure 6: without control the position is unstable").with_panel(panel)
}

fn figure_7(lolc: &[Row]) -> Figure {
    let line = |y: fn(&Row) -> f64| Series::line("LOLC", LOLC, points(lolc, y));
    let steps = |y: fn(&Row) -> f64| Series::steps("LOLC", LOLC, points(lolc, y));
    Figure::new("Figure 7: 8 kN/m and 2 N·s/m with the Lyapunov observer/controller")
        .with_columns(2)
        .with_width(960.0)
        .with_panel(
            Panel::new("(a) position", TIME, "position, mm")
                .with_series(line(|row| 1e3 * row.x))
                .with_guide(Guide::horizontal(0.0, SURFACE)),
        )
        .with_panel(
            Panel::new("(b) force of the environment", TIME, "force, N")
                .with_series(steps(|row| row.f_env)),
        )
        .with_panel(
            Panel::new("(c) force of the controller", TIME, "force, N")
                .with_series(steps(|row| row.f_ctl)),
        )
        .with_panel(
            Panel::new("(d) observed energy", TIME, "energy, mJ")
                .with_series(line(|row| 1e3 * row.observed_energy))
                .with_guide(Guide::horizontal(0.0, "")),
        )
}

fn figure_8(popc: &[Row], lolc: &[Row]) -> Figure {
    let panel = Panel::new("50 kN/m, 20 N·s/m", TIME, "position, mm")
        .with_series(Series::line("POPC", POPC, points(popc, |row| 1e3 * row.x)))
        .with_series(Series::line("LOLC", LOLC, points(lolc, |row| 1e3 * row.x)))
        .with_guide(Guide::horizontal(0.0, SURFACE))
        .with_x_range(0.0, 5.0)
        .with_inset(Inset::over(2.5, 4.0));
    Figure::new("Figure 8: position with POPC and with LOLC").with_width(840.0).with_panel(panel)
}

fn figure_9(popc: &[Row], lolc: &[Row]) -> Figure {
    let panel = Panel::new("50 kN/m, 20 N·s/m", TIME, "observed energy, mJ")
        .with_series(Series::line("POPC", POPC, points(popc, |row| 1e3 * row.observed_energy)))
        .with_series(Series::line("LOLC", LOLC, points(lolc, |row| 1e3 * row.observed_energy)))
        .with_guide(Guide::horizontal(0.0, ""))
        .with_x_range(0.0, 5.0)
        .with_inset(Inset::over(2.5, 4.0));
    Figure::new("Figure 9: observed energy with POPC and with LOLC")
        .with_width(840.0)
        .with_panel(panel)
}
