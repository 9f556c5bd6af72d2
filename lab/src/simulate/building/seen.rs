//! Recorders inside a loop.

use std::cell::Cell;
use std::rc::Rc;

use lyapunov::{Correction, OnePort, PortSample, Scalar, Signal, Stabilizer};

use crate::simulate::tick::{OperatorMotion, Tick};

/// Records of what the parts of a loop do and a rollout's tick cannot see from outside.
#[derive(Debug)]
pub struct Seen<V: Signal> {
    stabilizer: Rc<Sight<V>>,
    /// The environment's own effort, where a port around it changes that.
    environment: Rc<Cell<Option<V>>>,
    command: Rc<Cell<Option<V>>>,
    pub(super) operator: Operator<V>,
}

/// Record of the operator's motion, written by the body.
pub(crate) type Operator<V> = Rc<Cell<Option<OperatorMotion<V>>>>;

/// The sample and effort that a stabilizer got, and its correction; each in a cell, as it comes.
#[derive(Debug)]
struct Sight<V: Signal> {
    measured: Cell<PortSample<V>>,
    environment: Cell<V>,
    correction: Cell<Correction<V>>,
}

impl<V: Signal> Default for Seen<V> {
    fn default() -> Self {
        let (zero, none) = (V::zero(), V::Scalar::of(0.0));
        Self {
            stabilizer: Rc::new(Sight {
                measured: Cell::new(PortSample::starting(none, zero, zero)),
                environment: Cell::new(zero),
                correction: Cell::new(Correction::none(zero)),
            }),
            environment: Rc::default(),
            command: Rc::default(),
            operator: Operator::default(),
        }
    }
}

impl<V: Signal> Seen<V> {
    /// The tick whose sample the port just answered, before the plant moves on.
    #[inline(always)]
    pub(crate) fn tick(&self, time: f64, truth: PortSample<V>, applied: V) -> Tick<V> {
        let Sight { measured, environment, correction } = &*self.stabilizer;
        let (measured, correction) = (measured.get(), correction.get());
        let environment = self.environment.get().unwrap_or_else(|| environment.get());
        let command = self.command.get().unwrap_or_else(V::zero);
        let operator = self.operator.get();
        Tick { time, truth, measured, environment, correction, command, applied, operator }
    }

    /// `stabilizer`, recording its sample and its correction.
    pub(super) fn stabilizer<S>(&self, stabilizer: S) -> Recorded<S, V> {
        Recorded { stabilizer, seen: Rc::clone(&self.stabilizer) }
    }

    /// `port`, an environment inside a port that changes its efforts, recording them.
    pub(super) fn environment<P>(&self, port: P) -> Heard<P, V> {
        Heard { port, seen: Rc::clone(&self.environment) }
    }

    /// `port`, recording its efforts.
    pub(super) fn command<P>(&self, port: P) -> Heard<P, V> {
        Heard { port, seen: Rc::clone(&self.command) }
    }
}

/// Stabilizer that is recorded where it stands.
pub(super) struct Recorded<S, V: Signal> {
    stabilizer: S,
    seen: Rc<Sight<V>>,
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Recorded<S, V> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let correction = self.stabilizer.stabilize(sample, effort);
        self.seen.measured.set(*sample);
        self.seen.environment.set(effort);
        self.seen.correction.set(correction);
        correction
    }
}

/// Port whose efforts are recorded.
pub(super) struct Heard<P, V> {
    port: P,
    seen: Rc<Cell<Option<V>>>,
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Heard<P, V> {
    #[inline]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        self.seen.set(Some(effort));
        effort
    }

    #[inline]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

#[cfg(test)]
mod tests {
    use lyapunov::laws::{self, Samples};

    use super::*;
    use crate::simulate::building::Port;

    #[test]
    fn the_lab_s_adaptors_pass_the_correction_on() {
        let samples = Samples::<f64>::new(1e-3);
        laws::adaptor(Port::new, samples).unwrap();
        laws::adaptor(|port| Seen::default().command(port), samples).unwrap();
        laws::adaptor(|port| Seen::default().environment(port), samples).unwrap();
    }
}
