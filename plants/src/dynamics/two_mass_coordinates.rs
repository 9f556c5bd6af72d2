//! Coordinates of two masses with a link between them.

use core::ops::{Add, Sub};

use lyapunov_core::{Scalar, Signal};
use num_traits::Zero;

use crate::Coordinates;

/// The position of a device and the stretch of its link to the operator; or the rates of both.
///
/// The stretch is a number of its own, not the difference of two positions, which are large beside it: the force of a
/// stiff link keeps its digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoMassCoordinates<V> {
    /// The device's position, at the port.
    pub device: V,
    /// The operator's position less the device's.
    pub stretch: V,
}

impl<V: Add<Output = V>> Add for TwoMassCoordinates<V> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { device: self.device + other.device, stretch: self.stretch + other.stretch }
    }
}

impl<V: Sub<Output = V>> Sub for TwoMassCoordinates<V> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { device: self.device - other.device, stretch: self.stretch - other.stretch }
    }
}

impl<V: Zero> Zero for TwoMassCoordinates<V> {
    #[inline]
    fn zero() -> Self {
        Self { device: V::zero(), stretch: V::zero() }
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.device.is_zero() && self.stretch.is_zero()
    }
}

impl<V: Signal> Signal for TwoMassCoordinates<V> {
    type Scalar = V::Scalar;

    #[inline]
    fn splat(value: V::Scalar) -> Self {
        Self { device: V::splat(value), stretch: V::splat(value) }
    }

    #[inline]
    fn zip(self, other: Self, mut f: impl FnMut(V::Scalar, V::Scalar) -> V::Scalar) -> Self {
        Self {
            device: self.device.zip(other.device, &mut f),
            stretch: self.stretch.zip(other.stretch, f),
        }
    }

    #[inline]
    fn sum(self) -> V::Scalar {
        self.device.sum() + self.stretch.sum()
    }

    #[inline]
    fn choose(mask: <V::Scalar as Scalar>::Mask, yes: Self, no: Self) -> Self {
        Self {
            device: V::choose(mask, yes.device, no.device),
            stretch: V::choose(mask, yes.stretch, no.stretch),
        }
    }
}

impl<V: Signal> Coordinates<V> for TwoMassCoordinates<V> {
    #[inline]
    fn all_at(place: V) -> Self {
        Self { device: place, stretch: V::zero() }
    }

    #[inline]
    fn at_port(self) -> V {
        self.device
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn either_coordinate_alone_is_not_zero() {
        let at = |device, stretch| TwoMassCoordinates { device, stretch };
        assert!(TwoMassCoordinates::<f64>::zero().is_zero());
        assert!(!at(1.0, 0.0).is_zero() && !at(0.0, 1.0).is_zero());
    }
}
