//! The law of an adaptor: a port that owns another.

use crate::laws::{Law, Tick, Violation};
use crate::{Action, Drive, OnePort, Scalar, Signal};

/// A port that tells of an action that nothing else tells of: what [`adaptor`] puts inside of one.
#[derive(Clone, Copy, Debug)]
pub struct Probe<V: Signal> {
    action: Action<V>,
}

impl<V: Signal> Probe<V> {
    fn new() -> Self {
        let of = V::Scalar::of;
        let effort = V::splat(of(0.25));
        let action =
            Action { sum: of(-3.0), alpha: of(5.0), shortfall: of(7.0), ..Action::none(effort) };
        Self { action }
    }
}

impl<V: Signal> OnePort<V> for Probe<V> {
    fn respond(&mut self, _drive: &Drive<V>) -> V {
        self.action.effort
    }

    fn action(&self) -> Action<V> {
        self.action
    }
}

/// Checks that the adaptor that `wrap` makes around a port keeps the law [`HandsOn`](Law::HandsOn) over the drives of
/// `samples`: its [`OnePort::action`] is that of the port it owns.
///
/// [`Stabilized`](crate::Stabilized) is no adaptor in this sense: it tells of its own action.
///
/// ```
/// use lyapunov_core::{Drive, OnePort, Signal, laws};
/// /// Turns the effort round, and forgets to hand on what the stabilizer inside did.
/// struct Turned<P>(P);
/// impl<V: Signal, P: OnePort<V>> OnePort<V> for Turned<P> {
///     fn respond(&mut self, drive: &Drive<V>) -> V {
///         V::zero() - self.0.respond(drive)
///     }
/// }
/// let broken = laws::adaptor::<f64, _>(Turned, laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!(broken.law, laws::Law::HandsOn);
/// ```
///
/// # Errors
/// The first sample after which the action is another.
pub fn adaptor<V: Signal, P: OnePort<V>>(
    wrap: impl FnOnce(Probe<V>) -> P,
    samples: impl IntoIterator<Item = (Drive<V>, V)>,
) -> Result<(), Violation> {
    let probe = Probe::new();
    let inside = probe.action;
    let mut port = wrap(probe);
    for (tick, (drive, _)) in samples.into_iter().enumerate() {
        port.respond(&drive);
        let (now, told) = (Tick(tick), port.action());
        now.same(Law::HandsOn, told.effort, inside.effort)?;
        now.same(Law::HandsOn, told.sum, inside.sum)?;
        now.same(Law::HandsOn, told.alpha, inside.alpha)?;
        now.same(Law::HandsOn, told.shortfall, inside.shortfall)?;
        now.require(Law::HandsOn, told.accepted, told.sum)?;
    }
    Ok(())
}
