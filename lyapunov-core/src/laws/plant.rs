//! The laws of a plant.

use crate::laws::{Allowed, Law, Tick, Violation, quantity};
use crate::{Plant, PortSample, Scalar, Signal};

/// Check of a `plant` under the efforts of `samples`: the laws [`Finite`](Law::Finite),
/// [`Repeatable`](Law::Repeatable) and [`TellsTheTruth`](Law::TellsTheTruth).
///
/// # Errors
/// The first law that is broken.
pub fn plant<V: Signal, P: Plant<V> + Clone>(
    plant: &P,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (plant.clone(), plant.clone());
    let mut last = one.start();
    let zero = V::zero();
    Tick(0).told(quantity::FIRST_DISPLACEMENT).same(Law::TellsTheTruth, last.displacement, zero)?;
    Tick(0).told(quantity::FIRST_WORK).same(Law::TellsTheTruth, last.work, zero)?;
    for (tick, (_, effort)) in samples.into_iter().enumerate() {
        let sample = one.advance(effort);
        tells(Tick(tick), &last, &sample, effort)
            .and_then(|()| {
                let (now, again) = (Tick(tick), other.advance(effort));
                now.told(quantity::POSITION).same(
                    Law::Repeatable,
                    sample.position,
                    again.position,
                )?;
                now.told(quantity::VELOCITY).same(Law::Repeatable, sample.velocity, again.velocity)
            })
            .map_err(|broken| broken.under(&sample, effort))?;
        last = sample;
    }
    Ok(())
}

fn tells<V: Signal>(
    now: Tick,
    last: &PortSample<V>,
    sample: &PortSample<V>,
    effort: V,
) -> Result<(), Violation> {
    let finite = |_| Allowed::Finite;
    now.told(quantity::SAMPLE).require(
        Law::Finite,
        sample.finite(),
        sample.position.sum(),
        finite,
    )?;
    now.told(quantity::APPLIED_EFFORT).same(Law::TellsTheTruth, sample.applied, effort)?;
    let apart = (sample.position - last.position - sample.displacement).map(Scalar::magnitude);
    let size = sample.position.map(Scalar::magnitude) + last.position.map(Scalar::magnitude);
    let rounding = V::Scalar::of(16.0) * V::Scalar::epsilon() * size.sum();
    let allowed = rounding + V::Scalar::smallest_normal();
    now.told(quantity::DISPLACEMENT).within(Law::TellsTheTruth, apart.sum(), allowed)?;
    let work = effort.times(sample.displacement);
    now.told(quantity::WORK).same(Law::TellsTheTruth, sample.work, work)
}
