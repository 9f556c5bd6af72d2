//! The law of a candidate's decrease: its sum is the decrease of its function.

use crate::laws::{Law, Tick, Violation, quantity};
use crate::{LyapunovCandidate, PortSample, Scalar, Signal};

/// Check of the law [`AddsUp`](Law::AddsUp) on a `candidate` over the samples `samples`: from the first sample on its
/// decreases sum to `V(start) − V(n)`, where `value` gives `V` at a sample.
///
/// The two may differ by `share` of all the rises and falls of `V` so far, and by rounding. A candidate by differences
/// keeps the law with a share of 0; one by rates, `−V̇ T`, with a share as large as its quadrature error, which is of
/// the order of the period.
///
/// # Errors
/// [`Finite`](Law::Finite), or [`AddsUp`](Law::AddsUp) with the error of the sum.
pub fn decrease<V: Signal, C: LyapunovCandidate<V> + Clone>(
    candidate: &C,
    value: impl Fn(&PortSample<V>) -> V::Scalar,
    samples: impl IntoIterator<Item = PortSample<V>>,
    share: V::Scalar,
) -> Result<(), Violation> {
    let mut candidate = candidate.clone();
    let mut samples = samples.into_iter();
    let Some(first) = samples.next() else { return Ok(()) };
    candidate.decrease(&first);
    let start = value(&first);
    let zero = V::Scalar::of(0.0);
    let (mut last, mut told, mut travelled, mut rounding) = (start, zero, zero, zero);
    for (index, sample) in samples.enumerate() {
        let now = Tick(index + 1);
        let here = value(&sample);
        now.told(quantity::ENERGY_VALUE).finite(Law::Finite, here)?;
        told += candidate.decrease(&sample);
        now.told(quantity::SUM_OF_DECREASES).finite(Law::Finite, told)?;
        travelled += (here - last).magnitude();
        rounding += (told.magnitude() + here.magnitude() + last.magnitude()) * V::Scalar::epsilon();
        last = here;
        let apart = told - (start - here);
        let allowed = share * travelled + rounding;
        now.told(quantity::SUM_OF_DECREASES).within(Law::AddsUp, apart, allowed)?;
    }
    Ok(())
}
