//! Runs of one setting over an ensemble.

use super::cost::Cost;
use crate::studies::chance::student;

/// The costs of the runs of one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// The cost of each run; none of a run that grows or cannot be judged.
    costs: Vec<Option<Cost>>,
}

impl Trial {
    pub(super) fn of(costs: Vec<Option<Cost>>) -> Self {
        Self { costs }
    }

    /// The trial of numbers that do not go together.
    pub(super) fn refused(runs: u32) -> Self {
        Self { costs: vec![None; runs as usize] }
    }

    /// The number of runs.
    pub fn runs(&self) -> usize {
        self.costs.len()
    }

    /// The number of runs that stayed bounded.
    pub fn bounded(&self) -> usize {
        self.costs.iter().flatten().count()
    }

    /// The number of runs that settled.
    pub fn settled(&self) -> usize {
        self.costs.iter().flatten().filter(|cost| cost.settles).count()
    }

    /// The mean cost of the bounded runs; none if there is none.
    pub fn cost(&self) -> Option<f64> {
        mean(&self.costs.iter().flatten().map(|cost| cost.value).collect::<Vec<_>>())
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
        let pairs = self.costs.iter().zip(&other.costs);
        let changes: Vec<f64> =
            pairs.filter_map(|(own, its)| Some((*own)?.value - (*its)?.value)).collect();
        let (count, middle) = (changes.len() as f64, mean(&changes)?);
        let spread = changes.iter().map(|change| (change - middle).powi(2)).sum::<f64>();
        let error = (spread / (count - 1.0) / count).sqrt();
        error.is_finite().then(|| (middle, student(count - 1.0) * error))
    }

    /// The runs that are bounded in this and not in `other`.
    pub(super) fn bounded_only_here(&self, other: &Self) -> usize {
        let pairs = self.costs.iter().zip(&other.costs);
        pairs.filter(|(own, its)| own.is_some() && its.is_none()).count()
    }
}

fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// A trial of runs at these costs; one of none grows, and one of 5 or more does not settle.
    fn trial(costs: &[Option<f64>]) -> Trial {
        let cost = |value: f64| Cost { value, settles: value < 5.0 };
        Trial::of(costs.iter().map(|value| value.map(cost)).collect())
    }

    #[test]
    fn bounded_runs_count_before_their_cost() {
        let cheap = trial(&[Some(0.1), None]);
        let safe = trial(&[Some(5.0), Some(6.0)]);
        let safer = trial(&[Some(5.0), Some(5.0)]);
        assert!(safe.is_better_than(&cheap) && !cheap.is_better_than(&safe));
        assert!(safer.is_better_than(&safe) && !safe.is_better_than(&safe));
        assert!(cheap.is_better_than(&Trial::refused(2)));
        assert_eq!((cheap.bounded(), cheap.settled(), cheap.cost()), (1, 1, Some(0.1)));
        assert_eq!((safe.bounded(), safe.settled()), (2, 0));
    }

    #[test]
    fn a_change_is_taken_run_by_run_with_its_interval() {
        // Changes of -1, -2 and -3: mean -2, standard error 1 / sqrt 3.
        let before = trial(&[Some(10.0), Some(20.0), Some(30.0), None]);
        let after = trial(&[Some(9.0), Some(18.0), Some(27.0), Some(1.0)]);
        let (change, half) = after.change_from(&before).unwrap();
        assert_abs_diff_eq!(change, -2.0, epsilon = 1e-12);
        // Student's factor for two degrees of freedom.
        assert_abs_diff_eq!(half, 4.302653 / 3.0_f64.sqrt(), epsilon = 1e-6);
        assert_eq!(trial(&[Some(1.0)]).change_from(&trial(&[Some(2.0)])), None);
    }
}
