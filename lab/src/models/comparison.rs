//! All contestants on one model.

use std::fmt;
use std::ops::ControlFlow;

use lyapunov::ParameterError;

use super::building::built;
use super::contestant::Contestant;
use super::model::Model;
use super::outcome::{Outcome, Score};
use super::{picture, rig, table};
use crate::chart::Figure;

/// All contestants on one model; shown, it is the table of `lyapunov compare`.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// What the model is called: usually the path of its file.
    pub name: String,
    /// The model.
    pub model: Model,
    /// V at the start.
    pub began: f64,
    pub(super) outcomes: Vec<Outcome>,
}

/// Why there is no comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CompareError {
    /// The model was never checked: its loop cannot be built.
    Parameter(ParameterError),
    /// Whoever watched said so.
    Stopped,
}

impl fmt::Display for CompareError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => error.fmt(f),
            Self::Stopped => f.write_str("the comparison was stopped"),
        }
    }
}

impl std::error::Error for CompareError {}

impl Comparison {
    /// Runs all contestants on `model`, telling `watch` now and then how many more ticks are done; it says whether to
    /// go on.
    ///
    /// # Errors
    /// [`CompareError::Stopped`] if `watch` says so; a model that [`Model::check`] would refuse.
    pub fn of(
        name: &str,
        model: &Model,
        watch: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Self, CompareError> {
        let built = built(model).map_err(|(_, error)| CompareError::Parameter(error))?;
        let run = |contestant| built.run(contestant, watch);
        let outcomes: Result<Vec<Outcome>, rig::Stopped> =
            Contestant::ALL.into_iter().map(run).collect();
        let outcomes = outcomes.map_err(|rig::Stopped| CompareError::Stopped)?;
        Ok(Self { name: name.to_owned(), model: model.clone(), began: built.began(), outcomes })
    }

    /// What each contestant came to.
    pub fn scores(&self) -> impl Iterator<Item = &Score> {
        self.outcomes.iter().map(|outcome| &outcome.score)
    }

    /// Time in s and V of each contestant, at every tick, or of a long run the extremes of each of some thousand
    /// stretches.
    pub fn curves(&self) -> impl Iterator<Item = (Contestant, &[(f64, f64)])> {
        self.outcomes.iter().map(|outcome| (outcome.contestant, &outcome.curve[..]))
    }

    /// [`Comparison::curves`] as comma-separated values, in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let rows = self.curves().flat_map(|(contestant, curve)| {
            curve.iter().map(move |(t, v)| format!("{},{t:?},{v:?}\n", contestant.name()))
        });
        std::iter::once("stabilizer,t,v\n".to_owned()).chain(rows).collect()
    }

    /// V over time of all contestants, drawn over each other.
    pub fn figure(&self) -> Figure {
        picture::of(self)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table::write(self, f)
    }
}
