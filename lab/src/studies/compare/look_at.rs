//! Signs of a mistake over all entrants on a scene.

use serde::Serialize;

use super::Comparison;
use crate::measure::Oddity;
use crate::text::folded;

/// A sign, and the entrants whose runs show it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct LookAt<'a> {
    #[serde(flatten)]
    oddity: &'a Oddity,
    stabilizers: Vec<&'a str>,
}

impl<'a> LookAt<'a> {
    /// The signs of a comparison, each once, in the order of its rows.
    pub(super) fn of(comparison: &'a Comparison) -> Vec<Self> {
        let mut signs: Vec<Self> = Vec::new();
        for outcome in &comparison.outcomes {
            let name = &outcome.score.stabilizer[..];
            for oddity in &outcome.look_at {
                match signs.iter_mut().find(|it| it.oddity == oddity) {
                    Some(known) => known.stabilizers.push(name),
                    None => signs.push(Self { oddity, stabilizers: vec![name] }),
                }
            }
        }
        signs
    }

    /// The sign in a line; without names if `all` entrants show it.
    pub(super) fn line(&self, all: usize) -> String {
        let text = &self.oddity.text;
        match self.stabilizers.len() == all {
            true => folded("look at: ", text),
            false => folded("look at: ", &format!("{}: {text}", self.stabilizers.join(", "))),
        }
    }
}
