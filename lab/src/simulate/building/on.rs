//! Part of a loop on vector instructions.

use std::marker::PhantomData;

use lyapunov::{
    Correction, OnePort, ParameterError, Plant, PortSample, Scalar, Signal, Stabilizer,
    bodies::OperatedBody,
};
use pulp::NullaryFnOnce;

use super::Space;
use crate::simulate::instructions::Instructions;

/// A part of a loop whose methods of a tick run on some instructions: a box of lanes is entered once for all of them.
///
/// A call through a table is compiled for the base set, so each box turns to its instructions again.
pub(super) struct On<P> {
    part: P,
    instructions: Instructions,
}

impl<P> On<P> {
    pub(super) fn new(part: P, instructions: Instructions) -> Self {
        Self { part, instructions }
    }

    /// The part itself.
    pub(super) fn into_part(self) -> P {
        self.part
    }
}

struct Respond<'a, P, V: Signal> {
    port: &'a mut P,
    sample: &'a PortSample<V>,
}

impl<V: Signal, P: OnePort<V>> NullaryFnOnce for Respond<'_, P, V> {
    type Output = V;

    #[inline(always)]
    fn call(self) -> V {
        self.port.respond(self.sample)
    }
}

impl<V: Space, P: OnePort<V>> OnePort<V> for On<P> {
    #[inline]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        V::run(self.instructions, Respond { port: &mut self.part, sample })
    }

    #[inline]
    fn correction(&self) -> Correction<V> {
        self.part.correction()
    }
}

struct Advance<'a, P, V: Signal> {
    plant: &'a mut P,
    effort: V,
    sample: &'a mut PortSample<V>,
}

impl<V: Signal, P: Plant<V>> NullaryFnOnce for Advance<'_, P, V> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.plant.advance_into(self.effort, self.sample);
    }
}

impl<V: Space, P: Plant<V>> Plant<V> for On<P> {
    fn start(&self) -> PortSample<V> {
        self.part.start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let mut sample = PortSample::starting(V::Scalar::of(0.0), V::zero(), V::zero());
        self.advance_into(effort, &mut sample);
        sample
    }

    // Never inlined: `advance` calls it too and lies in every table of methods, so the plant would be compiled a second time for a
    // method that no run calls.
    #[inline(never)]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        V::run(self.instructions, Advance { plant: &mut self.part, effort, sample });
    }
}

struct Reshape<'a, B, P, T> {
    body: &'a mut B,
    parts: P,
    interval: T,
}

impl<V: Space, B: OperatedBody<V>> NullaryFnOnce
    for Reshape<'_, On<B>, Parts<B::Parts, V>, V::Scalar>
{
    type Output = Result<(), ParameterError>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        self.body.part.reshape(self.parts.0, self.interval)
    }
}

/// Parts of a body that moves a `V`.
struct Parts<P, V>(P, PhantomData<V>);

impl<V: Space, B: OperatedBody<V>> OperatedBody<V> for On<B> {
    type Parts = B::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.part.rest_at(rest);
    }

    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        let instructions = self.instructions;
        V::run(instructions, Reshape { body: self, parts: Parts(parts, PhantomData), interval })
    }
}

struct Stabilize<'a, S, V: Signal> {
    stabilizer: &'a mut S,
    sample: &'a PortSample<V>,
    effort: V,
}

impl<V: Signal, S: Stabilizer<V>> NullaryFnOnce for Stabilize<'_, S, V> {
    type Output = Correction<V>;

    #[inline(always)]
    fn call(self) -> Correction<V> {
        self.stabilizer.stabilize(self.sample, self.effort)
    }
}

impl<V: Space, S: Stabilizer<V>> Stabilizer<V> for On<S> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        V::run(self.instructions, Stabilize { stabilizer: &mut self.part, sample, effort })
    }
}
