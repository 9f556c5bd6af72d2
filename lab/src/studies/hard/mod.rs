//! Hard cases, each with a bound to keep: `lyapunov hard`.
//!
//! A [`Catalogue`] of [`Case`]s, each with its difficulty, a bound, a run of the paper's steps as printed ([`Naive`])
//! and runs of the shipped stabilizer in `f64`, `f32` and lanes. All measurements are made outside of the library.
//! [`Case::with`] runs your own stabilizer.

mod balance;
mod case;
mod cases;
pub mod faults;
mod looped;
mod member;
mod naive;
mod report;
mod sight;
pub mod soak;
mod table;
mod tally;
mod terms;
mod trial;
mod watched;

pub use case::{Case, Outcome, Row, Verdicts};
pub use naive::Naive;
pub use tally::Tally;
pub use trial::{HardError, MakeStabilizer};

use std::fmt;
use std::ops::ControlFlow;

use rayon::prelude::*;
use serde::Serialize;

use crate::show::csv::{self, Field};
use crate::show::json;
use crate::simulate::family::StabilizerName;

/// Results of the whole catalogue: `hard.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Catalogue {
    /// The member of the family that ran instead of our stabilizer, if one did.
    pub stabilizer: Option<&'static str>,
    /// One row for each case.
    pub rows: Vec<Row>,
}

impl Catalogue {
    /// The cases.
    pub fn cases() -> Vec<Case> {
        cases::all()
    }

    /// Results of all cases, run on all cores; `watch` is called after each case and may stop the catalogue.
    ///
    /// With a `member`, it runs instead of our stabilizer, in `f64` and `f32`, without the cases in which it takes no part.
    ///
    /// # Errors
    /// The conditions of [`HardError`].
    pub fn of(
        member: Option<StabilizerName>,
        watch: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Self, HardError> {
        let rows = Self::cases().into_par_iter().map(|case| {
            let row = match member {
                None => Some(case.row()?),
                Some(member) => case.row_of(member)?,
            };
            match watch() {
                ControlFlow::Continue(()) => Ok(row),
                ControlFlow::Break(()) => Err(HardError::Stopped),
            }
        });
        let rows = rows.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect();
        Ok(Self { stabilizer: member.map(StabilizerName::name), rows })
    }

    /// Whether every case passed.
    pub fn passed(&self) -> bool {
        self.rows.iter().all(|row| row.passed)
    }

    /// A self-contained HTML page; `command` is the command that made it.
    pub fn report(&self, command: &str) -> String {
        report::page(self, command)
    }

    /// A row for each case as comma-separated values.
    pub fn csv(&self) -> String {
        let rows = self.rows.iter().map(|row| {
            let naive = row.naive.as_ref().map(|naive| naive.measured);
            let words = [row.case, row.theme, row.quantity, row.unit].map(Field::Text);
            let numbers = [Some(row.bound), Some(row.measured), naive].map(Field::from);
            words.into_iter().chain(numbers).chain([Field::Text(row.verdict())])
        });
        let names = ["case", "theme", "quantity", "unit", "bound", "measured", "naive", "verdict"];
        csv::text(names, rows)
    }

    /// The results as JSON.
    pub fn to_json(&self) -> String {
        json::text(self)
    }
}

impl fmt::Display for Catalogue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table::write(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Scene;
    use crate::measure::Summary;
    use crate::simulate::{Rollout, Space};

    fn look_at<V: Space>(scene: &Scene) -> Vec<String> {
        let signs = Summary::of(scene, Rollout::<V>::of(scene).unwrap()).look_at();
        signs.into_iter().map(|it| it.text).collect()
    }

    /// Cases that are out of anything a hand does on purpose, and one whose encoder keeps a stabilizer at work at rest.
    const STRANGE: [&str; 6] = [
        "encoder chatter at rest",
        "grazing contact",
        "an active environment",
        "a stiff wall, two ticks late",
        "a fifth of the answers lost",
        "works of femtojoules",
    ];

    #[test]
    fn a_hard_case_looks_like_no_mistake_unless_it_is_strange_on_purpose() {
        let (mut scenes, mut strange) = (0, Vec::new());
        for case in Catalogue::cases() {
            let Some(text) = case.trial.scene() else { continue };
            let scene = Scene::parse(text, case.name).unwrap();
            let signs = match scene.dimensions() {
                1 => look_at::<f64>(&scene),
                2 => look_at::<nalgebra::SVector<f64, 2>>(&scene),
                _ => look_at::<nalgebra::SVector<f64, 3>>(&scene),
            };
            scenes += 1;
            if !signs.is_empty() {
                strange.push(case.name);
            }
        }
        strange.sort_unstable();
        let mut expected = STRANGE;
        expected.sort_unstable();
        assert_eq!(strange, expected);
        assert!(scenes > 20, "{scenes}");
    }
}
