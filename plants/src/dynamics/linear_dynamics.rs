//! Equations of motion that are linear.

use core::fmt::Debug;

use lyapunov_core::{Dynamics, Signal, State};

/// An equation of motion that is linear, up to a constant force, so that its exact solution over an interval is a linear
/// map of state and effort, and a constant.
pub trait LinearDynamics<V: Signal>: Dynamics<V> {
    /// What each part of the state gains over an interval per unit of each part and of effort.
    type Increments: Copy + Debug;

    /// The map over `interval` s ([`held_input`](crate::held_input)); where it is out of range, not finite.
    fn increments(&self, interval: V::Scalar) -> Self::Increments;

    /// What `from` gains by the map.
    fn gain(
        increments: &Self::Increments,
        from: State<Self::Coordinates>,
        effort: V,
    ) -> State<Self::Coordinates>;
}
