//! External force on a plant, beside the effort at its port.

use lyapunov_core::{ParameterError, Plant, PortSample, Signal};

use crate::{OperatedBody, Trajectory};

/// A plant under an external force: it moves under `effort − push(t_n)`, held over the tick.
///
/// The sample reports only the effort and its work: the external force is no part of the port. Several of them nest. A
/// force of 0 changes nothing.
#[derive(Clone, Copy, Debug)]
pub struct ExternalForce<B, C> {
    body: B,
    trajectory: C,
    tick: u64,
}

impl<B, C> ExternalForce<B, C> {
    pub(crate) fn new(body: B, trajectory: C) -> Self {
        Self { body, trajectory, tick: 0 }
    }

    #[inline]
    fn push<V: Signal>(&mut self) -> V
    where
        C: Trajectory<V>,
    {
        let push = self.trajectory.at(self.tick);
        self.tick = self.tick.wrapping_add(1);
        push
    }
}

/// Makes `sample` report `effort` and its work alone.
#[inline]
fn told<V: Signal>(sample: &mut PortSample<V>, effort: V) {
    sample.applied = effort;
    sample.work = effort.times(sample.displacement);
}

impl<V: Signal, B: Plant<V>, C: Trajectory<V>> Plant<V> for ExternalForce<B, C> {
    #[inline]
    fn start(&self) -> PortSample<V> {
        self.body.start()
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let push: V = self.push();
        let mut sample = self.body.advance(effort - push);
        told(&mut sample, effort);
        sample
    }

    #[inline(always)]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        let push: V = self.push();
        self.body.advance_into(effort - push, sample);
        told(sample, effort);
    }
}

impl<V: Signal, B: OperatedBody<V>, C: Trajectory<V>> OperatedBody<V> for ExternalForce<B, C> {
    type Parts = B::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.body.rest_at(rest);
    }

    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)
    }
}
