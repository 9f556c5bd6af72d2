//! Velocity estimators: velocities taken from positions.

mod differenced;
mod low_passed;
mod windowed;

pub use differenced::Differenced;
pub use low_passed::LowPassed;
pub use windowed::Windowed;

use crate::{PortSample, Scalar, Signal};

/// The velocity that is booked over a gap, m/s: of the one `told` and the `mean` over the gap the smaller in magnitude, and 0
/// where their directions differ, so that no damper is credited with more than the mean motion dissipated.
///
/// For the crates of this library: each keeps gaps of its own.
#[doc(hidden)]
#[inline(always)]
pub fn careful<T: Scalar>(told: T, mean: T) -> T {
    let zero = T::of(0.0);
    let slower = mean.magnitude().below(told.magnitude());
    let turned = (mean * told).below(zero);
    T::choose(turned, zero, T::choose(slower, mean, told))
}

/// Velocity estimator: it takes a velocity from the positions and displacements that it is told.
///
/// [`Readings`](crate::Readings) and the adaptors of a port estimate by the same three: [`Differenced`],
/// [`LowPassed`] and [`Windowed`]. Check one of your own with
/// [`laws::velocity_estimator`](crate::laws::velocity_estimator).
///
/// ```
/// use lyapunov_core::{PortSample, Readings, Reading, Signal, VelocityEstimator};
/// /// The mean of the last two differences.
/// #[derive(Clone, Copy)]
/// struct Mean<V> { last: V }
/// impl<V: Signal> VelocityEstimator<V> for Mean<V> {
///     fn velocity(&mut self, sample: &PortSample<V>) -> V {
///         let half = V::splat(lyapunov_core::Scalar::of(0.5));
///         let now = sample.displacement.map(|moved| moved / sample.period);
///         let mean = (self.last + now).times(half);
///         self.last = V::choose(now.finite(), now, V::zero());
///         mean
///     }
///     fn restart(&mut self, lanes: <V::Scalar as lyapunov_core::Scalar>::Mask) {
///         self.last = V::choose(lanes, V::zero(), self.last);
///     }
/// }
/// let mut readings = Readings::every(1e-3)?.estimated_by(Mean { last: 0.0 });
/// readings.read(Reading { position: 0.0, applied: 0.0 });
/// let moved = readings.read(Reading { position: 1e-3, applied: 0.0 }).sample;
/// assert_eq!(moved.velocity, 0.5);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub trait VelocityEstimator<V: Signal> {
    /// The velocity at the end of the sample's displacement, m/s; the sample's own velocity is not looked at. An axis
    /// that is not finite may give one that is not, and must not spoil later ones.
    fn velocity(&mut self, sample: &PortSample<V>) -> V;

    /// Notes that the sample after this spans more than a tick in these `lanes`: the positions before it are not as
    /// far away in time as their number says.
    #[inline(always)]
    fn interrupt(&mut self, _lanes: <V::Scalar as Scalar>::Mask) {}

    /// Forgets in these `lanes` what it was told: the next sample is the first, which displaces nothing.
    fn restart(&mut self, lanes: <V::Scalar as Scalar>::Mask);
}

impl<V: Signal, E: VelocityEstimator<V> + ?Sized> VelocityEstimator<V> for &mut E {
    #[inline(always)]
    fn velocity(&mut self, sample: &PortSample<V>) -> V {
        (**self).velocity(sample)
    }

    #[inline(always)]
    fn interrupt(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        (**self).interrupt(lanes);
    }

    #[inline(always)]
    fn restart(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        (**self).restart(lanes);
    }
}
