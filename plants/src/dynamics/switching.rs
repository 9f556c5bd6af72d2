//! Equations in pieces.

use lyapunov_core::{Dynamics, Scalar};

/// An equation that is smooth but where a switching function falls below 0: a wall that is met, a motion that comes to
/// rest under friction.
///
/// Each piece is an equation of its own that is smooth beyond its end too, so that an integrator may overstep
/// it and come back. [`EventLocating`](crate::EventLocating) does; the equation itself is that of the piece in which a state is.
/// Under one input, because pieces end where a number changes its sign; each lane is in a piece of its own.
pub trait Switching<T: Scalar>: Dynamics<T> {
    /// A piece.
    type Phase: Dynamics<T, State = Self::State> + Copy;

    /// The piece that begins at `state` under `input`.
    fn phase(&self, state: Self::State, input: T) -> Self::Phase;

    /// The switching function: not below 0 as long as the piece lasts.
    fn reserve(&self, phase: &Self::Phase, state: Self::State) -> T;

    /// What follows where `phase` ends at `state`, and what the state gains by it: 0, or what makes it exactly the end.
    fn switched(
        &self,
        phase: &Self::Phase,
        state: Self::State,
        input: T,
    ) -> (Self::Phase, Self::State);

    /// `yes` in the lanes of `mask`, `no` elsewhere.
    fn chosen(mask: T::Mask, yes: Self::Phase, no: Self::Phase) -> Self::Phase;
}
