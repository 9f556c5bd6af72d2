//! The valves of an energy tank.

use lyapunov_core::Scalar;

use super::TankLimits;
use crate::limiting::payable;

/// Valve: the energy that a tank lets in and out in one period.
pub trait Valve<T: Scalar>: sealed::Sealed {
    /// The share of the wished power `asked` (W, above 0 where it extracts) that passes while the tank holds `energy`.
    fn share(&self, store: &TankLimits<T>, energy: T, asked: T, period: T) -> T;

    /// The part of the `gain` that comes in while the tank holds `energy`, J.
    fn gain(&self, store: &TankLimits<T>, energy: T, gain: T) -> T;

    /// The largest energy that the tank keeps, J; infinity: all.
    fn most(&self, store: &TankLimits<T>) -> T;
}

/// The published valve: open to what extracts while `E > floor`, and to what was dissipated while `E ≤ ceiling`.
///
/// Within one period it may overdraw by `T w · y` and overfill by as much.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OpenValve;

impl<T: Scalar> Valve<T> for OpenValve {
    #[inline]
    fn share(&self, store: &TankLimits<T>, energy: T, asked: T, _period: T) -> T {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let shut = asked.above(zero) & !energy.above(store.floor);
        T::choose(shut, zero, one)
    }

    #[inline]
    fn gain(&self, store: &TankLimits<T>, energy: T, gain: T) -> T {
        T::choose(energy.above(store.ceiling), T::of(0.0), gain)
    }

    #[inline]
    fn most(&self, _store: &TankLimits<T>) -> T {
        T::of(f64::INFINITY)
    }
}

/// A bounded valve: what extracts is made smaller to `min(power, (E − floor) / T)`, and what would overflow is let go.
/// Derived here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BoundedValve;

impl<T: Scalar> Valve<T> for BoundedValve {
    #[inline]
    fn share(&self, store: &TankLimits<T>, energy: T, asked: T, period: T) -> T {
        let most = (payable(energy - store.floor) / period).smaller(store.power);
        T::choose(asked.above(most), most / asked, T::of(1.0))
    }

    #[inline]
    fn gain(&self, _store: &TankLimits<T>, _energy: T, gain: T) -> T {
        gain
    }

    #[inline]
    fn most(&self, store: &TankLimits<T>) -> T {
        store.ceiling
    }
}

mod sealed {
    /// Valves of this crate: tanks are made with no other.
    pub trait Sealed {}

    impl Sealed for super::OpenValve {}
    impl Sealed for super::BoundedValve {}
}
