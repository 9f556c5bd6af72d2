//! Measurement noise on positions.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
};

use super::retold::Retold;
use crate::{Random, Source};

/// A port whose positions carry white Gaussian noise, `xm(n) = x(n) + deviation · z(n)`.
///
/// `z` is standard normal and independent on every axis, in every lane and in every call ([`Random`]). The displacement
/// is the difference of the noisy positions, 0 at the first call, and the work that of the applied effort over this
/// displacement. The velocity stays as it is; take it from the noisy positions inside. The noise is the sensor's and
/// comes before the encoder: `port.encoded(r)?.noisy(deviation, seed)?`. A deviation of 0 changes no bit.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{OnePortExt, Spring};
/// let noisy = |seed| Spring::new(500.0)?.noisy(1e-4, move |_| seed); // m, standard deviation
/// let still = PortSample::starting(1e-3, 0.0_f64, 0.0);
/// let [one, again, other] = [noisy(1)?, noisy(1)?, noisy(2)?].map(|mut port| port.respond(&still));
/// assert!(one == again && one != other && one.abs() < 0.5); // 10 deviations
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Noise<P, V: Signal> {
    port: P,
    deviation: V::Scalar,
    random: Random<V::Scalar>,
    retold: Retold<V>,
}

lends_port!([P, V: Signal] Noise<P, V>);

impl<P, V: Signal> Noise<P, V> {
    pub(crate) fn new(
        port: P,
        deviation: V::Scalar,
        seed: impl Fn(usize) -> u64,
    ) -> Result<Self, ParameterError> {
        let deviation = Requirement::NonNegative.check("noise deviation", deviation)?;
        let random = Random::new(seed, Source::Noise);
        Ok(Self { port, deviation, random, retold: Retold::after(None) })
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Noise<P, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let noise = self.random.normal::<V>().scale(self.deviation);
        let noisy = self.retold.sample(sample, sample.position + noise);
        // A displacement need not equal the difference of rounded positions; without noise it stays as it is.
        let some = self.deviation.above(V::Scalar::of(0.0));
        self.port.respond(&PortSample {
            position: V::choose(some, noisy.position, sample.position),
            displacement: V::choose(some, noisy.displacement, sample.displacement),
            work: V::choose(some, noisy.work, sample.work),
            ..*sample
        })
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal> Snapshot for Noise<P, V> {
    /// The memory of the port inside, the calls of the random numbers, and the last position.
    type State = (P::State, u64, Option<V>);

    fn state(&self) -> Self::State {
        (self.port.state(), self.random.state(), self.retold.last())
    }

    fn restored(self, (port, calls, last): Self::State) -> Result<Self, ParameterError> {
        let random = self.random.restored(calls)?;
        Ok(Self { port: self.port.restored(port)?, random, retold: Retold::after(last), ..self })
    }
}
