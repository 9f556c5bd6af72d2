//! Coordinates of two masses with a link between them.

use lyapunov_core::Signal;

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

lyapunov_core::signal_of_parts! {
    #[inline]
    impl[V: Signal] TwoMassCoordinates<V>, in V::Scalar, of device, stretch => Self { device, stretch };
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
    use num_traits::Zero;

    use super::*;

    #[test]
    fn either_coordinate_alone_is_not_zero() {
        let at = |device, stretch| TwoMassCoordinates { device, stretch };
        assert!(TwoMassCoordinates::<f64>::zero().is_zero());
        assert!(!at(1.0, 0.0).is_zero() && !at(0.0, 1.0).is_zero());
    }
}
