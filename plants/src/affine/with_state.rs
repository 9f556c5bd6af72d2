//! Signal at the port of a plant with a state.

use core::ops::{Add, Sub};

use lyapunov_core::{Scalar, Signal};
use nalgebra::SVector;
use num_traits::Zero;

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

impl<T: Scalar, const N: usize, const M: usize> Add for WithState<T, N, M> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { input: self.input + other.input, state: self.state + other.state }
    }
}

impl<T: Scalar, const N: usize, const M: usize> Sub for WithState<T, N, M> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { input: self.input - other.input, state: self.state - other.state }
    }
}

impl<T: Scalar, const N: usize, const M: usize> Zero for WithState<T, N, M> {
    #[inline]
    fn zero() -> Self {
        Self::of_input(SVector::zeros())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.input.is_zero() && self.state.is_zero()
    }
}

impl<T: Scalar, const N: usize, const M: usize> Signal for WithState<T, N, M> {
    type Scalar = T;

    #[inline]
    fn splat(value: T) -> Self {
        Self { input: Signal::splat(value), state: Signal::splat(value) }
    }

    #[inline]
    fn zip(self, other: Self, mut f: impl FnMut(T, T) -> T) -> Self {
        Self { input: self.input.zip(other.input, &mut f), state: self.state.zip(other.state, f) }
    }

    #[inline]
    fn sum(self) -> T {
        Signal::sum(self.input) + Signal::sum(self.state)
    }

    #[inline]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            input: Signal::choose(mask, yes.input, no.input),
            state: Signal::choose(mask, yes.state, no.state),
        }
    }
}
