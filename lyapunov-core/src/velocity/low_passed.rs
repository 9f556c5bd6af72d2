//! Velocity through a first-order low pass.

use core::f64::consts::TAU;

use crate::{ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, VelocityEstimator};

/// Velocity taken from displacements through a low pass of first order:
/// `v(n) = v(n−1) + a (Δx(n) / T − v(n−1))`, `a = ω T / (1 + ω T)`, `ω = 2 π cutoff`, `v(0) = 0`.
///
/// It is the filter `ω / (s + ω)` by the backward Euler rule (Oppenheim and Schafer, Discrete-Time Signal Processing,
/// on filters from differences), stable at every rate. `T` is the sample's period. The larger the cutoff, the nearer to
/// the backward difference; an infinite one would be that, which is [`Differenced`](crate::Differenced).
///
/// A velocity that is not finite is told once and then forgotten, axis by axis.
///
/// ```
/// use lyapunov_core::{Reading, Readings};
/// let mut readings = Readings::every(1e-3)?.low_passed(30.0)?;
/// let mut velocity: f64 = 0.0;
/// for tick in 0..100 {
///     let position = 0.5e-3 * f64::from(tick); // 0.5 m/s
///     velocity = readings.read(Reading { position, applied: 0.0 }).sample.velocity;
/// }
/// assert!((velocity - 0.5).abs() < 1e-6);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LowPassed<V: Signal> {
    /// `ω`, rad/s.
    rate: V::Scalar,
    velocity: Option<V>,
}

impl<V: Signal> LowPassed<V> {
    /// A low pass of `cutoff`, Hz.
    ///
    /// # Errors
    /// `cutoff` not above 0 and finite, or too large for the scalar.
    pub fn new(cutoff: V::Scalar) -> Result<Self, ParameterError> {
        let cutoff = Requirement::Positive.check("filter cutoff", cutoff)?;
        let rate = V::Scalar::from_lanes(|lane| TAU * cutoff.lane(lane));
        Requirement::InRange.require("filter cutoff", cutoff, rate.finite())?;
        Ok(Self { rate, velocity: None })
    }
}

impl<V: Signal> VelocityEstimator<V> for LowPassed<V> {
    #[inline]
    fn velocity(&mut self, sample: &PortSample<V>) -> V {
        let none = V::Scalar::of(f64::NAN);
        let turn = self.rate * V::Scalar::choose(sample.timed(), sample.period, none);
        // Of more than the largest number nothing is left to keep.
        let most = V::Scalar::largest();
        let turn = V::Scalar::choose(turn.above(most), most, turn);
        let share = turn / (V::Scalar::of(1.0) + turn);
        let velocity = match self.velocity {
            Some(last) => last.zip(sample.displacement, |last, moved| {
                last + share * (moved / sample.period - last)
            }),
            None => V::zero(),
        };
        let last = self.velocity.unwrap_or(velocity);
        self.velocity =
            Some(velocity.zip(last, |now, last| V::Scalar::choose(now.finite(), now, last)));
        velocity
    }

    #[inline]
    fn restart(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        self.velocity = self.velocity.map(|last| V::choose(lanes, V::zero(), last));
    }
}

impl<V: Signal> Snapshot for LowPassed<V> {
    type State = Option<V>;

    fn state(&self) -> Option<V> {
        self.velocity
    }

    fn restored(self, velocity: Option<V>) -> Result<Self, ParameterError> {
        if let Some(velocity) = velocity {
            Requirement::Finite.check_axes("stored velocity", velocity)?;
        }
        Ok(Self { velocity, ..self })
    }
}
