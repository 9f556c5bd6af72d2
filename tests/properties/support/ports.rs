//! Ports that tests put inside of others.

use lyapunov::{Correction, OnePort, PortSample, Scalar, Signal};

/// A port that answers like the port it owns and records the samples it received.
#[derive(Clone, Debug)]
pub(crate) struct Spy<P, V: Signal> {
    port: P,
    pub(crate) asked: Vec<PortSample<V>>,
}

impl<P, V: Signal> Spy<P, V> {
    pub(crate) fn on(port: P) -> Self {
        Self { port, asked: Vec::new() }
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Spy<P, V> {
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        self.asked.push(*sample);
        self.port.respond(sample)
    }

    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

/// A port that answers with the given efforts one after the other, then with 0.
#[derive(Clone, Debug)]
pub(crate) struct Scripted<V> {
    efforts: Vec<V>,
    next: usize,
}

impl<V> Scripted<V> {
    pub(crate) fn of(efforts: Vec<V>) -> Self {
        Self { efforts, next: 0 }
    }
}

impl<V: Signal> OnePort<V> for Scripted<V> {
    fn respond(&mut self, _drive: &PortSample<V>) -> V {
        self.next += 1;
        self.efforts.get(self.next - 1).copied().unwrap_or_else(V::zero)
    }
}

/// A port that answers with NaN on the calls from `from` to before `until`, counted in each lane by itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Faulty<P, T> {
    port: P,
    from: T,
    until: T,
    calls: T,
}

impl<P, T: Scalar> Faulty<P, T> {
    pub(crate) fn between(port: P, from: T, until: T) -> Self {
        Self { port, from, until, calls: T::of(0.0) }
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Faulty<P, V::Scalar> {
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        let now = !self.calls.below(self.from) & self.calls.below(self.until);
        self.calls += V::Scalar::of(1.0);
        V::choose(now, V::splat(V::Scalar::of(f64::NAN)), effort)
    }

    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}
