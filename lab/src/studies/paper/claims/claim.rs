//! A claim of the paper, and what an ensemble says of it.

use serde::Serialize;

use super::influence::Influence;
use super::interval::clopper_pearson;
use super::member::Member;
use super::verdict::Verdict;
use crate::measure::quantile::{median, quantile};

/// Evidence of one member: the quantity that was looked at, if there is one, and whether the claim holds.
pub(super) type Evidence = (Option<f64>, bool);

/// A claim of the paper's section IV.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Claim {
    /// A stable identifier.
    pub id: &'static str,
    /// The paper's statement.
    pub paper: &'static str,
    /// The exact quantity that was looked at, and where the claim holds.
    pub reading: &'static str,
    /// The unit of that quantity.
    pub unit: &'static str,
    /// The controller that the paper prints.
    pub printed: Judged,
    /// Ours.
    pub ours: Judged,
}

/// A claim judged over an ensemble.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Judged {
    /// The verdict.
    pub verdict: Verdict,
    /// The number of members for which the claim holds.
    pub held: usize,
    /// The number of all members.
    pub of: usize,
    /// The interval of Clopper and Pearson for the share of members for which it holds, with 95 % confidence.
    pub interval: [f64; 2],
    /// The median of the quantity over the members that have one.
    pub median: Option<f64>,
    /// The range of the quantity without the lowest and the highest 5 %.
    pub range: Option<[f64; 2]>,
    /// The quantity in the single run at the paper's numbers.
    pub single: Option<f64>,
    /// What moves the claim, the strongest first.
    pub influences: Vec<Influence>,
}

impl Judged {
    /// The judgement of an ensemble from the evidence of each of its `members`, and that of the single run.
    pub(super) fn of(evidence: &[Evidence], members: &[Member], single: Evidence) -> Self {
        let holds: Vec<bool> = evidence.iter().map(|(_, holds)| *holds).collect();
        let numbers = || evidence.iter().filter_map(|(number, _)| *number);
        let held = holds.iter().filter(|holds| **holds).count();
        let interval = clopper_pearson(held, holds.len());
        let influences = Influence::all(&holds, members);
        Self {
            verdict: Verdict::of(interval, &influences),
            held,
            of: holds.len(),
            interval,
            median: median(numbers()),
            range: quantile(numbers(), 0.05).zip(quantile(numbers(), 0.95)).map(<[f64; 2]>::from),
            single: single.0,
            influences,
        }
    }

    /// The share of members for which the claim holds, and its interval, in percent.
    pub fn share(&self) -> String {
        let percent = |share: f64| format!("{:.1}", 100.0 * share);
        let [low, high] = self.interval.map(percent);
        let share = percent(self.held as f64 / self.of.max(1) as f64);
        format!("{share} ({low} to {high})").replace(".0", "")
    }
}
