//! Signal at the port of a plant with a state.

use lyapunov_core::Scalar;
use nalgebra::SVector;

/// `M` inputs and, with them, the `N` states, which no effort acts on.
///
/// Controllers and candidates receive only a sample, and they need the whole state, so the sample carries it. The port
/// of a control-affine plant is thereby a port like any other, to be held, delayed, saturated, guarded and stabilized:
///
/// | of a sample or effort | `input` | `state` |
/// |---|---|---|
/// | `position` | `∫ y dt` since the start | `x` |
/// | `velocity` | `y = L_g V` | 0 |
/// | `displacement` | `∫ y dt` over the period | `Δx` |
/// | effort, `applied` | `e = −u` | 0 |
/// | `work` | `eᵢ ∫ yᵢ dt` | 0 |
///
/// The state has neither velocity nor effort: both are 0 in every sample of an [`AffinePlant`](crate::AffinePlant) or
/// of a [`MeasuredPlant`](crate::MeasuredPlant). A damper `α` therefore acts on the inputs alone, and `v²` is `y²`. Do
/// not take velocities from displacements here ([`differenced`](crate::OnePortExt::differenced) and its kin): the flow
/// is computed from the state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithState<T, const N: usize, const M: usize> {
    /// The part that efforts act on at the port.
    pub input: SVector<T, M>,
    /// The part that is only observed there.
    pub state: SVector<T, N>,
}

impl<T: Scalar, const N: usize, const M: usize> WithState<T, N, M> {
    /// `input` on the inputs, nothing on the state.
    #[inline]
    pub fn of_input(input: SVector<T, M>) -> Self {
        Self { input, state: SVector::zeros() }
    }
}

lyapunov_core::signal_of_parts! {
    #[inline]
    impl[T: Scalar, const N: usize, const M: usize] WithState<T, N, M>, in T, of input, state => Self { input, state };
}
