//! Range of the efforts over a gap between sound samples.

use crate::{Scalar, Signal};

/// The least and the largest effort that applied since the last sound sample, axis by axis.
///
/// For the crates of this library: each keeps gaps of its own.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffortRange<V> {
    pub least: V,
    pub most: V,
}

impl<V: Signal> EffortRange<V> {
    /// The range of one `effort`.
    #[inline(always)]
    pub fn of(effort: V) -> Self {
        Self { least: effort, most: effort }
    }

    /// The range that `effort` widens.
    #[inline(always)]
    #[must_use]
    pub fn with(self, effort: V) -> Self {
        Self {
            least: self.least.zip(effort, Scalar::smaller),
            most: self.most.zip(effort, Scalar::larger),
        }
    }

    /// This range in the lanes of the mask, and `other` elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn choose(mask: <V::Scalar as Scalar>::Mask, this: Self, other: Self) -> Self {
        Self {
            least: V::choose(mask, this.least, other.least),
            most: V::choose(mask, this.most, other.most),
        }
    }

    /// The work over a `displacement`, J: the least that an effort within the range does.
    #[inline(always)]
    pub fn least_work(self, displacement: V) -> V {
        self.least.times(displacement).zip(self.most.times(displacement), Scalar::smaller)
    }
}
