//! The laws of a one-port.

use crate::laws::{Law, Tick, Violation, quantity};
use crate::{OnePort, PortSample, Signal};

/// Check of a `port` over `samples`: the laws [`Finite`](Law::Finite) and [`Repeatable`](Law::Repeatable).
///
/// # Errors
/// The first law that is broken.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample, laws};
/// /// A force that has no bound at rest.
/// #[derive(Clone)]
/// struct Hyperbola;
/// impl OnePort<f64> for Hyperbola {
///     fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
///         1.0 / sample.velocity
///     }
/// }
/// let broken = laws::one_port(&Hyperbola, laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!(broken.law, laws::Law::Finite);
/// ```
pub fn one_port<V: Signal, P: OnePort<V> + Clone>(
    port: &P,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (port.clone(), port.clone());
    for (tick, (sample, _)) in samples.into_iter().enumerate() {
        let now = Tick(tick).told(quantity::EFFORT);
        let effort = one.respond(&sample);
        now.finite(Law::Finite, effort)
            .and_then(|()| now.same(Law::Repeatable, effort, other.respond(&sample)))
            .map_err(|broken| broken.under(&sample, effort))?;
    }
    Ok(())
}
