//! The laws of a velocity estimator.

use crate::laws::{Law, Tick, Violation};
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
    let zero = V::zero();
    for (tick, (sample, _)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let velocity = one.velocity(&sample);
        now.finite(Law::Finite, velocity)?;
        now.same(Law::Repeatable, velocity, other.velocity(&sample))?;

        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut shaken = one.clone();
            let bad = V::splat(V::Scalar::of(bad));
            shaken.velocity(&PortSample { position: bad, displacement: bad, ..sample });
            now.finite(Law::Recovers, shaken.velocity(&sample))?;
        }

        let mut fresh = one.clone();
        fresh.restart(Mask::of(true));
        let still = PortSample::starting(sample.period, sample.position, zero);
        now.same(Law::NothingForNothing, fresh.velocity(&still), zero)?;
    }
    Ok(())
}
