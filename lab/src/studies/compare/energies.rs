//! Energies by cause of each entrant's run.

use std::ops::ControlFlow;

use lyapunov::ParameterError;
use rayon::prelude::*;

use super::comparison::{CompareError, Comparison};
use super::entrant_run::Watch;
use super::entrants::Entrants;
use super::table::Setting;
use crate::measure::{Balance, Verdict};
use crate::show::csv::{self, Field};
use crate::simulate::{Rollout, Space};
use crate::text::file_name;
use lyapunov_figures::{Figure, Panel, Series};

/// Height of an entrant's pair of bars, in pixels of the drawing.
const ROW: f64 = 40.0;

/// Distance of the two bars of a row from its middle, in rows.
const APART: f64 = 0.17;

/// Parts below this share of all the energy are not drawn.
const SMALL: f64 = 1e-6;

/// Start, end and row of each bar.
type Bars = Vec<(f64, f64, f64)>;

/// The energies by cause of each entrant's whole run; docs/explain.md has the equations.
#[derive(Clone, Debug)]
pub struct Energies {
    title: String,
    /// The balance of each entrant, in the order of the table; none for a run that grows.
    rows: Vec<(String, Option<Balance>)>,
}

impl Energies {
    /// The energies of `comparison` with its `entrants`; `watch` receives how many more ticks are done.
    ///
    /// # Errors
    /// Those of [`Comparison::watched`].
    pub fn of<V: Space>(
        comparison: &Comparison,
        entrants: &Entrants<V>,
        watch: &Watch<'_>,
    ) -> Result<Self, CompareError> {
        let scene = &comparison.scene;
        // During the run `watch` is asked only whether to go on.
        let quiet = |_| watch(0);
        let balance = |number: usize| -> Result<Balance, ParameterError> {
            let fitted = entrants.entries()[number].fitted(scene)?;
            Balance::along(scene, Rollout::assemble(scene, fitted)?, &quiet)
        };
        let rows = comparison.outcomes.par_iter().map(|outcome| {
            let name = &outcome.score.stabilizer;
            if outcome.score.verdict == Verdict::Grows {
                return Ok((format!("{name} (grows)"), None));
            }
            let told = balance(outcome.number).map_err(|error| CompareError::Parameter {
                stabilizer: name.clone(),
                scene: comparison.name.clone(),
                error,
            })?;
            match watch(scene.ticks() + 1) {
                ControlFlow::Continue(()) => Ok((name.clone(), Some(told))),
                ControlFlow::Break(()) => Err(CompareError::Stopped),
            }
        });
        let title = format!("{}: {}", file_name(&comparison.name), Setting(scene));
        Ok(Self { title, rows: rows.collect::<Result<_, _>>()? })
    }

    /// Two bars for each entrant: the energy that came in, and where it went.
    pub fn figure(&self) -> Figure {
        let panel = Panel::new(
            "energy by cause: came in (upper bars), went (lower bars)",
            "energy, mJ",
            "",
        );
        let panel = self.parts().into_iter().fold(panel, |panel, (colour, name, bars)| {
            panel.with_series(Series::bars(name, colour, &bars))
        });
        let names: Vec<String> = self.rows.iter().map(|(name, _)| name.clone()).collect();
        let height = ROW * names.len() as f64;
        Figure::new(self.title.clone())
            .with_width(960.0)
            .with_panel_height(height.max(2.0 * ROW))
            .with_panel(panel.with_rows(names))
    }

    /// The parts that occur: the number of each among all, its name and its bars.
    fn parts(&self) -> Vec<(usize, &'static str, Bars)> {
        let names = Balance::default().parts().map(|(name, _)| name);
        let mut bars: Vec<Bars> = vec![Vec::new(); names.len()];
        for (row, balance) in self.rows.iter().enumerate() {
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

    /// The energy that each part gave, in J, as comma-separated values in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let records = self.rows.iter().flat_map(|(name, balance)| {
            let parts = balance.iter().flat_map(Balance::parts);
            parts.map(|(part, given)| {
                [Field::Text(name), Field::Text(part), Field::Number(given + 0.0)]
            })
        });
        csv::text(["stabilizer", "part", "given_j"], records)
    }
}
