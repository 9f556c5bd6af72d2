//! Jitter of the sampling instants.

use lyapunov_core::{ParameterError, Plant, PortSample, Requirement, Scalar, Signal};

use crate::OperatedBody;

/// A body that moves for `max(0, T + deviation g)` instead of `T`, with a standard normal number `g` from `normal` for
/// each tick, while the sample reports `T`.
///
/// A velocity taken from the displacement divides by `T` and errs by the jitter. Position, displacement and the held
/// effort's work are the true ones. A deviation of 0 changes nothing.
#[derive(Clone, Copy, Debug)]
pub struct Jitter<B, P, T, G> {
    body: B,
    parts: P,
    period: T,
    deviation: T,
    normal: G,
}

impl<B, P, T, G> Jitter<B, P, T, G> {
    pub(crate) fn new<V>(
        mut body: B,
        parts: P,
        deviation: T,
        normal: G,
    ) -> Result<Self, ParameterError>
    where
        V: Signal<Scalar = T>,
        B: OperatedBody<V, Parts = P>,
        P: Copy,
        T: Scalar,
    {
        let deviation = Requirement::NonNegative.check("deviation", deviation)?;
        let period = body.start().period;
        body.reshape(parts, period)?;
        Ok(Self { body, parts, period, deviation, normal })
    }
}

impl<V, B, G> Plant<V> for Jitter<B, B::Parts, V::Scalar, G>
where
    V: Signal,
    B: OperatedBody<V>,
    G: FnMut() -> V::Scalar,
{
    #[inline]
    fn start(&self) -> PortSample<V> {
        PortSample { period: self.period, ..self.body.start() }
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let interval = self.period + self.deviation * (self.normal)();
        // If the interval is so long that the motion leaves the scalar's range, the body keeps the one before.
        let _ = self.body.reshape(self.parts, interval.larger(V::Scalar::of(0.0)));
        PortSample { period: self.period, ..self.body.advance(effort) }
    }
}

impl<V, B, G> OperatedBody<V> for Jitter<B, B::Parts, V::Scalar, G>
where
    V: Signal,
    B: OperatedBody<V>,
    G: FnMut() -> V::Scalar,
{
    type Parts = B::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.body.rest_at(rest);
    }

    #[inline(always)]
    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)?;
        (self.parts, self.period) = (parts, interval);
        Ok(())
    }
}
