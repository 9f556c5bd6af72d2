//! Tables of a sweep.

use std::cmp::Reverse;
use std::fmt;

use super::Sweep;
use crate::measure::Verdict;
use crate::show::table::{Heading, Table};
use crate::studies::compare::Column;
use crate::studies::map::remarks::remarks;
use crate::text::{found, given};

/// The most rows that the terminal shows.
const SHOWN: usize = 60;

/// The most stretches of a row that are told.
const STRETCHES: usize = 2;

/// The columns of the runs.
const COLUMNS: [Column; 6] = [
    Column::Verdict,
    Column::SettlingTime,
    Column::ForceError,
    Column::StiffnessPercent,
    Column::EnergyGiven,
    Column::ForceFelt,
];

impl Sweep {
    /// For each stabilizer how many values have each verdict.
    pub(super) fn counts(&self) -> Table {
        let headings = [
            Heading::word("stabilizer"),
            Heading::number("settles"),
            Heading::number("swinging"),
            Heading::number("grows"),
            Heading::number("too short"),
        ];
        let rows = self.stabilizers.iter().enumerate().map(|(index, member)| {
            let verdicts = || self.points.iter().map(|point| point.scores[index].verdict);
            let count = |it: Verdict| verdicts().filter(|verdict| *verdict == it).count();
            let counts = Verdict::ALL.map(|verdict| count(verdict).to_string().into());
            std::iter::once(member.name().into()).chain(counts)
        });
        Table::new(headings).with_rows(rows.map(Iterator::collect::<Vec<_>>))
    }

    /// For each stabilizer the stretches of values on which its runs settle and stay bounded.
    pub(super) fn stretches(&self) -> Table {
        let headings = ["stabilizer", "settles at", "bounded at"].map(Heading::word);
        let rows = self.stabilizers.iter().enumerate().map(|(index, member)| {
            let settles = self.stretches_where(index, |it| it == Verdict::Settles);
            let bounded = self.stretches_where(index, Verdict::is_bounded);
            [member.name().into(), settles.into(), bounded.into()]
        });
        Table::new(headings).with_rows(rows)
    }

    /// The stretches of neighbouring values at which all verdicts on stabilizer `index` are such, the longest first.
    fn stretches_where(&self, index: usize, are_such: fn(Verdict) -> bool) -> Option<String> {
        let is_such = |at: &usize| are_such(self.points[*at].scores[index].verdict);
        let such: Vec<usize> = (0..self.points.len()).filter(is_such).collect();
        let value = |at: usize| found(self.points[at].value);
        let all = longest_first(&such).into_iter().map(|stretch| match *stretch {
            [first, .., last] => format!("{} to {}", value(first), value(last)),
            _ => value(stretch[0]).to_string(),
        });
        let mut all: Vec<String> = all.collect();
        let more = all.len().saturating_sub(STRETCHES);
        all.truncate(STRETCHES);
        all.extend((more > 0).then(|| format!("{more} more")));
        (!all.is_empty()).then(|| all.join(", "))
    }

    /// A row for each value and stabilizer.
    pub(super) fn runs(&self) -> Table {
        let first = [Heading::word("stabilizer"), Heading::number(&self.x.key[..])];
        let headings = first.into_iter().chain(COLUMNS.map(Column::heading));
        let rows = self.rows().map(|(value, score)| {
            let cells = COLUMNS.map(|column| column.cell(score));
            let first = [score.stabilizer.as_str().into(), given(value).to_string().into()];
            first.into_iter().chain(cells).collect::<Vec<_>>()
        });
        Table::new(headings).with_rows(rows)
    }
}

/// The stretches of neighbours among rising numbers, the longest first.
fn longest_first(such: &[usize]) -> Vec<&[usize]> {
    let mut stretches: Vec<&[usize]> = such.chunk_by(|at, next| at + 1 == *next).collect();
    stretches.sort_by_key(|stretch| Reverse(stretch.len()));
    stretches
}

impl fmt::Display for Sweep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n{}", self.name, self.x)?;
        for note in remarks(&self.scene, &[&self.x]) {
            writeln!(f, "{note}")?;
        }
        write!(f, "\n{}\n{}", self.counts(), self.stretches())?;
        match self.rows().count() {
            count if count <= SHOWN => write!(f, "\n{}", self.runs()),
            count => writeln!(f, "\n{count} rows: --out DIR or --json has them"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_stretch_stands_first() {
        let told = longest_first(&[0, 1, 4, 6, 7, 8, 10, 11]);
        assert_eq!(told, [&[6, 7, 8][..], &[0, 1], &[10, 11], &[4]]);
        assert!(longest_first(&[]).is_empty());
    }
}
