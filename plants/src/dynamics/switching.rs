//! Equations of motion in pieces.

use lyapunov_core::{Dynamics, Scalar, State};

/// An equation of motion that is smooth but where a switching function falls below 0: a wall that is met, a motion
/// that comes to rest under friction.
///
/// Each piece is an equation of motion of its own that is smooth beyond its end too, so that an integrator may overstep
/// it and come back. [`Located`](crate::Located) does; the equation itself is that of the piece in which a state is.
/// On one axis, because pieces end where a number changes its sign; each lane is in a piece of its own.
pub trait Switching<T: Scalar>: Dynamics<T> {
    /// A piece.
    type Phase: Dynamics<T, Coordinates = Self::Coordinates> + Copy;

    /// The piece that a motion from `state` under `effort` begins in.
    fn phase(&self, state: State<Self::Coordinates>, effort: T) -> Self::Phase;

    /// The switching function: not below 0 as long as the piece lasts.
    fn reserve(&self, phase: &Self::Phase, state: State<Self::Coordinates>) -> T;

    /// What follows where `phase` ends at `state`, and what the state gains by it: 0, or what makes it exactly the end.
    fn switched(
        &self,
        phase: &Self::Phase,
        state: State<Self::Coordinates>,
        effort: T,
    ) -> (Self::Phase, State<Self::Coordinates>);

    /// `yes` in the lanes of `mask`, `no` elsewhere.
    fn chosen(mask: T::Mask, yes: Self::Phase, no: Self::Phase) -> Self::Phase;
}
