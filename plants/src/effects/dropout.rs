//! Loss of answers.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Signal, Snapshot,
};

use crate::{Fallback, Random, Source};

/// A port that loses each of its answers with a given probability, independently of the others.
///
/// In place of a lost answer acts the last one that arrived, 0 before the first ([`Fallback::Hold`]), or nothing
/// ([`Fallback::Zero`]). The port inside is asked every time and only its answer is lost, as with an environment on
/// another computer, so the loss stands between the environment and its hold,
/// `wall.dropped(0.1, Fallback::Hold, |_| 7)?.held(10)?`. All axes of an answer are lost together. Each call draws one
/// number per lane ([`Random`]), lost or not. A probability of 0 changes no bit. A NaN is an answer like any other.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{Fallback, OnePortExt, Spring};
/// let mut lost = Spring::new(500.0)?.dropped(1.0, Fallback::Zero, |_| 7)?; // every answer
/// assert_eq!(lost.respond(&PortSample::starting(1e-3, 0.01_f64, 0.0)), 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dropout<P, V: Signal> {
    port: P,
    probability: V::Scalar,
    fallback: Fallback,
    random: Random<V::Scalar>,
    arrived: V,
}

lends_port!([P, V: Signal] Dropout<P, V>);

impl<P, V: Signal> Dropout<P, V> {
    pub(crate) fn new(
        port: P,
        probability: V::Scalar,
        fallback: Fallback,
        seed: impl Fn(usize) -> u64,
    ) -> Result<Self, ParameterError> {
        Requirement::NonNegative.check("dropout probability", probability)?;
        Requirement::AtMost(1.0).check("dropout probability", probability)?;
        let random = Random::new(seed, Source::Dropout);
        Ok(Self { port, probability, fallback, random, arrived: V::zero() })
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Dropout<P, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let answer = self.port.respond(sample);
        let lost = self.random.chance(self.probability);
        self.arrived = V::choose(lost, self.fallback.after(self.arrived), answer);
        self.arrived
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal> Snapshot for Dropout<P, V> {
    /// The memory of the port inside, the calls of the random numbers, and the last answer.
    type State = (P::State, u64, V);

    fn state(&self) -> Self::State {
        (self.port.state(), self.random.state(), self.arrived)
    }

    fn restored(self, (port, calls, arrived): Self::State) -> Result<Self, ParameterError> {
        let random = self.random.restored(calls)?;
        Ok(Self { port: self.port.restored(port)?, random, arrived, ..self })
    }
}
