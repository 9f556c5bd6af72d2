//! Drive of a member through the ticks that bytes spell.

use core::fmt::Debug;

use lyapunov_core::{Correction, ParameterError, Signal, Snapshot, Stabilizer};

use crate::check::{Manner, fault};
use crate::members::Driven;
use crate::tick::Tick;
use crate::{Bytes, Real};

/// Ticks of one run at most.
const MOST: usize = 400;

/// Ticks after a rejected one from which on a quiet sample is accepted.
const RECOVERY: usize = 2;

/// Drives a member; where its memory can be taken out, one in which it was put goes on alike.
pub(crate) fn stored<V, S>(
    bytes: &mut Bytes<'_>,
    manner: Manner<V::Scalar>,
    member: Result<S, ParameterError>,
) -> Driven
where
    V: Signal<Scalar: Real>,
    S: Stabilizer<V> + Snapshot + Copy,
{
    let member = member?;
    run(bytes, manner, member, |now: &S| member.restored(now.state()).ok())
}

/// Drives a member without a memory to take out; a copy goes on alike.
pub(crate) fn copied<V, S>(
    bytes: &mut Bytes<'_>,
    manner: Manner<V::Scalar>,
    member: Result<S, ParameterError>,
) -> Driven
where
    V: Signal<Scalar: Real>,
    S: Stabilizer<V> + Copy,
{
    run(bytes, manner, member?, |now: &S| Some(*now))
}

fn run<V, S>(
    bytes: &mut Bytes<'_>,
    manner: Manner<V::Scalar>,
    mut member: S,
    resumed: impl Fn(&S) -> Option<S>,
) -> Driven
where
    V: Signal<Scalar: Real>,
    S: Stabilizer<V> + Copy,
{
    let mut tick = Tick::quiet();
    let resume_at = usize::from(bytes.byte());
    let mut other: Option<S> = None;
    let mut believable = bytes.believable();
    for number in 0..MOST {
        if bytes.at_end() {
            return Ok(number);
        }
        if number == resume_at {
            other = resumed(&member);
        }
        tick = tick.after(bytes);
        let told = member.stabilize(&tick.sample, tick.asked);
        if let Some(fault) = fault(manner, &tick, &told) {
            panic!("{fault} at tick {number}: {tick:?}, {told:?}");
        }
        if let Some(other) = &mut other {
            let again = other.stabilize(&tick.sample, tick.asked);
            assert_eq!(bits(&told), bits(&again), "restored, at tick {number}: {tick:?}");
        }
        // Finite garbage blinds an account: docs/contract.md, and `Plausible`.
        believable &= tick.believable();
        let failed = !told.accepted || !told.effort.finite();
        if believable && failed && !matches!(manner, Manner::Passes | Manner::Answers) {
            recovers(manner, member, number, &tick);
        }
    }
    Ok(MOST)
}

/// What follows a rejected tick: at rest, the member accepts again.
fn recovers<V, S>(manner: Manner<V::Scalar>, mut member: S, number: usize, rejected: &Tick<V>)
where
    V: Signal<Scalar: Real>,
    S: Stabilizer<V>,
{
    let quiet = Tick::quiet();
    let mut told = Correction::default();
    for _ in 0..RECOVERY {
        told = member.stabilize(&quiet.sample, quiet.asked);
        if let Some(fault) = fault(manner, &quiet, &told) {
            panic!("{fault} at rest after tick {number}: {rejected:?}, {told:?}");
        }
    }
    let recovered = told.accepted && told.effort.finite();
    assert!(recovered, "rejects for good after tick {number}: {rejected:?}, {told:?}");
}

/// What is told, bit by bit.
fn bits<V: Signal<Scalar: Real>>(told: &Correction<V>) -> impl Debug + PartialEq {
    let mut bits = Vec::new();
    told.effort.map(|axis| {
        bits.push(axis.bits());
        axis
    });
    bits.extend([told.observed_energy, told.alpha, told.shortfall].map(Real::bits));
    (bits, told.accepted)
}
