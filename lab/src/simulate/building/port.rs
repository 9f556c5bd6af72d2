//! Port whose parts are chosen at run time.

use std::fmt;

use lyapunov::{Correction, OnePort, PortSample, Signal};

/// Any one-port, boxed: a scene file builds it out of the adaptors that a program chains by type.
pub struct Port<V: Signal>(Box<dyn OnePort<V>>);

impl<V: Signal> Port<V> {
    /// Boxes `port`.
    pub fn new(port: impl OnePort<V> + 'static) -> Self {
        Self(Box::new(port))
    }
}

impl<V: Signal> fmt::Debug for Port<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Port").finish_non_exhaustive()
    }
}

impl<V: Signal> OnePort<V> for Port<V> {
    #[inline]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        self.0.respond(sample)
    }

    fn correction(&self) -> Correction<V> {
        self.0.correction()
    }
}
