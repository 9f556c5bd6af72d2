//! Delay by computation and transport, in whole ticks.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Signal, Snapshot,
};
use nalgebra::SVector;

/// A port whose effort acts a number of calls late; until the first arrives, no effort acts.
///
/// `f_act(n) = f(n − ticks)`, 0 for `n < ticks`. The number is a field, limited by the capacity `N` of the type.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{OnePortExt, Spring};
/// let mut late = Spring::new(500.0)?.delayed::<4>(2)?; // room for 4 ticks
/// let efforts = [0.01, 0.02, 0.03].map(|x: f64| late.respond(&PortSample::starting(1e-3, x, 0.0)));
/// assert_eq!(efforts, [0.0, 0.0, 5.0]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Delay<P, V, const N: usize> {
    port: P,
    ticks: usize,
    next: usize,
    waiting: [V; N],
}

lends_port!([P, V, const N: usize] Delay<P, V, N>);

impl<P, V: Signal, const N: usize> Delay<P, V, N> {
    pub(crate) fn new(port: P, ticks: u32) -> Result<Self, ParameterError> {
        Requirement::AtMost(N as f64).check("delay ticks", f64::from(ticks))?;
        Ok(Self { port, ticks: ticks as usize, next: 0, waiting: [V::zero(); N] })
    }
}

impl<V: Signal, P: OnePort<V>, const N: usize> OnePort<V> for Delay<P, V, N> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        let Some(slot) = self.waiting[..self.ticks].get_mut(self.next) else {
            return effort;
        };
        let next = self.next + 1;
        self.next = if next == self.ticks { 0 } else { next };
        core::mem::replace(slot, effort)
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal, const N: usize> Snapshot for Delay<P, V, N> {
    /// The memory of the port inside, the place of the oldest effort, and the efforts under way.
    type State = (P::State, usize, SVector<V, N>);

    fn state(&self) -> Self::State {
        (self.port.state(), self.next, SVector::from(self.waiting))
    }

    fn restored(self, (port, next, waiting): Self::State) -> Result<Self, ParameterError> {
        let last = self.ticks.saturating_sub(1);
        Requirement::AtMost(last as f64).check("stored delay ticks", next as f64)?;
        Ok(Self { port: self.port.restored(port)?, next, waiting: waiting.into(), ..self })
    }
}
