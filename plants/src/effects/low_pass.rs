//! Velocity through a first-order low pass.

use core::f64::consts::TAU;

use lyapunov_core::{Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal};

/// A port whose velocities are taken from displacements through a low pass of first order:
/// `v(n) = v(n−1) + a (Δx(n) / T − v(n−1))`, `a = ω T / (1 + ω T)`, `ω = 2 π cutoff`, `v(0) = 0`.
///
/// It is the filter `ω / (s + ω)` by the backward Euler rule (Oppenheim and Schafer, Discrete-Time Signal Processing,
/// on filters from differences), stable at every rate. `T` is the sample's period. The larger the cutoff, the nearer to
/// the backward difference; an infinite one would be that, which is
/// [`OnePortExt::differenced`](crate::OnePortExt::differenced). Positions, displacements and work stay as they are.
///
/// A velocity that is not finite is passed on once and then forgotten, axis by axis.
#[derive(Clone, Copy, Debug)]
pub struct LowPass<P, V: Signal> {
    port: P,
    /// `ω`, rad/s.
    rate: V::Scalar,
    velocity: Option<V>,
}

impl<P, V: Signal> LowPass<P, V> {
    pub(crate) fn new(port: P, cutoff: V::Scalar) -> Result<Self, ParameterError> {
        let cutoff = Requirement::Positive.check("filter cutoff", cutoff)?;
        let rate = V::Scalar::from_lanes(|lane| TAU * cutoff.lane(lane));
        match (0..V::Scalar::LANES).find(|&lane| !rate.lane(lane).is_finite()) {
            Some(lane) => Err(ParameterError {
                parameter: "filter cutoff",
                value: cutoff.lane(lane),
                requirement: Requirement::InRange,
            }),
            None => Ok(Self { port, rate, velocity: None }),
        }
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for LowPass<P, V> {
    #[inline]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let turn = self.rate * sample.period;
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
        self.port.respond(&PortSample { velocity, ..*sample })
    }

    #[inline]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}
