//! What an environment's own damper burns, as a term of a candidate.

/// The credit of the own damper of an environment `E` whose damping, or whose velocity, is not simply the port's.
///
/// The environment makes it by its method `dissipation`; where the damper is constant and acts on the velocity of
/// the port, that gives a [`Dissipation`](lyapunov_core::Dissipation) instead. Like that of a
/// [`Wall`](crate::Wall) it counts in contact, strictly, at the time of the observer's tick, also while the
/// environment's force is held or clipped to 0; and as there it may be larger than what physically burns.
/// A burnt energy that is not finite credits nothing: the work of that tick is booked without it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DissipationOf<E>(pub(crate) E);
