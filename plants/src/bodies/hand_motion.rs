//! Motion of the operator's hand.

use lyapunov_core::{ParameterError, Plant, PortSample, Signal};

use crate::{OperatedBody, Trajectory};

/// A body whose operator's spring rests at `rest(t_n)`, held over the tick.
///
/// The rest jumps between two ticks, and the spring with it: each jump does the work
/// `k_h ((x − rest(t_n))² − (x − rest(t_n−1))²) / 2`. A trajectory that stays at the body's own rest changes nothing.
#[derive(Clone, Copy, Debug)]
pub struct HandMotion<B, C> {
    body: B,
    trajectory: C,
    tick: u64,
}

impl<B, C> HandMotion<B, C> {
    pub(crate) fn new(body: B, trajectory: C) -> Self {
        Self { body, trajectory, tick: 0 }
    }

    #[inline]
    fn lead<V: Signal>(&mut self)
    where
        B: OperatedBody<V>,
        C: Trajectory<V>,
    {
        self.body.rest_at(self.trajectory.at(self.tick));
        self.tick = self.tick.wrapping_add(1);
    }
}

impl<V: Signal, B: OperatedBody<V>, C: Trajectory<V>> Plant<V> for HandMotion<B, C> {
    #[inline]
    fn start(&self) -> PortSample<V> {
        self.body.start()
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        self.lead();
        self.body.advance(effort)
    }

    #[inline(always)]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        self.lead();
        self.body.advance_into(effort, sample);
    }
}

impl<V: Signal, B: OperatedBody<V>, C: Trajectory<V>> OperatedBody<V> for HandMotion<B, C> {
    type Parts = B::Parts;

    /// The trajectory overrides: it sets the rest again before the next period.
    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.body.rest_at(rest);
    }

    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)
    }
}
