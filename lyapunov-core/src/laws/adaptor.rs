//! The law of an adaptor: a port that owns another.

use super::stabilizer::alike;
use crate::laws::{Law, Tick, Violation};
use crate::{Correction, OnePort, PortSample, Scalar, Signal};

/// Port with a correction that no other port reports, which [`adaptor`] puts inside the adaptor under test.
#[derive(Clone, Copy, Debug)]
pub struct Probe<V: Signal> {
    correction: Correction<V>,
}

impl<V: Signal> Probe<V> {
    fn new() -> Self {
        let of = V::Scalar::of;
        let effort = V::splat(of(0.25));
        let correction = Correction {
            observed_energy: of(-3.0),
            alpha: of(5.0),
            shortfall: of(7.0),
            ..Correction::none(effort)
        };
        Self { correction }
    }
}

impl<V: Signal> OnePort<V> for Probe<V> {
    fn respond(&mut self, _sample: &PortSample<V>) -> V {
        self.correction.effort
    }

    fn correction(&self) -> Correction<V> {
        self.correction
    }
}

/// Check of the law [`HandsOn`](Law::HandsOn) on the adaptor that `wrap` makes around a port, over `samples`: its
/// [`OnePort::correction`] is that of the port it owns.
///
/// [`Stabilized`](crate::Stabilized) is no adaptor in this sense: it reports its own correction.
///
/// ```
/// use lyapunov_core::{PortSample, OnePort, Signal, laws};
/// /// Reverses the effort, and forgets to hand on the correction of the port inside.
/// struct Turned<P>(P);
/// impl<V: Signal, P: OnePort<V>> OnePort<V> for Turned<P> {
///     fn respond(&mut self, sample: &PortSample<V>) -> V {
///         V::zero() - self.0.respond(sample)
///     }
/// }
/// let broken = laws::adaptor::<f64, _>(Turned, laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!(broken.law, laws::Law::HandsOn);
/// ```
///
/// # Errors
/// The first sample after which the correction differs.
pub fn adaptor<V: Signal, P: OnePort<V>>(
    wrap: impl FnOnce(Probe<V>) -> P,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let probe = Probe::new();
    let inside = probe.correction;
    let mut port = wrap(probe);
    for (tick, (sample, _)) in samples.into_iter().enumerate() {
        let effort = port.respond(&sample);
        let told = alike(Tick(tick), Law::HandsOn, &port.correction(), &inside);
        told.map_err(|broken| broken.under(&sample, effort))?;
    }
    Ok(())
}
