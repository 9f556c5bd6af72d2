//! Properties of a step that are asked of the solvers.

use lyapunov_core::{Mask, Requirement, Scalar, Signal};

use crate::fresh::{equal, meets};
use crate::gappa;
use crate::seen::Seen;
use crate::symbolic::{Symbolic, Truth};

/// Property: its name, what must hold on each path, and which numbers may be taken as free.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Property {
    pub(crate) name: &'static str,
    pub(crate) goal: fn(&Seen) -> Truth,
    pub(crate) cuts: fn(&Seen) -> Vec<Symbolic>,
    /// Of what adds damping, of what only reduces forces, or of all.
    pub(crate) of: Kind,
}

/// What a member does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Adds `α v`, with `α` from the observed energy as `Lolc` computes it.
    Serves,
    /// Adds `α v`.
    Damps,
    /// Adds damping in another shape, so that the force is not `α v` axis by axis.
    Shapes,
    /// Lets through a share of each axis' force.
    Reduces,
    /// Anything else.
    Any,
}

fn implies(a: Truth, b: Truth) -> Truth {
    !a | b
}

fn all(truths: impl IntoIterator<Item = Truth>) -> Truth {
    truths.into_iter().fold(Truth::of(true), |all, it| all & it)
}

fn zero() -> Symbolic {
    Symbolic::of(0.0)
}

fn whole(_seen: &Seen) -> Vec<Symbolic> {
    vec![]
}

/// The sum and `v² T` are free: whatever led to them, and on however many axes.
fn from_sum_and_square(seen: &Seen) -> Vec<Symbolic> {
    vec![seen.sum, seen.square]
}

fn at_alpha(seen: &Seen) -> Vec<Symbolic> {
    vec![seen.alpha]
}

pub(crate) const PROPERTIES: &[Property] = &[
    Property { name: "finite", goal: finite, cuts: whole, of: Kind::Any },
    Property { name: "rejected", goal: rejected, cuts: whole, of: Kind::Any },
    Property { name: "untimed", goal: untimed, cuts: whole, of: Kind::Any },
    Property { name: "memory", goal: |seen| seen.memory, cuts: whole, of: Kind::Any },
    Property { name: "limit", goal: limit, cuts: from_sum_and_square, of: Kind::Shapes },
    Property { name: "opposes", goal: opposes, cuts: whole, of: Kind::Shapes },
    Property { name: "within", goal: within, cuts: at_alpha, of: Kind::Damps },
    Property { name: "told", goal: told, cuts: from_sum_and_square, of: Kind::Shapes },
    Property { name: "line", goal: line, cuts: from_sum_and_square, of: Kind::Serves },
    Property {
        name: "served-least",
        goal: served_least,
        cuts: from_sum_and_square,
        of: Kind::Serves,
    },
    Property { name: "reduces", goal: reduces, cuts: whole, of: Kind::Reduces },
];

/// What is reported is finite, and so is the force.
fn finite(seen: &Seen) -> Truth {
    let numbers = [seen.sum, seen.alpha, seen.shortfall];
    let short = meets(Requirement::NonNegative, seen.shortfall);
    all(seen.effort.iter().chain(&numbers).map(|it| it.finite())) & short
}

/// A rejected sample gets no force and no damping.
fn rejected(seen: &Seen) -> Truth {
    let nothing = all(seen.effort.iter().map(|axis| equal(*axis, zero())));
    seen.accepted | (nothing & equal(seen.alpha, zero()))
}

/// A period that is not above 0 and finite is rejected.
fn untimed(seen: &Seen) -> Truth {
    implies(seen.accepted, seen.period.above(zero()) & seen.period.finite())
}

/// `0 ≤ α ≤ limit`.
fn limit(seen: &Seen) -> Truth {
    let most = seen.limit.unwrap_or(zero());
    seen.alpha.finite() & !seen.alpha.below(zero()) & !seen.alpha.above(most)
}

/// On each axis the force that is added does not point along the motion.
fn opposes(seen: &Seen) -> Truth {
    let axes = seen.velocity.iter().zip(seen.asked.iter().zip(&seen.effort));
    let each = axes.map(|(velocity, (asked, effort))| {
        (velocity.below(zero()) | !effort.below(*asked))
            & (velocity.above(zero()) | !effort.above(*asked))
    });
    implies(seen.accepted, all(each))
}

/// The force added is `α v`, and that is no more than `limit |v|`, in computed numbers.
///
/// `α` is free, within what `limit` shows of it.
fn within(seen: &Seen) -> Truth {
    let most = seen.limit.unwrap_or(zero());
    let axes = seen.velocity.iter().zip(seen.asked.iter().zip(&seen.effort));
    let each = axes.map(|(velocity, (asked, effort))| {
        let added = *velocity * seen.alpha;
        let small = !added.magnitude().above((*velocity * most).magnitude());
        equal(*effort, *asked + added) & small
    });
    implies(seen.accepted & limit(seen), all(each))
}

/// Served energy plus shortfall is not below 0, in the numbers of a reader.
fn told(seen: &Seen) -> Truth {
    // The period of what is accepted is above 0, so the reader's product is the step's.
    let served = seen.sum + seen.alpha * seen.square;
    implies(seen.accepted, !(served + seen.shortfall).below(zero()))
}

/// On each axis what is given lies between 0 and what is asked.
fn reduces(seen: &Seen) -> Truth {
    let each = seen.asked.iter().zip(&seen.effort).map(|(asked, effort)| {
        let (low, high) = (asked.smaller(zero()), asked.larger(zero()));
        !effort.below(low) & !effort.above(high)
    });
    implies(seen.accepted, all(each))
}

/// A debt that `α` serves below its limit, where it is a normal number.
fn below_the_limit(seen: &Seen) -> Truth {
    let tiny = Symbolic::smallest_normal();
    let owed = seen.accepted & seen.sum.below(zero()) & seen.square.above(tiny);
    owed & seen.alpha.below(seen.limit.unwrap_or(zero())) & !seen.alpha.below(tiny)
}

/// Below the limit `α` is the product that the Gappa scripts are about.
fn line(seen: &Seen) -> Truth {
    let (normal, branches) = gappa::branches(seen);
    implies(below_the_limit(seen) & normal, all(branches))
}

/// Below the limit nothing stays unserved where `v² T` is so little above the least that the divisor is set to that.
fn served_least(seen: &Seen) -> Truth {
    let (normal, _) = gappa::branches(seen);
    let burnt = seen.alpha * seen.square;
    implies(below_the_limit(seen) & !normal, !(seen.sum + burnt).below(zero()))
}
