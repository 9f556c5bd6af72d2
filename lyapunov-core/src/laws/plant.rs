//! The laws of a plant.

use crate::laws::{Law, Tick, Violation};
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
    Tick(0).same(Law::TellsTheTruth, last.displacement, V::zero())?;
    Tick(0).same(Law::TellsTheTruth, last.work, V::zero())?;
    for (tick, (_, effort)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let sample = one.advance(effort);
        now.require(Law::Finite, sample.finite(), sample.position.sum())?;
        now.same(Law::Repeatable, sample.position, other.advance(effort).position)?;
        now.same(Law::TellsTheTruth, sample.applied, effort)?;
        let apart = (sample.position - last.position - sample.displacement).map(Scalar::magnitude);
        let size = sample.position.map(Scalar::magnitude) + last.position.map(Scalar::magnitude);
        let zero = V::Scalar::of(0.0);
        now.not_below_zero(Law::TellsTheTruth, zero - apart.sum(), size.sum())?;
        now.same(Law::TellsTheTruth, sample.work, effort.times(sample.displacement))?;
        last = sample;
    }
    Ok(())
}
