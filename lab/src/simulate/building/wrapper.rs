//! Port around the environment, chosen at run time.

use std::fmt;

use lyapunov::{Correction, OnePort, ParameterError, PortSample, Signal, Stabilizer};

use super::on::On;
use super::{Port, Seen, Space};
use crate::files::scene::Pace;
use crate::simulate::instructions::Instructions;

/// Any port around an environment, still without it.
pub struct AnyWrapper<V: Signal> {
    pace: Pace,
    bytes: usize,
    wrap: Box<Wrap<V>>,
}

/// The port around an environment.
type Wrap<V> = dyn Fn(Port<V>) -> Result<Port<V>, ParameterError>;

impl<V: Space> AnyWrapper<V> {
    /// Boxes `wrap`, whose ports run on `instructions`.
    pub(super) fn new<P: OnePort<V> + 'static>(
        pace: Pace,
        wrap: impl Fn(Port<V>) -> Result<P, ParameterError> + 'static,
        instructions: Instructions,
    ) -> Self {
        let bytes = size_of::<P>() - size_of::<Port<V>>();
        let boxed = move |port| Ok(Port::new(On::new(wrap(port)?, instructions)));
        Self { pace, bytes, wrap: Box::new(boxed) }
    }
}

impl<V: Signal> AnyWrapper<V> {
    /// The rate that it runs at.
    pub(super) fn pace(&self) -> Pace {
        self.pace
    }

    /// Bytes that it keeps from tick to tick, parameters included and without the environment.
    pub fn state_bytes(&self) -> usize {
        self.bytes
    }
}

impl<V: Space> AnyWrapper<V> {
    /// The same wrapper with a port of its own on each side: `inside`, around the environment, and `outside`, which is
    /// called instead of the wrapper.
    pub(crate) fn between(
        self,
        inside: impl Fn(Port<V>) -> Port<V> + 'static,
        outside: impl Fn(Port<V>) -> Port<V> + 'static,
    ) -> Self {
        let Self { pace, bytes, wrap } = self;
        let wrap = move |port| Ok(outside(wrap(inside(port))?));
        Self { pace, bytes, wrap: Box::new(wrap) }
    }

    /// The wrapper around `environment`, whose answers `seen` records, called every `period` s.
    pub(super) fn around(
        &self,
        environment: Port<V>,
        period: V::Scalar,
        seen: Option<&Seen<V>>,
    ) -> Result<Port<V>, ParameterError> {
        let environment = match seen {
            None => environment,
            Some(seen) => Port::new(seen.environment(environment)),
        };
        Ok(Port::new(Paced { port: (self.wrap)(environment)?, period }))
    }

    /// Runs the wrapper over `samples` in order; the environment answers with the recorded efforts.
    pub(super) fn replay(
        &self,
        samples: &[(PortSample<V>, V)],
        corrections: &mut [Correction<V>],
    ) -> Result<(), ParameterError> {
        let efforts: Vec<V> = samples.iter().map(|(_, effort)| *effort).collect();
        let mut port = (self.wrap)(Port::new(Recorded { efforts, next: 0 }))?;
        for ((sample, _), correction) in samples.iter().zip(corrections) {
            correction.effort = port.respond(sample);
        }
        Ok(())
    }
}

impl<V: Signal> fmt::Debug for AnyWrapper<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyWrapper").field("pace", &self.pace).finish_non_exhaustive()
    }
}

/// Stabilizer behind a port that stabilizes by itself: what is not finite is rejected, and the rest passes.
pub(super) struct Passing;

impl<V: Signal> Stabilizer<V> for Passing {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let sound = sample.finite();
        let effort = V::choose(sound, effort, V::zero());
        Correction { accepted: sound, ..Correction::none(effort) }.checked()
    }
}

/// Port whose samples span its own period, also the first, before which nothing was.
struct Paced<P, V: Signal> {
    port: P,
    period: V::Scalar,
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Paced<P, V> {
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        self.port.respond(&PortSample { period: self.period, ..*sample })
    }

    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

/// Environment that gives recorded efforts.
struct Recorded<V> {
    efforts: Vec<V>,
    next: usize,
}

impl<V: Signal> OnePort<V> for Recorded<V> {
    fn respond(&mut self, _sample: &PortSample<V>) -> V {
        let effort = self.efforts.get(self.next).copied().unwrap_or_else(V::zero);
        self.next += 1;
        effort
    }
}
