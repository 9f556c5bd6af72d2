//! Snapshots: the memory of a value, taken out and given back.

use core::fmt::Debug;

use crate::ParameterError;

/// Value whose memory can be taken out, stored, and given back bit for bit.
///
/// The memory is numbers alone: sums, last values, counters. Parameters and functions stay in the program, which made
/// and checked them; a stored memory is given to a value that was made with the same ones. States are tuples, numbers
/// and vectors, so with the feature `serde` they can be stored in any of its formats, as long as the scalar is `f32`,
/// `f64` or [`DoubleDouble`](crate::DoubleDouble). Take a format that keeps every bit and NaN, such as CBOR; JSON knows
/// no NaN, and its readers may round (`serde_json` does not with its feature `float_roundtrip`).
///
/// What is restored is checked: a sum that is not finite is refused. A sum that is finite and wrong cannot be told from
/// a right one: more than there was is credit that nobody earned, and it weakens every bound by as much. Check
/// one of your own with [`laws::snapshot`](crate::laws::snapshot).
///
/// ```
/// use lyapunov_core::{HeldTick, Observer, PortEnergy, Snapshot};
/// let fresh = Observer::of(PortEnergy);
/// let mut observer = fresh;
/// let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 0.0, displacement: 1e-4, applied: -2.0 };
/// let debt: f64 = observer.observe(&tick.sample(), 0.0);
/// let state = observer.state(); // to be stored over a restart of the machine
/// let mut again = fresh.restored(state)?;
/// assert_eq!(again.observe(&tick.sample(), 0.0), 2.0 * debt);
/// assert!(fresh.restored(((), f64::NAN)).is_err());
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub trait Snapshot: Sized {
    /// The memory.
    type State: Copy + Debug + PartialEq + 'static;

    /// The memory now.
    fn state(&self) -> Self::State;

    /// This value with the memory `state` in place of its own.
    ///
    /// # Errors
    /// A number that cannot be in the memory.
    fn restored(self, state: Self::State) -> Result<Self, ParameterError>;
}

/// Snapshot of values without memory.
#[doc(hidden)]
#[macro_export]
macro_rules! without_memory {
    ($(impl[$($parameters:tt)*] $type:ty);+ $(;)?) => {$(
        impl<$($parameters)*> $crate::Snapshot for $type {
            type State = ();

            fn state(&self) {}

            fn restored(self, _state: ()) -> Result<Self, $crate::ParameterError> {
                Ok(self)
            }
        }
    )+};
}

/// Snapshot of a value whose memory is that of one field.
#[doc(hidden)]
#[macro_export]
macro_rules! snapshot {
    (impl[$($parameters:tt)*] $type:ty, is $field:tt, of $state:ty) => {
        impl<$($parameters)*> $crate::Snapshot for $type {
            type State = $state;

            fn state(&self) -> Self::State {
                self.$field.state()
            }

            fn restored(mut self, state: Self::State) -> Result<Self, $crate::ParameterError> {
                self.$field = self.$field.restored(state)?;
                Ok(self)
            }
        }
    };
}

without_memory! {
    impl[] crate::PortEnergy;
    impl[T: crate::Scalar, G] crate::Dissipation<T, G>;
    impl[] crate::Differenced;
    impl[] crate::Measured;
    impl[] crate::Positions;
    impl[] crate::Steady;
}

impl<A: Snapshot, B: Snapshot> Snapshot for (A, B) {
    type State = (A::State, B::State);

    fn state(&self) -> Self::State {
        (self.0.state(), self.1.state())
    }

    fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
        Ok((self.0.restored(state.0)?, self.1.restored(state.1)?))
    }
}

impl<A: Snapshot, B: Snapshot, C: Snapshot> Snapshot for (A, B, C) {
    type State = (A::State, B::State, C::State);

    fn state(&self) -> Self::State {
        (self.0.state(), self.1.state(), self.2.state())
    }

    fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
        Ok((self.0.restored(state.0)?, self.1.restored(state.1)?, self.2.restored(state.2)?))
    }
}
