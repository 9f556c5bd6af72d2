//! Equations that are linear.

use core::fmt::Debug;

use lyapunov_core::{Dynamics, Signal};

/// An equation that is linear, up to a constant, so that its exact solution over an interval is a linear map of state
/// and input, and a constant.
pub trait LinearDynamics<U: Signal>: Dynamics<U> {
    /// What each part of the state gains over an interval per unit of each part and of input.
    type Increments: Copy + Debug;

    /// The map over `interval` s ([`held_input`](crate::held_input)); where it is out of range, not finite.
    fn increments(&self, interval: U::Scalar) -> Self::Increments;

    /// What `from` gains by the map.
    fn gain(increments: &Self::Increments, from: Self::State, input: U) -> Self::State;
}
