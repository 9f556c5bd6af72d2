//! Goal of the changes that an explanation tries.

use super::{Explanation, hint};
use crate::measure::{Verdict, Yardstick};
use crate::simulate::Criterion;

/// Condition that a run meets after a change that helps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Goal {
    /// It does not grow.
    Bounded,
    /// It settles: the run is bounded as it is, by a force limit or by a wall that throws the plant off.
    Settled,
}

impl Goal {
    pub(super) fn is_reached(self, verdict: Verdict) -> bool {
        match self {
            Self::Bounded => verdict.is_bounded(),
            Self::Settled => verdict == Verdict::Settles,
        }
    }

    /// The goal that all listed changes reached, in words.
    pub(super) const fn words(self) -> &'static str {
        match self {
            Self::Bounded => "none grows",
            Self::Settled => "all settle",
        }
    }
}

impl Explanation {
    /// The goal of the changes that are tried; none where the run needs none or says nothing about the loop, or no force acts.
    pub(super) fn goal(&self) -> Option<Goal> {
        let is_unstable = self.limits.spectral_radius.is_some_and(|radius| radius > 1.0);
        // A plant that the hand or the environment moves has no place to settle at.
        let can_settle = self.verdict_by == Yardstick::Distance;
        match self.verdict {
            _ if self.peak_force == 0.0 || self.is_undisturbed || self.is_transient() => None,
            Verdict::TooShort => None,
            Verdict::Grows => Some(Goal::Bounded),
            Verdict::Swinging if is_unstable && can_settle => Some(Goal::Settled),
            _ if is_unstable && self.scene.stabilizer.is_none() => Some(Goal::Bounded),
            _ => None,
        }
    }

    /// The reason why there are no remedies; none where there are some.
    pub(super) fn lack(&self) -> Option<String> {
        Some(match self.goal() {
            Some(_) if !self.remedies.is_empty() => return None,
            Some(_) if Criterion::of(&self.scene).shortage.is_some() => {
                "runs of this length are too short to judge what helps: give it a longer duration"
                    .to_owned()
            }
            Some(_) => "nothing that was tried helps".to_owned(),
            None if self.peak_force == 0.0 => {
                format!("{}, so no change of the loop was tried", self.idle())
            }
            None if self.is_undisturbed => hint::undisturbed(&self.scene),
            None if self.is_transient() => hint::TRANSIENT.to_owned(),
            None if self.verdict == Verdict::TooShort => {
                "the run is too short to judge: give it a longer duration".to_owned()
            }
            None => "the run does not grow, so no change of the loop was tried".to_owned(),
        })
    }

    /// Whether the run grows for a while in a loop that is linear and stable.
    pub(super) fn is_transient(&self) -> bool {
        self.verdict == Verdict::Grows && !self.left_range && hint::is_transient(&self.scene)
    }
}
