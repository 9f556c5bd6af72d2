//! Equations of motion in smooth pieces.

use lyapunov_core::{Dynamics, Scalar};

/// An equation that is smooth except where a switching function falls below 0: at contact with a wall, or where a
/// motion under friction comes to rest.
///
/// Each piece is an equation of its own that stays smooth beyond its end, so that an integrator may overstep the end
/// and come back, as [`EventLocating`](crate::EventLocating) does; the equation itself is that of the piece in which a
/// state is. The input is a single scalar, because pieces end where a number changes its sign; each lane is in a piece
/// of its own.
pub trait Switching<T: Scalar>: Dynamics<T> {
    /// The equation of one piece.
    type Phase: Dynamics<T, State = Self::State> + Copy;

    /// The piece that begins at `state` under `input`.
    fn phase(&self, state: Self::State, input: T) -> Self::Phase;

    /// The switching function: not below 0 as long as the piece lasts.
    fn reserve(&self, phase: &Self::Phase, state: Self::State) -> T;

    /// The piece that follows where `phase` ends at `state`, and the gain of the state with it: 0, or what makes the
    /// end exact.
    fn switched(
        &self,
        phase: &Self::Phase,
        state: Self::State,
        input: T,
    ) -> (Self::Phase, Self::State);

    /// `yes` in the lanes of `mask`, `no` elsewhere.
    fn chosen(mask: T::Mask, yes: Self::Phase, no: Self::Phase) -> Self::Phase;
}
