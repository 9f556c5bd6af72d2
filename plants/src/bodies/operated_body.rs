//! Bodies on an operator's spring that may change between periods.

use lyapunov_core::{ParameterError, Plant, Signal};

/// A body on an operator's spring, whose rest, parts and interval may change from one period to the next.
///
/// An adaptor that changes the motion of such a body owns it, as an adaptor owns a port, and is such a body again.
pub trait OperatedBody<V: Signal>: Plant<V> {
    /// The parts it is made of: an [`Impedance`](crate::Impedance), or one for each mass.
    type Parts: Copy;

    /// Moves the rest of the operator's spring to `rest`, m, from now on.
    fn rest_at(&mut self, rest: V);

    /// Changes the parts to `parts` and the period to `interval` s from now on; position, velocity and rest stay.
    ///
    /// # Errors
    /// Those of the constructor, except that an interval may be 0; after an error the body is unchanged.
    fn reshape(&mut self, parts: Self::Parts, interval: V::Scalar) -> Result<(), ParameterError>;
}

impl<V: Signal, B: OperatedBody<V> + ?Sized> OperatedBody<V> for &mut B {
    type Parts = B::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        (**self).rest_at(rest);
    }

    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        (**self).reshape(parts, interval)
    }
}
