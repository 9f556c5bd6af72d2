//! The laws of a stabilizer's account.

use crate::laws::{Law, Tick, Violation};
use crate::{
    Accumulator, Compensated, LyapunovCandidate, PortSample, Requirement, Scalar, Signal,
    Stabilizer,
};

/// Checks that `stabilizer` keeps the laws [`WithinLimit`](Law::WithinLimit) and [`Balances`](Law::Balances) over
/// `samples`, if it books held work under `candidate` and injects at most `limit` N·s/m.
///
/// What `candidate` says of the drives is summed beside the stabilizer, with its rounding errors. At the end of every
/// tick `supplied = stored − dissipated − shortfall`: that sum is the store (the sum told, where it is above 0), or it
/// is the debt, which is what `α v² T` is to burn and what is left over. Allowed are
/// `4 u (Σ |−ΔV| + ticks · largest stored)`, with `u` half the distance from one to the next number, and what
/// numbers below the normal ones round.
///
/// # Errors
/// The first law that is broken.
pub fn ledger<V: Signal, S: Stabilizer<V> + Clone, C: LyapunovCandidate<V> + Clone>(
    stabilizer: &S,
    candidate: &C,
    limit: V::Scalar,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let (mut stabilizer, mut candidate) = (stabilizer.clone(), candidate.clone());
    let zero = V::Scalar::of(0.0);
    let mut supplied = Compensated::<V::Scalar>::zero();
    let (mut absolute, mut largest, mut ticks) = (zero, zero, zero);
    // A limit that is not one is told as a breach of it on the first tick.
    let limit = Requirement::Limit.check("limit", limit).unwrap_or(zero);
    for (tick, (sample, effort)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let decrease = candidate.decrease(&sample);
        let correction = stabilizer.stabilize(&sample, effort);
        let most = sample.velocity.map(|v| v.magnitude() * limit);
        let added = (correction.effort - effort).map(Scalar::magnitude);
        let size = correction.effort.map(Scalar::magnitude) + effort.map(Scalar::magnitude);
        now.not_below_zero(Law::WithinLimit, (most - added).sum(), size.sum())?;

        supplied.add(decrease);
        let sum = supplied.value();
        absolute += decrease.magnitude();
        largest = largest.larger(sum.magnitude());
        ticks += V::Scalar::of(1.0);
        let burnt = correction.alpha * (sample.velocity.inner(sample.velocity) * sample.period);
        let stored = correction.observed_energy.larger(zero);
        let error = (sum - (stored - burnt - correction.shortfall)).magnitude();
        let unit = V::Scalar::epsilon() * V::Scalar::of(0.5);
        let allowed = V::Scalar::of(4.0) * unit * (absolute + ticks * largest)
            + ticks * V::Scalar::of(4.0) * V::Scalar::smallest_normal();
        now.require(Law::Balances, !allowed.below(error), error)?;
    }
    Ok(())
}
