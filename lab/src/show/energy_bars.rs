//! Bars of energy by cause.

use lyapunov_figures::{Panel, Series};

use crate::measure::Balance;

/// Height of a row's pair of bars, in pixels of the drawing.
pub(crate) const ROW: f64 = 40.0;

/// Distance of the two bars of a row from its middle, in rows.
const APART: f64 = 0.17;

/// Parts below this share of all the energy are not drawn.
const SMALL: f64 = 1e-6;

/// Start, end and row of each bar.
type Bars = Vec<(f64, f64, f64)>;

/// Two bars for each row: the energy that came in, and where it went; none for a row without a balance.
pub(crate) fn panel(title: &str, rows: &[(String, Option<&Balance>)]) -> Panel {
    let panel = parts(rows)
        .into_iter()
        .fold(Panel::new(title, "energy, mJ", ""), |panel, (colour, name, bars)| {
            panel.with_series(Series::bars(name, colour, &bars))
        });
    panel.with_rows(rows.iter().map(|(name, _)| name.clone()).collect())
}

/// The parts that occur: the number of each among all, its name and its bars.
fn parts(rows: &[(String, Option<&Balance>)]) -> Vec<(usize, &'static str, Bars)> {
    let names = Balance::default().parts().map(|(name, _)| name);
    let mut bars: Vec<Bars> = vec![Vec::new(); names.len()];
    for (row, balance) in rows.iter().enumerate() {
        let Some(balance) = &balance.1 else { continue };
        let parts = balance.parts();
        let whole: f64 = parts.iter().map(|(_, given)| given.max(0.0)).sum();
        let [mut came, mut went] = [0.0; 2];
        for (bars, (_, given)) in bars.iter_mut().zip(parts) {
            if given.abs() <= SMALL * whole || !whole.is_finite() {
                continue;
            }
            let (reached, side) =
                if given > 0.0 { (&mut came, APART) } else { (&mut went, -APART) };
            let start = *reached;
            *reached += given.abs();
            bars.push((1e3 * start, 1e3 * *reached, side - row as f64));
        }
    }
    let named = names.into_iter().zip(bars).enumerate();
    let told = named.map(|(number, (name, bars))| (number, name, bars));
    told.filter(|(.., bars)| !bars.is_empty()).collect()
}
