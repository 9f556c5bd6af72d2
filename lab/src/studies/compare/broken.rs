//! Loops that are bounded alone and grow under a stabilizer.

use std::fmt;

use serde::Serialize;

use super::Comparison;
use super::score::Score;
use crate::show::table::{Heading, Table};
use crate::simulate::family::BasicName;

/// The scenes that each stabilizer broke; its `Display` is a table.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Broken {
    rows: Vec<Row>,
}

/// Count of one stabilizer.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Row {
    stabilizer: String,
    /// Judged scenes that are bounded without a stabilizer.
    bounded_alone: usize,
    /// Those among them that grow under this one.
    broke: usize,
}

/// Whether the loop is bounded without a stabilizer; none where `none` takes no part, or the run is too short.
fn alone<'a>(scores: impl IntoIterator<Item = &'a Score>) -> Option<bool> {
    let name = BasicName::NoStabilizer.name();
    scores
        .into_iter()
        .find(|score| score.stabilizer == name)
        .and_then(|score| score.verdict.judged())
}

/// Marks those `scores` of one scene whose run grows although that of the loop alone does not.
pub(crate) fn mark(scores: &mut [Score]) {
    let Some(alone) = alone(&*scores) else { return };
    for score in scores {
        score.broke_it = score.verdict.judged().map(|bounded| alone && !bounded);
    }
}

impl Broken {
    /// The counts over all `comparisons` in which `none` takes part.
    pub fn of(comparisons: &[Comparison]) -> Self {
        let mut rows: Vec<Row> = Vec::new();
        for comparison in comparisons {
            let alone = alone(comparison.scores());
            for score in comparison.scores() {
                let (Some(alone), Some(broke)) = (alone, score.broke_it) else { continue };
                let named = |row: &Row| row.stabilizer == score.stabilizer;
                let at = rows.iter().position(named).unwrap_or(rows.len());
                if at == rows.len() {
                    let stabilizer = score.stabilizer.clone();
                    rows.push(Row { stabilizer, bounded_alone: 0, broke: 0 });
                }
                rows[at].bounded_alone += usize::from(alone);
                rows[at].broke += usize::from(broke);
            }
        }
        Self { rows }
    }

    /// Whether there is nothing to count.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The counts as a table.
    pub(super) fn table(&self) -> Table {
        let headings = [
            Heading::word("all scenes"),
            Heading::number("bounded\nalone"),
            Heading::number("broken\nof these"),
        ];
        let rows = self.rows.iter().map(|Row { stabilizer, bounded_alone, broke }| {
            [stabilizer.as_str().into(), bounded_alone.to_string().into(), broke.to_string().into()]
        });
        Table::new(headings).with_rows(rows)
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.table())
    }
}
