//! The laws of a Lyapunov candidate.

use crate::laws::{Law, Tick, Violation, quantity};
use crate::{HeldTick, LyapunovCandidate, PortSample, Scalar, Signal};

/// Check of a `candidate` over `samples`: the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NothingForNothing`](Law::NothingForNothing) and [`Recovers`](Law::Recovers).
///
/// # Errors
/// The first law that is broken.
///
/// ```
/// use lyapunov_core::{LyapunovCandidate, PortSample, laws};
/// /// A credit of 1 mJ on every tick, whatever happens.
/// #[derive(Clone)]
/// struct Gift;
/// impl LyapunovCandidate<f64> for Gift {
///     fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
///         sample.work + 1e-3
///     }
/// }
/// let broken = laws::candidate(&Gift, laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!(broken.law, laws::Law::NothingForNothing);
/// ```
pub fn candidate<V: Signal, C: LyapunovCandidate<V> + Clone>(
    candidate: &C,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (candidate.clone(), candidate.clone());
    Tick::each(samples, |now, sample, _| tick_of(now, &mut one, &mut other, sample))
}

fn tick_of<V: Signal, C: LyapunovCandidate<V> + Clone>(
    now: Tick,
    one: &mut C,
    other: &mut C,
    sample: &PortSample<V>,
) -> Result<(), Violation> {
    let told = now.told(quantity::DECREASE);
    let decrease = one.decrease(sample);
    told.finite(Law::Finite, decrease)?;
    told.same(Law::Repeatable, decrease, other.decrease(sample))?;

    let mut resting = one.clone();
    let still = PortSample::starting(sample.period, sample.position, V::zero());
    resting.decrease(&still);
    let credited = resting.decrease(&still);
    let zero = V::Scalar::of(0.0);
    now.told(quantity::DECREASE_AT_REST).same(Law::NothingForNothing, credited, zero)?;

    let mut shaken = one.clone();
    let nan = V::splat(V::Scalar::of(f64::NAN));
    let spoilt = HeldTick {
        period: sample.period,
        position: nan,
        velocity: nan,
        displacement: nan,
        applied: nan,
    };
    shaken.decrease(&spoilt.sample());
    let after = now.told(quantity::NEXT_DECREASE).finite(Law::Recovers, shaken.decrease(sample));
    after.map_err(|broken| broken.after("motion", f64::NAN))
}
