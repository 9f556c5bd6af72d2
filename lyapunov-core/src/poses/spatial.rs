//! `Spatial` trait: a signal of a rigid body.

use crate::{Axes, Scalar, Screw, Signal, WithPose};

/// A signal that is a twist or a wrench, with or without a pose beside it.
///
/// What treats translation and rotation apart is written once for both.
///
/// ```
/// use lyapunov_core::{LyapunovCandidate, PortSample, Signal, Spatial};
/// /// The work of rotation alone.
/// struct OfRotation;
/// impl<V: Spatial> LyapunovCandidate<V> for OfRotation {
///     fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
///         Signal::sum(sample.work.screw().rotation)
///     }
/// }
/// ```
pub trait Spatial: Signal {
    /// The axes along which the screw is given.
    type Axes: Axes;

    /// The twist or wrench.
    fn screw(self) -> Screw<Self::Scalar, Self::Axes>;

    /// The signal of `screw`, and nothing else.
    fn of_screw(screw: Screw<Self::Scalar, Self::Axes>) -> Self;
}

impl<T: Scalar, F: Axes> Spatial for Screw<T, F> {
    type Axes = F;

    #[inline(always)]
    fn screw(self) -> Self {
        self
    }

    #[inline(always)]
    fn of_screw(screw: Self) -> Self {
        screw
    }
}

impl<T: Scalar, F: Axes> Spatial for WithPose<T, F> {
    type Axes = F;

    #[inline(always)]
    fn screw(self) -> Screw<T, F> {
        self.screw
    }

    #[inline(always)]
    fn of_screw(screw: Screw<T, F>) -> Self {
        Self::of(screw)
    }
}
