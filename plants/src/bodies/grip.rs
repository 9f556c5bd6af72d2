//! Changing grip of the operator.

use lyapunov_core::{ParameterError, Plant, PortSample, Requirement, Scalar, Signal};

use crate::OperatedBody;

/// A body whose parts change at given ticks; before the first it has its own.
///
/// `R` is the table: an array, a slice or whatever owns one, of ticks that never decrease and the parts from each on.
/// Of rows with the same tick the last counts. Position, velocity and rest stay; a spring that becomes stiffer brings
/// the energy `(k' − k) (x − rest)² / 2` with it. Rows with the body's own parts change nothing.
#[derive(Clone, Copy, Debug)]
pub struct Grip<B, R, T> {
    body: B,
    table: R,
    period: T,
    next: usize,
    tick: u64,
}

impl<B, R, T: Scalar> Grip<B, R, T> {
    pub(crate) fn new<V>(mut body: B, own: B::Parts, table: R) -> Result<Self, ParameterError>
    where
        V: Signal<Scalar = T>,
        B: OperatedBody<V>,
        R: AsRef<[(u64, B::Parts)]>,
    {
        let period = body.start().period;
        let mut earlier = 0;
        for &(tick, parts) in table.as_ref() {
            Requirement::AtLeast(earlier as f64).check("tick", tick as f64)?;
            body.reshape(parts, period)?;
            earlier = tick;
        }
        body.reshape(own, period)?;
        Ok(Self { body, table, period, next: 0, tick: 0 })
    }

    #[inline]
    fn take_hold<V: Signal<Scalar = T>>(&mut self)
    where
        B: OperatedBody<V>,
        R: AsRef<[(u64, B::Parts)]>,
    {
        while let Some(&(tick, parts)) = self.table.as_ref().get(self.next)
            && tick <= self.tick
        {
            // Checked at construction; of a table that has changed since, a wrong row is skipped.
            let _ = self.body.reshape(parts, self.period);
            self.next += 1;
        }
        self.tick = self.tick.wrapping_add(1);
    }
}

impl<V, B, R> Plant<V> for Grip<B, R, V::Scalar>
where
    V: Signal,
    B: OperatedBody<V>,
    R: AsRef<[(u64, B::Parts)]>,
{
    #[inline]
    fn start(&self) -> PortSample<V> {
        self.body.start()
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        self.take_hold();
        self.body.advance(effort)
    }

    #[inline(always)]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        self.take_hold();
        self.body.advance_into(effort, sample);
    }
}

impl<V, B, R> OperatedBody<V> for Grip<B, R, V::Scalar>
where
    V: Signal,
    B: OperatedBody<V>,
    R: AsRef<[(u64, B::Parts)]>,
{
    type Parts = B::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.body.rest_at(rest);
    }

    /// The table overrides: its next row replaces `parts`, but keeps `interval`.
    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)?;
        self.period = interval;
        Ok(())
    }
}
