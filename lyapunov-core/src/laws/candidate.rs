//! The laws of a Lyapunov candidate.

use crate::laws::{Law, Tick, Violation};
use crate::{HeldTick, LyapunovCandidate, PortSample, Scalar, Signal};

/// Check of a `candidate` over `samples`: the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NothingForNothing`](Law::NothingForNothing) and [`Recovers`](Law::Recovers).
///
/// # Errors
/// The first law that is broken.
pub fn candidate<V: Signal, C: LyapunovCandidate<V> + Clone>(
    candidate: &C,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (candidate.clone(), candidate.clone());
    for (tick, (sample, _)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let decrease = one.decrease(&sample);
        now.finite(Law::Finite, decrease)?;
        now.same(Law::Repeatable, decrease, other.decrease(&sample))?;

        let mut resting = one.clone();
        let still = PortSample::starting(sample.period, sample.position, V::zero());
        resting.decrease(&still);
        let credited = resting.decrease(&still);
        now.same(Law::NothingForNothing, credited, V::Scalar::of(0.0))?;

        let mut shaken = one.clone();
        let nan = V::splat(V::Scalar::of(f64::NAN));
        shaken.decrease(
            &HeldTick {
                period: sample.period,
                position: nan,
                velocity: nan,
                displacement: nan,
                applied: nan,
            }
            .sample(),
        );
        now.finite(Law::Recovers, shaken.decrease(&sample))?;
    }
    Ok(())
}
