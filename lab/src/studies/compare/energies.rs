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
use crate::show::energy_bars;
use crate::simulate::{Rollout, Space};
use crate::text::{file_name, shortened_names};
use lyapunov_figures::Figure;

/// Room for the names of a row, in characters.
const ROOM: usize = 30;

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
            let refused = |error| CompareError::of(error, name, &comparison.name, scene);
            let told = balance(outcome.number).map_err(refused)?;
            match watch(scene.ticks() + 1) {
                ControlFlow::Continue(()) => Ok((name.clone(), Some(told))),
                ControlFlow::Break(()) => Err(CompareError::Stopped),
            }
        });
        let title = format!("{}: {}", file_name(&comparison.name), Setting(scene));
        Ok(Self { title, rows: rows.collect::<Result<_, _>>()? })
    }

    /// Two bars for each entrant: the energy that came in, and where it went; equal balances once.
    pub fn figure(&self) -> Figure {
        let mut rows: Vec<(Vec<&str>, Option<&Balance>)> = Vec::new();
        for (name, balance) in &self.rows {
            let known = rows.iter_mut().find(|row| row.1.is_some() && row.1 == balance.as_ref());
            match known {
                Some((names, _)) => names.push(name),
                None => rows.push((vec![name], balance.as_ref())),
            }
        }
        let named = |(names, balance): (Vec<&str>, _)| (shortened_names(&names, ROOM), balance);
        let rows: Vec<_> = rows.into_iter().map(named).collect();
        let title = "energy by cause: came in (upper bars), went (lower bars)";
        let height = energy_bars::ROW * rows.len() as f64;
        Figure::new(self.title.clone())
            .with_width(960.0)
            .with_panel_height(height.max(2.0 * energy_bars::ROW))
            .with_panel(energy_bars::panel(title, &rows))
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
