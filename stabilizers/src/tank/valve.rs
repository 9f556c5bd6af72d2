//! The valves of an energy tank.

use lyapunov_core::Scalar;

use super::TankLimits;
use crate::limiting::payable;

/// Valve: the energy that a tank lets in and out in one period.
pub trait Valve<T: Scalar>: sealed::Sealed {
    /// The share of the wished power `asked` (W, above 0 where it extracts) that passes while the tank holds `energy`.
    fn share(&self, store: &TankLimits<T>, energy: T, asked: T, period: T) -> T;

    /// Energy of a tank that held `energy` and has `left` after its port drew, once `gain` joules were offered to it.
    fn filled(&self, store: &TankLimits<T>, energy: T, left: T, gain: T) -> T;

    /// The part of a stored `energy` that a tank may hold, J.
    fn held(&self, store: &TankLimits<T>, energy: T) -> T;
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
    fn filled(&self, store: &TankLimits<T>, energy: T, left: T, gain: T) -> T {
        T::choose(energy.above(store.ceiling), left, left + gain)
    }

    #[inline]
    fn held(&self, _store: &TankLimits<T>, energy: T) -> T {
        energy
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
    fn filled(&self, store: &TankLimits<T>, _energy: T, left: T, gain: T) -> T {
        (left + gain).smaller(store.ceiling)
    }

    #[inline]
    fn held(&self, store: &TankLimits<T>, energy: T) -> T {
        energy.smaller(store.ceiling)
    }
}

mod sealed {
    /// Valves of this crate: tanks are made with no other.
    pub trait Sealed {}

    impl Sealed for super::OpenValve {}
    impl Sealed for super::BoundedValve {}
}
