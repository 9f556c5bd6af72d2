//! Runs of one setting over an ensemble.

use crate::studies::chance::student;

/// Outcome of a run of a setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome {
    /// It comes to rest, at this cost.
    Settles(f64),
    /// It stays bounded and does not come to rest, at this cost.
    Swinging(f64),
    /// It grows, or its setting is none.
    Grows,
    /// It is too short to judge.
    TooShort,
}

impl Outcome {
    /// The cost of a bounded run.
    fn cost(self) -> Option<f64> {
        match self {
            Self::Settles(cost) | Self::Swinging(cost) => Some(cost),
            Self::Grows | Self::TooShort => None,
        }
    }
}

/// The costs of the runs of one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    outcomes: Vec<Outcome>,
}

impl Trial {
    pub(super) fn of(outcomes: Vec<Outcome>) -> Self {
        Self { outcomes }
    }

    /// The trial of numbers that do not go together.
    pub(super) fn refused(runs: usize) -> Self {
        Self { outcomes: vec![Outcome::Grows; runs] }
    }

    /// The number of runs.
    pub fn runs(&self) -> usize {
        self.outcomes.len()
    }

    /// The number of runs that stayed bounded.
    pub fn bounded(&self) -> usize {
        self.costs().flatten().count()
    }

    /// The number of runs that settle.
    pub fn settle(&self) -> usize {
        self.outcomes.iter().filter(|it| matches!(it, Outcome::Settles(_))).count()
    }

    /// The number of runs that are too short to judge.
    pub fn too_short(&self) -> usize {
        self.outcomes.iter().filter(|it| matches!(it, Outcome::TooShort)).count()
    }

    /// The mean cost of the bounded runs; none if there is none.
    pub fn cost(&self) -> Option<f64> {
        mean(&self.costs().flatten().collect::<Vec<_>>())
    }

    fn costs(&self) -> impl Iterator<Item = Option<f64>> {
        self.outcomes.iter().map(|outcome| outcome.cost())
    }

    /// Whether more runs are bounded, or as many at less cost.
    pub(super) fn is_better_than(&self, other: &Self) -> bool {
        let cost = |trial: &Self| trial.cost().unwrap_or(f64::INFINITY);
        let more = self.bounded().cmp(&other.bounded());
        more.is_gt() || more.is_eq() && cost(self) < cost(other)
    }

    /// The mean change of the cost from `other` to this, run by run, with half the width of its 95 % interval; none
    /// with fewer than two runs that are bounded in both.
    pub fn change_from(&self, other: &Self) -> Option<(f64, f64)> {
        let pairs = self.costs().zip(other.costs());
        let changes: Vec<f64> = pairs.filter_map(|(own, its)| Some(own? - its?)).collect();
        let (count, middle) = (changes.len() as f64, mean(&changes)?);
        let spread = changes.iter().map(|change| (change - middle).powi(2)).sum::<f64>();
        let error = (spread / (count - 1.0) / count).sqrt();
        error.is_finite().then(|| (middle, student(count - 1.0) * error))
    }

    /// The runs that are bounded in this and not in `other`.
    pub(super) fn bounded_only_here(&self, other: &Self) -> usize {
        let pairs = self.costs().zip(other.costs());
        pairs.filter(|(own, its)| own.is_some() && its.is_none()).count()
    }
}

fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::Outcome::{Grows, Settles, Swinging, TooShort};
    use super::*;

    #[test]
    fn bounded_runs_count_before_their_cost() {
        let cheap = Trial::of(vec![Settles(0.1), Grows]);
        let safe = Trial::of(vec![Settles(5.0), Swinging(6.0)]);
        let safer = Trial::of(vec![Swinging(5.0), Swinging(5.0)]);
        assert!(safe.is_better_than(&cheap) && !cheap.is_better_than(&safe));
        assert!(safer.is_better_than(&safe) && !safe.is_better_than(&safe));
        assert!(cheap.is_better_than(&Trial::refused(2)));
        assert_eq!((cheap.bounded(), cheap.cost()), (1, Some(0.1)));
        assert_eq!((cheap.settle(), safe.settle(), safer.settle()), (1, 1, 0));
    }

    #[test]
    fn a_run_that_is_too_short_neither_stays_bounded_nor_grows() {
        let short = Trial::of(vec![Settles(1.0), TooShort, Grows, TooShort]);
        assert_eq!((short.runs(), short.bounded(), short.too_short()), (4, 1, 2));
        assert_eq!(short.cost(), Some(1.0));
    }

    #[test]
    fn a_change_is_taken_run_by_run_with_its_interval() {
        // Changes of -1, -2 and -3: mean -2, standard error 1 / sqrt 3.
        let before = Trial::of(vec![Settles(10.0), Swinging(20.0), Settles(30.0), Grows]);
        let after = Trial::of(vec![Settles(9.0), Settles(18.0), Settles(27.0), Settles(1.0)]);
        let (change, half) = after.change_from(&before).unwrap();
        assert_abs_diff_eq!(change, -2.0, epsilon = 1e-12);
        // Student's factor for two degrees of freedom.
        assert_abs_diff_eq!(half, 4.302653 / 3.0_f64.sqrt(), epsilon = 1e-6);
        let one = |cost: f64| Trial::of(vec![Settles(cost)]);
        assert_eq!(one(1.0).change_from(&one(2.0)), None);
    }
}
