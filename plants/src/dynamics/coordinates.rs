//! Where the port is among the coordinates.

use lyapunov_core::Signal;

/// Coordinates of a system with a port: those of the port and, of several masses, more.
pub trait Coordinates<V: Signal>: Signal<Scalar = V::Scalar> {
    /// Everything at `place`; of rates, everything moving alike.
    fn all_at(place: V) -> Self;

    /// What the port sees of them.
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
