//! Bodies on an operator's spring, as far as their surroundings may change on the way.

use lyapunov_core::{ParameterError, Plant, Signal};

/// A body on an operator's spring, whose rest, parts and interval may change from one period to the next.
///
/// What changes the course of a body owns it, as an adaptor owns a port, and is a tethered body again.
pub trait OperatedBody<V: Signal>: Plant<V> {
    /// What it is made of: an [`Impedance`](crate::Impedance), or one for each mass.
    type Parts: Copy;

    /// Lets the operator's spring rest at `rest` from now on, m.
    fn rest_at(&mut self, rest: V);

    /// Moves by `interval` s at a time from now on, made of `parts`; position, velocity and rest stay.
    ///
    /// # Errors
    /// As the constructor has them, but that an interval may be 0; the body then stays as it was.
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
