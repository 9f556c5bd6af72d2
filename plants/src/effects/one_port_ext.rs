//! Adaptors of a port, chained.

use lyapunov_core::{Differenced, LowPassed, OnePort, ParameterError, Signal, Windowed};

use crate::{
    AdaptiveWindow, BackwardDifference, Delay, Dropout, Encoder, Estimated, Fallback, Guard,
    LowPass, Noise, Saturation, Scaled, ZeroOrderHold,
};

/// The adaptors that may act on a port, chained like iterator adaptors, innermost first.
///
/// Efforts pass outwards and samples inwards, so the order matters: `wall.held(10)?.stabilized(c)` observes at the
/// servo rate, `wall.stabilized(c).held(10)?` only at the environment's. Measurement stands outermost:
/// `port.differenced().encoded(1e-5)?` takes velocities from the encoder's counts.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{Fallback, OnePortExt, Wall};
/// // Innermost first: the force is clipped, acts a tick late, and bad samples never reach either.
/// let mut port = Wall::new(8000.0, 0.0)?.saturated(5.0)?.delayed::<1>(1)?.guarded(Fallback::Hold);
/// let deep = PortSample::starting(1e-3, 0.01, 0.0_f64);
/// assert_eq!([port.respond(&deep), port.respond(&deep)], [0.0, 5.0]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub trait OnePortExt<V: Signal>: OnePort<V> + Sized {
    /// Asks this port on every `ticks`-th call only and holds its effort in between.
    ///
    /// # Errors
    /// `ticks` is 0.
    fn held(self, ticks: u32) -> Result<ZeroOrderHold<Self, V>, ParameterError> {
        ZeroOrderHold::new(self, ticks)
    }

    /// Clips the effort to `±force` on each axis, N.
    ///
    /// # Errors
    /// `force` not above 0 and finite.
    fn saturated(self, force: V::Scalar) -> Result<Saturation<Self, V::Scalar>, ParameterError> {
        Saturation::new(self, force)
    }

    /// Scales the effort by `scale`, which may be changed later.
    ///
    /// # Errors
    /// `scale` below 0, infinite or NaN.
    fn scaled(self, scale: V::Scalar) -> Result<Scaled<Self, V::Scalar>, ParameterError> {
        Scaled::new(self, scale)
    }

    /// Delays the effort by `ticks` calls; `N` is the capacity.
    ///
    /// # Errors
    /// `ticks` is above `N`.
    fn delayed<const N: usize>(self, ticks: u32) -> Result<Delay<Self, V, N>, ParameterError> {
        Delay::new(self, ticks)
    }

    /// Rounds positions to an encoder's `resolution`, m.
    ///
    /// # Errors
    /// `resolution` not above 0 and finite, or so small that everyday positions have more counts than the scalar can hold.
    fn encoded(self, resolution: V::Scalar) -> Result<Encoder<Self, V>, ParameterError> {
        Encoder::new(self, resolution)
    }

    /// Takes velocities from displacements.
    #[must_use]
    fn differenced(self) -> BackwardDifference<Self> {
        Estimated::new(self, Differenced)
    }

    /// Takes velocities from displacements through a low pass of `cutoff`, Hz.
    ///
    /// # Errors
    /// `cutoff` not above 0 and finite, or too large for the scalar.
    fn low_passed(self, cutoff: V::Scalar) -> Result<LowPass<Self, V>, ParameterError> {
        Ok(Estimated::new(self, LowPassed::new(cutoff)?))
    }

    /// Takes velocities over up to `ticks` calls, as long as positions lie within `band`, m, of a line; `N` is the
    /// capacity.
    ///
    /// # Errors
    /// `ticks` is 0 or above `N`; `band` below 0, infinite or NaN.
    fn windowed<const N: usize>(
        self,
        ticks: u32,
        band: V::Scalar,
    ) -> Result<AdaptiveWindow<Self, V, N>, ParameterError> {
        Ok(Estimated::new(self, Windowed::new(ticks, band)?))
    }

    /// Adds Gaussian noise of a standard `deviation`, m, to positions; `seed` gives the seed of each lane.
    ///
    /// # Errors
    /// `deviation` below 0, infinite or NaN.
    fn noisy(
        self,
        deviation: V::Scalar,
        seed: impl Fn(usize) -> u64,
    ) -> Result<Noise<Self, V>, ParameterError> {
        Noise::new(self, deviation, seed)
    }

    /// Loses each answer with a `probability`; `seed` gives the seed of each lane.
    ///
    /// # Errors
    /// `probability` not within 0 and 1.
    fn dropped(
        self,
        probability: V::Scalar,
        fallback: Fallback,
        seed: impl Fn(usize) -> u64,
    ) -> Result<Dropout<Self, V>, ParameterError> {
        Dropout::new(self, probability, fallback, seed)
    }

    /// Rejects samples that are not finite, or whose period is not above 0, before anything inside changes.
    ///
    /// Estimators of velocities stand outside, `port.guarded(fallback).low_passed(cutoff)?`: one inside would replace the careful
    /// velocity that the [`Guard`] gives after a gap.
    #[must_use]
    fn guarded(self, fallback: Fallback) -> Guard<Self, V> {
        Guard::new(self, fallback)
    }
}

impl<V: Signal, P: OnePort<V>> OnePortExt<V> for P {}
