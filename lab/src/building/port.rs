//! A port whose parts are chosen at run time.

use std::cell::Cell;
use std::fmt;
use std::rc::Rc;

use lyapunov::{Action, Drive, OnePort, Signal};

/// Any one-port, boxed: what a scene file builds, out of the adaptors that a program chains by type.
pub struct Port<V: Signal>(Box<dyn OnePort<V>>);

impl<V: Signal> Port<V> {
    /// Boxes `port`.
    pub fn new(port: impl OnePort<V> + 'static) -> Self {
        Self(Box::new(port))
    }

    /// The same port, telling `seen` what passes it.
    pub(crate) fn tapped(self, seen: &Tap<V>) -> Self {
        Self::new(Tapped { port: self, seen: Rc::clone(seen) })
    }
}

impl<V: Signal> fmt::Debug for Port<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Port").finish_non_exhaustive()
    }
}

impl<V: Signal> OnePort<V> for Port<V> {
    #[inline]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        self.0.respond(drive)
    }

    fn action(&self) -> Action<V> {
        self.0.action()
    }
}

/// Where a tapped port writes down the last drive and effort that passed it.
pub(crate) type Tap<V> = Rc<Cell<Option<(Drive<V>, V)>>>;

/// Where a body writes down its operator's position and velocity.
pub(crate) type Operator<V> = Rc<Cell<Option<(V, V)>>>;

struct Tapped<V: Signal> {
    port: Port<V>,
    seen: Tap<V>,
}

impl<V: Signal> OnePort<V> for Tapped<V> {
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let effort = self.port.respond(drive);
        self.seen.set(Some((*drive, effort)));
        effort
    }

    fn action(&self) -> Action<V> {
        self.port.action()
    }
}
