//! Settling of a motion.

use lyapunov::Scalar;

/// Watches since when the plant has stayed within a band about a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Settling<T> {
    rest: T,
    band: T,
    ticks: T,
    /// The number of ticks up to and including the last one outside.
    outside: T,
}

impl<T: Scalar> Settling<T> {
    /// A band of `band` m on either side of `rest` m; a band below 0 is never entered.
    pub(crate) fn new(rest: T, band: T) -> Self {
        Self { rest, band, ticks: T::zero(), outside: T::zero() }
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, position: T) {
        self.ticks += T::one();
        let outside = (position - self.rest).magnitude().above(self.band);
        self.outside = T::choose(outside, self.ticks, self.outside);
    }

    /// The tick from which the plant has been in the band, in a lane; none if it is outside.
    pub(crate) fn since(&self, lane: usize) -> Option<f64> {
        let outside = self.outside.lane(lane);
        (outside < self.ticks.lane(lane)).then_some(outside)
    }
}
