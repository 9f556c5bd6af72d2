//! Entrants whose runs are equal.

use super::comparison::Outcome;
use super::score::Score;

/// Entrants whose runs are equal in every number and on every tick, in the order of the table: the first stands for all.
#[derive(Clone, Debug)]
pub(super) struct Equals<'a>(Vec<&'a Outcome>);

impl<'a> Equals<'a> {
    /// The groups of `outcomes`, each in the place of its first.
    pub(super) fn of(outcomes: impl IntoIterator<Item = &'a Outcome>) -> Vec<Self> {
        let mut groups: Vec<Self> = Vec::new();
        for outcome in outcomes {
            match groups.iter_mut().find(|group| is_equal(group.first(), outcome)) {
                Some(group) => group.0.push(outcome),
                None => groups.push(Self(vec![outcome])),
            }
        }
        groups
    }

    /// The outcome that stands for all.
    pub(super) fn first(&self) -> &'a Outcome {
        self.0[0]
    }

    /// The scores of all.
    pub(super) fn scores(&self) -> impl Iterator<Item = &'a Score> {
        self.0.iter().map(|outcome| &outcome.score)
    }

    /// Whether there are several.
    pub(super) fn are_many(&self) -> bool {
        self.0.len() > 1
    }

    /// All names, `popc = lolc-spring`.
    pub(super) fn names(&self) -> String {
        let names: Vec<&str> = self.scores().map(|score| &score.stabilizer[..]).collect();
        names.join(" = ")
    }

    /// The name for a narrow place: all names, or the first and the number of the others.
    pub(super) fn short_name(&self, room: usize) -> String {
        let names = self.names();
        match self.0.len() {
            1 => names,
            _ if names.chars().count() <= room => names,
            2 => format!("{} = 1 other", self.first().score.stabilizer),
            many => format!("{} = {} others", self.first().score.stabilizer, many - 1),
        }
    }
}

/// Whether two runs are equal, but for the cost of their steps.
fn is_equal(one: &Outcome, other: &Outcome) -> bool {
    let behaviour = |outcome: &Outcome| Score {
        stabilizer: String::new(),
        step_time: None,
        state_bytes: 0,
        ..outcome.score.clone()
    };
    behaviour(one) == behaviour(other) && one.curves == other.curves
}
