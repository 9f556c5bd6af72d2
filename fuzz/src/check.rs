//! What must hold of every correction, whatever led to it.

use lyapunov_core::{Correction, Scalar, Signal};

use crate::Real;
use crate::tick::Tick;

/// What a member does, and so what it promises; as in proofs/src/properties.rs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Manner<T> {
    /// Adds `α v`, with `α` up to the limit.
    Damps(T),
    /// Adds damping in another shape, with `α` up to the limit.
    Shapes(T),
    /// Lets through a share of each axis' force.
    Reduces,
    /// Rejects with a force of 0, and no more is promised.
    Rejects,
    /// Gives a force where a sample is rejected: one that is held, or that of another axis.
    Holds,
    /// Answers by itself: its force is finite.
    Answers,
    /// Answers by itself, and what is no sample by what is no force; it recovers.
    Asks,
    /// Passes on what is asked.
    Passes,
}

/// What is wrong with a correction, or nothing.
pub(crate) fn fault<V: Signal<Scalar: Real>>(
    manner: Manner<V::Scalar>,
    tick: &Tick<V>,
    told: &Correction<V>,
) -> Option<&'static str> {
    let zero = V::Scalar::of(0.0);
    let finite = told.effort.finite();
    match manner {
        Manner::Passes | Manner::Asks => return None,
        Manner::Answers if finite => return None,
        _ if !finite => return Some("the force is not finite"),
        _ => {}
    }
    let numbers = [told.observed_energy, told.alpha, told.shortfall];
    let least = told.alpha >= zero && told.shortfall >= zero;
    let forceless = told.effort.inner(told.effort) == zero && told.alpha == zero;
    let checks = [
        (!numbers.iter().all(|it| it.finite()), "a number is not finite"),
        (!least, "damping or shortfall below 0"),
        (told.accepted && !tick.sample.timed(), "accepted over a period that is none"),
        (!told.accepted && manner != Manner::Holds && !forceless, "rejected with a force"),
    ];
    let broken = checks.iter().find(|(broken, _)| *broken).map(|(_, name)| *name);
    broken.or_else(|| if told.accepted { of_manner(manner, tick, told) } else { None })
}

fn of_manner<V: Signal<Scalar: Real>>(
    manner: Manner<V::Scalar>,
    tick: &Tick<V>,
    told: &Correction<V>,
) -> Option<&'static str> {
    match manner {
        Manner::Damps(limit) => within(limit, tick, told)
            .or_else(|| opposes(tick, told))
            .or_else(|| served(limit, tick, told)),
        Manner::Shapes(limit) => opposes(tick, told).or_else(|| served(limit, tick, told)),
        Manner::Reduces => every(tick, told, |asked, _, given| {
            let zero = V::Scalar::of(0.0);
            given >= asked.smaller(zero) && given <= asked.larger(zero)
        })
        .then_some("a force beyond what is asked"),
        _ => None,
    }
}

/// Whether `holds` fails for some axis' asked effort, velocity and given effort.
fn every<V: Signal<Scalar: Real>>(
    tick: &Tick<V>,
    told: &Correction<V>,
    mut holds: impl FnMut(V::Scalar, V::Scalar, V::Scalar) -> bool,
) -> bool {
    let mut broken = false;
    let mut velocities = Vec::new();
    tick.sample.velocity.map(|axis| {
        velocities.push(axis);
        axis
    });
    let mut velocities = velocities.into_iter();
    tick.asked.zip(told.effort, |asked, given| {
        broken |= !velocities.next().is_some_and(|velocity| holds(asked, velocity, given));
        given
    });
    broken
}

/// The force added is `α v`, and that is no more than the limit times the speed, in computed numbers.
fn within<V: Signal<Scalar: Real>>(
    limit: V::Scalar,
    tick: &Tick<V>,
    told: &Correction<V>,
) -> Option<&'static str> {
    every(tick, told, |asked, velocity, given| {
        let added = velocity * told.alpha;
        given == asked + added && added.magnitude() <= (velocity * limit).magnitude()
    })
    .then_some("a force that is not the damping's, or beyond the limit")
}

/// On no axis the force added points along the motion.
fn opposes<V: Signal<Scalar: Real>>(tick: &Tick<V>, told: &Correction<V>) -> Option<&'static str> {
    let zero = V::Scalar::of(0.0);
    every(tick, told, |asked, velocity, given| {
        (velocity < zero || given >= asked) && (velocity > zero || given <= asked)
    })
    .then_some("a correction along the motion")
}

/// Served energy plus shortfall is not below 0, and the damping not above its limit.
fn served<V: Signal<Scalar: Real>>(
    limit: V::Scalar,
    tick: &Tick<V>,
    told: &Correction<V>,
) -> Option<&'static str> {
    let velocity = tick.sample.velocity;
    let square = velocity.inner(velocity) * tick.sample.period;
    let served = told.observed_energy + told.alpha * square;
    if told.alpha > limit {
        return Some("damping beyond its limit");
    }
    (served + told.shortfall < V::Scalar::of(0.0)).then_some("a debt that is not told")
}
