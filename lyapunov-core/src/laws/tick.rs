//! Checks on one tick.

use super::{Allowed, Law, Quantity, Violation};
use crate::{Mask, PortSample, Scalar, Signal};

/// Index of the tick that is being checked.
#[derive(Clone, Copy)]
pub(super) struct Tick(pub(super) usize);

/// Quantity of a tick that is being checked.
#[derive(Clone, Copy)]
pub(super) struct Told {
    tick: usize,
    quantity: &'static Quantity,
}

impl Tick {
    /// The first breach that `check` finds at one of the `samples`, with what drove it.
    pub(super) fn each<V: Signal>(
        samples: impl IntoIterator<Item = (PortSample<V>, V)>,
        mut check: impl FnMut(Self, &PortSample<V>, V) -> Result<(), Violation>,
    ) -> Result<(), Violation> {
        for (index, (sample, effort)) in samples.into_iter().enumerate() {
            check(Self(index), &sample, effort).map_err(|broken| broken.under(&sample, effort))?;
        }
        Ok(())
    }

    /// The quantity on this tick.
    pub(super) fn told(self, quantity: &'static Quantity) -> Told {
        Told { tick: self.0, quantity }
    }
}

impl Told {
    /// Breaks `law` where `kept` is false, and reports that lane of `value`.
    pub(super) fn require<T: Scalar>(
        self,
        law: Law,
        kept: T::Mask,
        value: T,
        allowed: impl FnOnce(usize) -> Allowed,
    ) -> Result<(), Violation> {
        let Self { tick, quantity } = self;
        match (0..T::LANES).find(|&lane| !kept.lane(lane)) {
            Some(lane) => {
                let (value, allowed, lane) = (value.lane(lane), allowed(lane), lane as u32);
                Err(Violation { law, tick, lane, quantity, value, allowed, drive: None })
            }
            None => Ok(()),
        }
    }

    /// Breaks `law` where a number is not finite.
    pub(super) fn finite<V: Signal>(self, law: Law, signal: V) -> Result<(), Violation> {
        self.require(law, signal.finite(), signal.sum(), |_| Allowed::Finite)
    }

    /// Breaks `law` where `kept` is false.
    pub(super) fn holds<T: Scalar>(self, law: Law, kept: T::Mask) -> Result<(), Violation> {
        self.require(law, kept, T::of(0.0), |_| Allowed::True)
    }

    /// Breaks `law` where `apart` is larger than `allowed` in magnitude.
    pub(super) fn within<T: Scalar>(self, law: Law, apart: T, allowed: T) -> Result<(), Violation> {
        let kept = apart.finite() & !allowed.below(apart.magnitude());
        self.require(law, kept, apart, |lane| Allowed::Within(allowed.lane(lane)))
    }

    /// Breaks `law` where `value` is below 0 by more than the rounding of terms as large as `size`.
    pub(super) fn not_below_zero<T: Scalar>(
        self,
        law: Law,
        value: T,
        size: T,
    ) -> Result<(), Violation> {
        let least = -(T::of(16.0) * T::epsilon() * size + T::smallest_normal());
        self.require(law, !value.below(least), value, |lane| Allowed::From(least.lane(lane)))
    }

    /// Breaks `law` where two signals that must be equal differ; two NaN are equal.
    pub(super) fn same<V: Signal>(self, law: Law, one: V, other: V) -> Result<(), Violation> {
        let zero = V::Scalar::of(0.0);
        // A number's magnitude is above −1, a NaN's is not.
        let number = |axis: V::Scalar| axis.magnitude().above(V::Scalar::of(-1.0));
        let apart = one.zip(other, |a, b| {
            let (both, any) = (number(a) & number(b), number(a) | number(b));
            let alike = both & !(a.below(b) | b.below(a)) | !any;
            V::Scalar::choose(alike, zero, V::Scalar::of(1.0))
        });
        let kept = !zero.below(apart.sum());
        self.require(law, kept, (one - other).sum(), |_| Allowed::Within(0.0))
    }
}

/// Lane `lane` of every axis, in all lanes.
pub(super) fn spread<X: Signal>(signal: X, lane: usize) -> X {
    signal.map(|axis| X::Scalar::from_reals(|_| axis.real(lane)))
}
