//! Jitter of the sampling instants.

use lyapunov_core::{ParameterError, Plant, PortSample, Requirement, Scalar, Signal};

use crate::OperatedBody;

/// A body that moves for `max(0, T + deviation g)` instead of `T`, with a standard normal number `g` from `normal` for
/// each tick, while the sample reports `T`.
///
/// A velocity taken from the displacement divides by `T` and errs by the jitter. Position, displacement and the held
/// effort's work are the true ones. A deviation of 0 changes nothing. Where an interval is so long that the motion would
/// leave the scalar's range, the body keeps the one before, each lane by itself.
#[derive(Clone, Copy, Debug)]
pub struct Jitter<B, P, T, G> {
    body: B,
    parts: P,
    period: T,
    deviation: T,
    normal: G,
    /// The interval of the last tick.
    interval: T,
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
        Ok(Self { body, parts, period, deviation, normal, interval: period })
    }

    /// Takes `interval` in those lanes in which the motion stays in the scalar's range; the others keep the one before.
    #[cold]
    fn stretch_each<V>(&mut self, interval: T)
    where
        V: Signal<Scalar = T>,
        B: OperatedBody<V, Parts = P>,
        P: Copy,
        T: Scalar,
    {
        for lane in 0..T::LANES {
            let kept = self.interval;
            let of = |at: usize| if at == lane { interval } else { kept };
            let tried = T::from_reals(|at| of(at).real(at));
            if self.body.reshape(self.parts, tried).is_ok() {
                self.interval = tried;
            }
        }
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
        let drawn = self.period + self.deviation * (self.normal)();
        let interval = drawn.larger(V::Scalar::of(0.0));
        match self.body.reshape(self.parts, interval) {
            Ok(()) => self.interval = interval,
            Err(_) => self.stretch_each(interval),
        }
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
        (self.parts, self.period, self.interval) = (parts, interval, interval);
        Ok(())
    }
}
