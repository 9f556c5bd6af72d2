//! What pushes a plant beside the effort at its port.

use lyapunov_core::{Drive, ParameterError, Plant, Signal};

use crate::{Course, Tethered};

/// A plant that something else pushes too: it moves under `effort − push(t_n)`, held over the tick.
///
/// The drive tells the effort and its own work only: the push is no part of the port. Several pushes nest.
/// A push of 0 changes nothing.
#[derive(Clone, Copy, Debug)]
pub struct Push<B, C> {
    body: B,
    course: C,
    tick: u64,
}

impl<B, C> Push<B, C> {
    pub(crate) fn new(body: B, course: C) -> Self {
        Self { body, course, tick: 0 }
    }
}

impl<B, C> Push<B, C> {
    #[inline]
    fn push<V: Signal>(&mut self) -> V
    where
        C: Course<V>,
    {
        let push = self.course.at(self.tick);
        self.tick = self.tick.wrapping_add(1);
        push
    }
}

/// Says that `effort` acted, and nothing beside it.
#[inline]
fn told<V: Signal>(drive: &mut Drive<V>, effort: V) {
    drive.acted = effort;
    drive.work = effort.times(drive.displacement);
}

impl<V: Signal, B: Plant<V>, C: Course<V>> Plant<V> for Push<B, C> {
    #[inline]
    fn start(&self) -> Drive<V> {
        self.body.start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> Drive<V> {
        let push: V = self.push();
        let mut drive = self.body.advance(effort - push);
        told(&mut drive, effort);
        drive
    }

    #[inline]
    fn advance_into(&mut self, effort: V, drive: &mut Drive<V>) {
        let push: V = self.push();
        self.body.advance_into(effort - push, drive);
        told(drive, effort);
    }
}

impl<V: Signal, B: Tethered<V>, C: Course<V>> Tethered<V> for Push<B, C> {
    type Parts = B::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.body.rest_at(rest);
    }

    fn reshape(&mut self, parts: B::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)
    }
}
