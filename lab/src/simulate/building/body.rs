//! Body on an operator's spring, chosen at run time.

use std::fmt;

use lyapunov::{
    ParameterError, Plant, PortSample, Scalar, Signal,
    bodies::{Friction, IntegratedPlant, OperatedBody, TwoMassBody},
    integrators::{CoupledOscillators, Integrator, State},
};

use super::AnyPlant;
use super::seen::Operator;
use crate::simulate::tick::OperatorMotion;

/// Tethered body of any kind made of parts `P`, boxed.
pub(super) struct AnyBody<V: Signal, P>(Box<dyn OperatedBody<V, Parts = P>>);

impl<V: Signal, P: Copy + 'static> AnyBody<V, P> {
    pub(super) fn new(body: impl OperatedBody<V, Parts = P> + 'static) -> Self {
        Self(Box::new(body))
    }

    /// The body as a plant, without its parts.
    pub(super) fn into_plant(self) -> AnyPlant<V> {
        AnyPlant::boxed(self.0)
    }
}

impl<V: Signal, P> fmt::Debug for AnyBody<V, P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyBody").finish_non_exhaustive()
    }
}

impl<V: Signal, P: Copy + 'static> Plant<V> for AnyBody<V, P> {
    fn start(&self) -> PortSample<V> {
        self.0.start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        self.0.advance(effort)
    }

    #[inline]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        self.0.advance_into(effort, sample);
    }
}

impl<V: Signal, P: Copy + 'static> OperatedBody<V> for AnyBody<V, P> {
    type Parts = P;

    fn rest_at(&mut self, rest: V) {
        self.0.rest_at(rest);
    }

    fn reshape(&mut self, parts: P, interval: V::Scalar) -> Result<(), ParameterError> {
        self.0.reshape(parts, interval)
    }
}

/// Body whose operator moves apart from its device.
pub(super) trait Operated<V> {
    /// The motion of the operator.
    fn operator(&self) -> OperatorMotion<V>;
}

impl<V: Signal> Operated<V> for TwoMassBody<V> {
    fn operator(&self) -> OperatorMotion<V> {
        let (position, velocity) = TwoMassBody::operator(self);
        OperatorMotion { position, velocity }
    }
}

impl<V, I> Operated<V> for IntegratedPlant<V, CoupledOscillators<V::Scalar>, I>
where
    V: Signal,
    I: Integrator<V, CoupledOscillators<V::Scalar>>,
{
    fn operator(&self) -> OperatorMotion<V> {
        let State { position, velocity } = self.state();
        OperatorMotion {
            position: position.device + position.stretch,
            velocity: velocity.device + velocity.stretch,
        }
    }
}

impl<T: Scalar> Operated<T> for Friction<TwoMassBody<T>, T, 4> {
    fn operator(&self) -> OperatorMotion<T> {
        Operated::operator(self.body())
    }
}

/// Body that records its operator's motion.
#[derive(Clone, Debug)]
pub(super) struct Watched<B, V: Signal> {
    body: B,
    seen: Operator<V>,
}

impl<V: Signal, B: OperatedBody<V> + Operated<V>> Watched<B, V> {
    pub(super) fn new(body: B, seen: &Operator<V>) -> Self {
        seen.set(Some(body.operator()));
        Self { body, seen: Operator::clone(seen) }
    }
}

impl<V: Signal, B: OperatedBody<V> + Operated<V>> Plant<V> for Watched<B, V> {
    fn start(&self) -> PortSample<V> {
        self.body.start()
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let sample = self.body.advance(effort);
        self.seen.set(Some(self.body.operator()));
        sample
    }
}

impl<V: Signal, B: OperatedBody<V> + Operated<V>> OperatedBody<V> for Watched<B, V> {
    type Parts = B::Parts;

    #[inline(always)]
    fn rest_at(&mut self, rest: V) {
        self.body.rest_at(rest);
    }

    #[inline(always)]
    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)
    }
}
