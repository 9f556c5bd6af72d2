//! State of a mechanical system: position and velocity.

use core::ops::{Add, Sub};

use num_traits::Zero;

use crate::{Scalar, Signal};

/// Position and velocity of a mechanical system; or the gain of both over an interval, or the rate of both, per s.
///
/// It is a [`Signal`] with the axes of both, so that integrators add and scale it like any other state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State<Q> {
    /// The coordinates, m.
    pub position: Q,
    /// Their rates, m/s.
    pub velocity: Q,
}

impl<Q: Add<Output = Q>> Add for State<Q> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { position: self.position + other.position, velocity: self.velocity + other.velocity }
    }
}

impl<Q: Sub<Output = Q>> Sub for State<Q> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { position: self.position - other.position, velocity: self.velocity - other.velocity }
    }
}

impl<Q: Zero> Zero for State<Q> {
    #[inline(always)]
    fn zero() -> Self {
        Self { position: Q::zero(), velocity: Q::zero() }
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.position.is_zero() && self.velocity.is_zero()
    }
}

impl<Q: Signal> Signal for State<Q> {
    type Scalar = Q::Scalar;

    #[inline(always)]
    fn splat(value: Q::Scalar) -> Self {
        Self { position: Q::splat(value), velocity: Q::splat(value) }
    }

    #[inline(always)]
    fn zip(self, other: Self, mut f: impl FnMut(Q::Scalar, Q::Scalar) -> Q::Scalar) -> Self {
        Self {
            position: self.position.zip(other.position, &mut f),
            velocity: self.velocity.zip(other.velocity, f),
        }
    }

    #[inline(always)]
    fn sum(self) -> Q::Scalar {
        self.position.sum() + self.velocity.sum()
    }

    #[inline(always)]
    fn choose(mask: <Q::Scalar as Scalar>::Mask, yes: Self, no: Self) -> Self {
        Self {
            position: Q::choose(mask, yes.position, no.position),
            velocity: Q::choose(mask, yes.velocity, no.velocity),
        }
    }
}
