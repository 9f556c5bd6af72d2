//! Booking of a tick's work, at once or on the next tick.

use lyapunov_core::{Accumulator, Held, Sampled, Scalar, Signal, Work};

use super::TwoPortSide;
use super::one_way::OneWay;
use crate::Lolc;

/// Whether the work of an effort is booked on the tick that asks for it, or on the next, which reports what it was.
pub trait Booking: Work {
    /// On the tick that asks for it.
    const AT_ONCE: bool;
}

impl Booking for Held {
    const AT_ONCE: bool = false;
}

impl Booking for Sampled {
    const AT_ONCE: bool = true;
}

/// An account that a [`DriftCompensated`](super::DriftCompensated) port pays from.
pub trait Spending<T: Scalar> {
    /// Books what the compensation of this tick is about to give, J, where no later sample reports it; an energy that is not
    /// finite is left out.
    fn spend(&mut self, energy: T);

    /// Part of `work`, J, that a later sample is to report: the work over the next period of the flow that goes out.
    fn due(work: T) -> T;
}

impl<T: Scalar, C, W: Booking, A: Accumulator<T>> Spending<T> for Lolc<T, C, W, A> {
    #[inline]
    fn spend(&mut self, energy: T) {
        if W::AT_ONCE {
            self.credit(-energy);
        }
    }

    #[inline]
    fn due(work: T) -> T {
        if W::AT_ONCE { T::of(0.0) } else { work }
    }
}

impl<V, W, A> Spending<V::Scalar> for TwoPortSide<V, W, A>
where
    V: Signal,
    W: Booking,
    A: Accumulator<V::Scalar>,
{
    #[inline]
    fn spend(&mut self, energy: V::Scalar) {
        self.controller.spend(energy);
    }

    #[inline]
    fn due(work: V::Scalar) -> V::Scalar {
        Lolc::<V::Scalar, OneWay<V>, W, A>::due(work)
    }
}
