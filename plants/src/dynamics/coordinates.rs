//! Coordinates of a system with a port.

use lyapunov_core::Signal;

/// Coordinates of a system with a port: those of the port and, with several masses, more.
pub trait Coordinates<V: Signal>: Signal<Scalar = V::Scalar> {
    /// Coordinates with everything at `place`; as rates, with everything moving alike.
    fn all_at(place: V) -> Self;

    /// The coordinates at the port.
    fn at_port(self) -> V;
}

impl<V: Signal> Coordinates<V> for V {
    #[inline]
    fn all_at(place: V) -> V {
        place
    }

    #[inline]
    fn at_port(self) -> V {
        self
    }
}
