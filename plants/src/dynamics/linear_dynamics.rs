//! Linear equations, which have an exact solution.

use core::fmt::Debug;

use lyapunov_core::{Dynamics, Signal};

/// An equation that is linear up to a constant: its exact solution over an interval is a linear map of state and input,
/// plus a constant.
pub trait LinearDynamics<U: Signal>: Dynamics<U> {
    /// The gain of each part of the state over an interval, per unit of each part and of input.
    type Increments: Copy + Debug;

    /// The map over `interval` s ([`held_input`](crate::held_input)); not finite where it is out of range.
    fn increments(&self, interval: U::Scalar) -> Self::Increments;

    /// The gain of `from` by the map.
    fn gain(increments: &Self::Increments, from: Self::State, input: U) -> Self::State;
}
