//! A slow environment behind a fast port.

use lyapunov_core::{Action, Drive, OnePort, ParameterError, Requirement, Signal};

/// A port that is asked on every `ticks`-th call only, from the first on; its effort is held in between.
///
/// The port inside is handed the sums of what happened meanwhile, so that its work stays exact, on each axis.
#[derive(Clone, Copy, Debug)]
pub struct Hold<P, V: Signal> {
    port: P,
    ticks: u32,
    left: u32,
    missed: Option<Drive<V>>,
    effort: V,
}

impl<P, V: Signal> Hold<P, V> {
    pub(crate) fn new(port: P, ticks: u32) -> Result<Self, ParameterError> {
        Requirement::Positive.check("hold ticks", f64::from(ticks))?;
        Ok(Self { port, ticks, left: 0, missed: None, effort: V::zero() })
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Hold<P, V> {
    #[inline]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let whole = match self.missed.take() {
            Some(earlier) => drive.spanning(&earlier),
            None => *drive,
        };
        if self.left == 0 {
            self.left = self.ticks;
            self.effort = self.port.respond(&whole);
        } else {
            self.missed = Some(whole);
        }
        self.left -= 1;
        self.effort
    }

    #[inline]
    fn action(&self) -> Action<V> {
        self.port.action()
    }
}
