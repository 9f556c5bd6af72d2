//! State of a mechanical system: position and velocity.

use crate::Signal;

/// Position and velocity of a mechanical system; or the gain of both over an interval, or the rate of both, per s.
///
/// It is a [`Signal`] with the axes of both, so that integrators add and scale it like any other state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State<Q> {
    /// The coordinates, m.
    pub position: Q,
    /// Their rates, m/s.
    pub velocity: Q,
}

crate::signal_of_parts! {
    #[inline(always)]
    impl[Q: Signal] State<Q>, in Q::Scalar, of position, velocity => Self { position, velocity };
}
