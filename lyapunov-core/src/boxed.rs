//! Boxed parts: a box of a part is that part, behind the feature `alloc`.
//!
//! A loop whose parts are chosen at run time holds them in boxes; with these the box goes wherever the part does.

use alloc::boxed::Box;

use crate::{
    Correction, LyapunovCandidate, OnePort, Plant, PortSample, Scalar, Signal, Stabilizer,
    VelocityEstimator,
};

/// ```
/// use lyapunov_core::{Correction, OnePort, PortSample, Stabilizer};
/// struct Wall;
/// impl OnePort<f64> for Wall {
///     fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
///         8000.0 * sample.position.max(0.0)
///     }
/// }
/// struct Damper(f64);
/// impl Stabilizer<f64> for Damper {
///     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
///         Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }.checked()
///     }
/// }
/// let chosen: Box<dyn Stabilizer<f64>> = Box::new(Damper(2.0));
/// let mut port = Wall.stabilized(chosen);
/// assert_eq!(port.respond(&PortSample::starting(1e-3, 1e-3, 0.5)), 9.0);
/// ```
impl<V: Signal, S: Stabilizer<V> + ?Sized> Stabilizer<V> for Box<S> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        (**self).stabilize(sample, effort)
    }
}

/// ```
/// use lyapunov_core::{HeldTick, LyapunovCandidate, Observer, PortEnergy};
/// let chosen: Box<dyn LyapunovCandidate<f64>> = Box::new(PortEnergy);
/// let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 0.0, displacement: 0.25, applied: 2.0 };
/// assert_eq!(Observer::of(chosen).observe(&tick.sample(), 0.0), 0.5);
/// ```
impl<V: Signal, C: LyapunovCandidate<V> + ?Sized> LyapunovCandidate<V> for Box<C> {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        (**self).decrease(sample)
    }
}

impl<V: Signal, P: OnePort<V> + ?Sized> OnePort<V> for Box<P> {
    #[inline]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        (**self).respond(sample)
    }

    #[inline]
    fn correction(&self) -> Correction<V> {
        (**self).correction()
    }
}

impl<V: Signal, P: Plant<V> + ?Sized> Plant<V> for Box<P> {
    #[inline]
    fn start(&self) -> PortSample<V> {
        (**self).start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        (**self).advance(effort)
    }

    #[inline]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        (**self).advance_into(effort, sample);
    }
}

/// ```
/// use lyapunov_core::{Differenced, LowPassed, Reading, Readings, VelocityEstimator};
/// let smooth = true;
/// let chosen: Box<dyn VelocityEstimator<f64>> =
///     if smooth { Box::new(LowPassed::new(30.0)?) } else { Box::new(Differenced) };
/// let mut readings = Readings::every(1e-3)?.estimated_by(chosen);
/// readings.read(Reading { position: 0.0, applied: 0.0 });
/// let velocity = readings.read(Reading { position: 1e-3, applied: 0.0 }).sample.velocity;
/// assert!(velocity > 0.0 && velocity < 1.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
impl<V: Signal, E: VelocityEstimator<V> + ?Sized> VelocityEstimator<V> for Box<E> {
    #[inline]
    fn velocity(&mut self, sample: &PortSample<V>) -> V {
        (**self).velocity(sample)
    }

    #[inline]
    fn interrupt(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        (**self).interrupt(lanes);
    }

    #[inline]
    fn restart(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        (**self).restart(lanes);
    }
}
