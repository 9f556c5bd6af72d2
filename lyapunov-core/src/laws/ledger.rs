//! The laws of a stabilizer's ledger.

use crate::laws::{Law, Tick, Violation, quantity};
use crate::{
    Accumulator, Compensated, LyapunovCandidate, PortSample, Requirement, Scalar, Signal,
    Stabilizer,
};

/// Check of a `stabilizer` that books held work under `candidate` and injects at most `limit` N·s/m: the laws
/// [`Finite`](Law::Finite) of the effort, [`WithinLimit`](Law::WithinLimit), [`Injects`](Law::Injects) and
/// [`Balances`](Law::Balances) over `samples`.
///
/// The check sums the decreases of `candidate` beside the stabilizer, with compensation of rounding errors. At the end
/// of every tick `supplied = stored − dissipated − shortfall`: that sum is the stored credit (the observed energy
/// reported, where it is above 0), or it is the debt, of which `α v² T` is to dissipate a part and the shortfall is the
/// rest. Allowed are `4 u (Σ |−ΔV| + ticks · largest stored)`, with `u` half the distance from one to the next number,
/// and the rounding of subnormal numbers.
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
    // A limit that is not valid shows as a breach of it on the first tick that damps.
    let limit = Requirement::Limit.check("limit", limit).unwrap_or(zero);
    Tick::each(samples, |now, sample, effort| {
        let decrease = candidate.decrease(sample);
        let correction = stabilizer.stabilize(sample, effort);
        now.told(quantity::EFFORT).finite(Law::Finite, correction.effort)?;
        let most = sample.velocity.map(|v| v.magnitude() * limit);
        let added = (correction.effort - effort).map(Scalar::magnitude);
        let size = correction.effort.map(Scalar::magnitude) + effort.map(Scalar::magnitude);
        now.told(quantity::ROOM_IN_LIMIT).not_below_zero(
            Law::WithinLimit,
            (most - added).sum(),
            size.sum(),
        )?;

        let told = correction.alpha * sample.velocity.inner(sample.velocity);
        let taken = (correction.effort - effort).inner(sample.velocity);
        now.told(quantity::POWER_NOT_TOLD).not_below_zero(
            Law::Injects,
            taken - told,
            size.inner(sample.velocity.map(Scalar::magnitude)),
        )?;

        supplied.add(decrease);
        let sum = supplied.value();
        absolute += decrease.magnitude();
        largest = largest.larger(sum.magnitude());
        ticks += V::Scalar::of(1.0);
        let burnt = told * sample.period;
        let stored = correction.observed_energy.larger(zero);
        let error = sum - (stored - burnt - correction.shortfall);
        let unit = V::Scalar::epsilon() * V::Scalar::of(0.5);
        let allowed = V::Scalar::of(4.0) * unit * (absolute + ticks * largest)
            + ticks * V::Scalar::of(4.0) * V::Scalar::smallest_normal();
        now.told(quantity::ACCOUNT).within(Law::Balances, error, allowed)
    })
}
