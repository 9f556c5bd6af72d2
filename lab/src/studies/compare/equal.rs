//! Entrants whose runs are equal.

use super::column::Column;
use super::comparison::Outcome;
use super::score::Score;
use crate::text::shortened_names;

/// Entrants whose runs are equal in every number that is shown and in every curve, in the order of the table: the first
/// stands for all.
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

    /// All names, each with the median of what its step costs, which is not equal: in ns: `popc (2.40) = lolc-spring (3.10)`.
    pub(super) fn names(&self) -> String {
        let names = self.scores().map(|score| match score.step_time {
            Some(time) => format!("{} ({:.2})", score.stabilizer, time.median),
            None => score.stabilizer.clone(),
        });
        names.collect::<Vec<_>>().join(" = ")
    }

    /// All names for a narrow place.
    pub(super) fn short_name(&self, room: usize) -> String {
        let names: Vec<&str> = self.scores().map(|score| &score.stabilizer[..]).collect();
        shortened_names(&names, room)
    }
}

/// Points of a curve.
pub(super) type Points = Vec<(f64, f64)>;

/// The curves of an outcome.
pub(super) const CURVES: [fn(&Outcome) -> &Points; 3] =
    [|it| &it.curves.position, |it| &it.curves.observed_energy, |it| &it.curves.force];

/// Curves that differ by less than this share of their range are drawn on the same pixels.
const THIN: f64 = 1e-3;

/// Whether two curves cannot be told apart.
pub(super) fn is_same(one: &Points, other: &Points) -> bool {
    let values = || one.iter().chain(other).map(|point| point.1);
    let high = values().fold(f64::NEG_INFINITY, f64::max);
    let low = values().fold(f64::INFINITY, f64::min);
    let near = |(a, b): (&(f64, f64), &(f64, f64))| {
        a == b || a.0 == b.0 && (a.1 - b.1).abs() <= THIN * (high - low)
    };
    one.len() == other.len() && one.iter().zip(other).all(near)
}

/// Whether two runs are equal, but for the cost of their steps.
fn is_equal(one: &Outcome, other: &Outcome) -> bool {
    let behaves = |column: &Column| {
        !matches!(column, Column::Stabilizer | Column::StepTime | Column::StateBytes)
    };
    let told = |column: Column| column.cell(&one.score).text() == column.cell(&other.score).text();
    Column::ALL.into_iter().filter(behaves).all(told)
        && CURVES.iter().all(|curve| is_same(curve(one), curve(other)))
}
