//! The laws of a velocity estimator.

use crate::laws::{Law, Tick, Violation, quantity};
use crate::{Mask, PortSample, Scalar, Signal, VelocityEstimator};

/// Check of an `estimator` over `samples`: the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`Recovers`](Law::Recovers), and [`NothingForNothing`](Law::NothingForNothing) after a restart.
///
/// ```
/// use lyapunov_core::{LowPassed, laws};
/// laws::velocity_estimator(&LowPassed::<f64>::new(30.0)?, laws::Samples::new(1e-3))?;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// # Errors
/// The first law that is broken.
pub fn velocity_estimator<V: Signal, E: VelocityEstimator<V> + Clone>(
    estimator: &E,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (estimator.clone(), estimator.clone());
    Tick::each(samples, |now, sample, _| tick_of(now, &mut one, &mut other, sample))
}

fn tick_of<V: Signal, E: VelocityEstimator<V> + Clone>(
    now: Tick,
    one: &mut E,
    other: &mut E,
    sample: &PortSample<V>,
) -> Result<(), Violation> {
    let (told, zero) = (now.told(quantity::VELOCITY), V::zero());
    let velocity = one.velocity(sample);
    told.finite(Law::Finite, velocity)?;
    told.same(Law::Repeatable, velocity, other.velocity(sample))?;

    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut shaken = one.clone();
        let spoilt = V::splat(V::Scalar::of(bad));
        shaken.velocity(&PortSample { position: spoilt, displacement: spoilt, ..*sample });
        let next = now.told(quantity::NEXT_VELOCITY);
        next.finite(Law::Recovers, shaken.velocity(sample))
            .map_err(|broken| broken.after("position", bad))?;
    }

    let mut fresh = one.clone();
    fresh.restart(Mask::of(true));
    let still = PortSample::starting(sample.period, sample.position, zero);
    let first = now.told(quantity::VELOCITY_AFTER_RESTART);
    first.same(Law::NothingForNothing, fresh.velocity(&still), zero)
}
