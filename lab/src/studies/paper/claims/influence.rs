//! Influence of what the paper does not state on whether a claim holds.

use serde::Serialize;

use super::member::{Member, Unstated};

/// Least main effect of a constant that a verdict names.
const LEAST: f64 = 0.05;

/// Distance of such an effect from chance, as a deviate of the standard normal distribution: 3e-5, for some hundred claims and
/// constants.
const DEVIATE: f64 = 4.0;

/// A constant that moves a claim, and how.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Influence {
    /// The constant.
    pub constant: &'static str,
    /// Its main effect: the share of the variance between members that its groups explain, corrected for the effect
    /// that chance gives to that many groups.
    pub effect: f64,
    /// The members by the constant's value.
    pub groups: Vec<Group>,
}

/// Members that are alike in a constant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Group {
    /// The values of the constant.
    pub values: String,
    /// The number of these members for which the claim holds.
    pub held: usize,
    /// The number of these members.
    pub of: usize,
}

impl Group {
    /// The share of these members for which the claim holds, in percent; a dash where there are none.
    pub(in super::super) fn percent(&self) -> String {
        match self.of {
            0 => "-".to_owned(),
            of => format!("{:.0}", 100.0 * self.held as f64 / of as f64),
        }
    }
}

impl Influence {
    /// The shares of all groups, in percent.
    pub(in super::super) fn shares(&self) -> String {
        self.groups.iter().map(Group::percent).collect::<Vec<_>>().join(" ")
    }

    /// The constants that move a claim, the strongest first; `holds` says for each member whether the claim holds.
    pub(super) fn all(holds: &[bool], members: &[Member]) -> Vec<Self> {
        let mut all: Vec<Self> =
            Unstated::ALL.iter().map(|unstated| Self::of(*unstated, holds, members)).collect();
        all.retain(|it| it.effect >= LEAST.max(chance(&it.groups)));
        all.sort_by(|one, other| other.effect.total_cmp(&one.effect));
        all
    }

    fn of(unstated: Unstated, holds: &[bool], members: &[Member]) -> Self {
        let mut groups: Vec<Group> =
            unstated.groups().into_iter().map(|values| Group { values, held: 0, of: 0 }).collect();
        for (holds, member) in holds.iter().zip(members) {
            let group = &mut groups[member.group(unstated)];
            group.of += 1;
            group.held += usize::from(*holds);
        }
        Self { constant: unstated.name(), effect: effect(&groups), groups }
    }
}

/// The correlation ratio of an outcome of 0 or 1 with its groups, corrected for their number: ε² (T. L. Kelley, An
/// unbiased correlation ratio measure, *PNAS* 21(9), 1935). For a constant drawn by itself it estimates the first-order
/// sensitivity index of Sobol; 0 where every member is alike.
fn effect(groups: &[Group]) -> f64 {
    let filled = || groups.iter().filter(|group| group.of > 0);
    let (held, of) = filled().fold((0, 0), |sum, it| (sum.0 + it.held, sum.1 + it.of));
    let share = held as f64 / of as f64;
    let total = of as f64 * share * (1.0 - share);
    let within: f64 =
        filled().map(|it| it.held as f64 * (1.0 - it.held as f64 / it.of as f64)).sum();
    if total > 0.0 { corrected(within / total, groups).unwrap_or(0.0) } else { 0.0 }
}

/// ε² from the share of the variance that is within `groups`; none where each member is a group.
fn corrected(within: f64, groups: &[Group]) -> Option<f64> {
    let of = groups.iter().map(|group| group.of).sum::<usize>() as f64;
    let freedom = of - groups.iter().filter(|group| group.of > 0).count() as f64;
    (freedom > 0.0).then(|| 1.0 - within * (of - 1.0) / freedom)
}

/// The largest effect that chance gives such groups but for one case in many: Pearson's χ² of holding or not by group is the number
/// of members times the share of the variance between the groups, and its quantile is that of Wilson and Hilferty (The
/// distribution of chi-square, *PNAS* 17(12), 1931).
fn chance(groups: &[Group]) -> f64 {
    let of = groups.iter().map(|group| group.of).sum::<usize>() as f64;
    let freedom = groups.iter().filter(|group| group.of > 0).count().saturating_sub(1) as f64;
    let spread = 2.0 / (9.0 * freedom);
    let quantile = freedom * (1.0 - spread + DEVIATE * spread.sqrt()).powi(3);
    corrected(1.0 - quantile / of, groups).unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn groups(counts: &[(usize, usize)]) -> Vec<Group> {
        let group = |&(held, of)| Group { values: String::new(), held, of };
        counts.iter().map(group).collect()
    }

    /// Two groups: the one-way analysis of variance by hand.
    #[test]
    fn the_effect_is_the_share_of_variance_between_groups() {
        assert_eq!(effect(&groups(&[(50, 50), (0, 50)])), 1.0);
        // 40 and 10 of 50: total 100 · 0.5 · 0.5, within 2 · 50 · 0.8 · 0.2, with 99 and 98 degrees of freedom.
        let expected = 1.0 - (16.0 / 25.0) * 99.0 / 98.0;
        assert_abs_diff_eq!(effect(&groups(&[(40, 50), (10, 50)])), expected, epsilon = 1e-12);
        assert!(effect(&groups(&[(25, 50), (25, 50)])) < 0.0);
        for alike in [&[(0, 9), (0, 9)][..], &[(9, 9), (9, 9)], &[(1, 2)], &[(0, 0)], &[]] {
            assert!(effect(&groups(alike)) <= 0.0);
        }
    }

    /// χ² of 7 degrees of freedom is above 32.58 as often as a normal deviate is above 4, once in 31 574 cases.
    #[test]
    fn chance_gives_few_members_large_effects() {
        let eighths = |of| groups(&[(0, of); 8]);
        let expected = |of: f64| 1.0 - (1.0 - 32.58 / of) * (of - 1.0) / (of - 8.0);
        for of in [5, 125] {
            let all = 8.0 * of as f64;
            assert_abs_diff_eq!(chance(&eighths(of)), expected(all), epsilon = 1.0 / all);
        }
        assert!(chance(&eighths(125)) < LEAST);
        assert_eq!(chance(&groups(&[(0, 1), (1, 1)])), f64::INFINITY);
    }

    fn named(holds: impl Fn(&Member) -> bool) -> Vec<&'static str> {
        let members = Member::draw(1, 400).unwrap();
        let holds: Vec<bool> = members.iter().map(holds).collect();
        Influence::all(&holds, &members).iter().map(|influence| influence.constant).collect()
    }

    #[test]
    fn a_claim_is_moved_by_the_constants_that_decide_it() {
        let rate = |member: &Member| member.group(Unstated::ObserverRate);
        let phase = |member: &Member| member.group(Unstated::ContactPhase);
        assert_eq!(named(|member| rate(member) == 0), ["the observer's rate"]);
        assert_eq!(named(|member| member.rate() < 150.0), ["the observer's rate"]);
        assert_eq!(named(|member| member.contact_phase() < 0.25), ["the clock's phase"]);
        let both = named(|member| rate(member) == 0 || phase(member) < 1);
        assert_eq!(both, ["the observer's rate", "the clock's phase"]);
        assert!(named(|_| true).is_empty() && named(|_| false).is_empty());
        // Two constants that say nothing each by itself.
        let odd = |member: &Member| member.group(Unstated::Cap) + member.group(Unstated::Start);
        assert!(named(|member| odd(member) % 2 == 0).is_empty());
    }
}
