//! Stabilizers at one end of a link.

use lyapunov::{
    Popc, Scalar, Stabilizer,
    stabilizers::{DriftCompensated, NoStabilizer, TwoPortSide},
};

/// A stabilizer at one end of a link, which may be told of energies and tell of its own; one that does neither is alone.
pub(super) trait End<T: Scalar>: Stabilizer<T> {
    /// Takes what the other end tells that it has absorbed, J.
    fn receive(&mut self, _energy: T) {}

    /// What this end has absorbed, J.
    fn absorbed(&self) -> T {
        T::of(0.0)
    }
}

impl<T: Scalar> End<T> for NoStabilizer {}

impl<T: Scalar> End<T> for Popc<T> {}

impl<T: Scalar> End<T> for TwoPortSide<T> {
    fn receive(&mut self, energy: T) {
        Self::receive(self, energy);
    }

    fn absorbed(&self) -> T {
        Self::absorbed(self)
    }
}

impl<T: Scalar> End<T> for DriftCompensated<TwoPortSide<T>, T> {
    fn receive(&mut self, energy: T) {
        Self::receive(self, energy);
    }

    fn absorbed(&self) -> T {
        Self::absorbed(self)
    }
}
