//! Credit of an environment's own damper, as a term of a candidate.

use lyapunov_core::Snapshot;

/// The credit of the own damper of an environment `E` whose damping, or whose velocity, is not simply the port's.
///
/// The environment's method `dissipation` makes it; where the damper is constant and acts on the velocity of the port,
/// that method returns a [`Dissipation`](lyapunov_core::Dissipation) instead. Like the credit of a
/// [`Wall`](crate::Wall) it counts strictly in contact, at the time of the observer's tick, even while the
/// environment's force is held or clipped to 0; and as there it may be larger than what physically dissipates. A
/// dissipated energy that is not finite credits nothing: the work of that tick is booked without it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DissipationOf<E>(pub(crate) E);

lyapunov_core::snapshot!(impl[E: Snapshot] DissipationOf<E>, is 0, of E::State);
