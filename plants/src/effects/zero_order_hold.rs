//! Zero-order hold of a slow environment.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
};

/// A port that is asked only on every `ticks`-th call, starting with the first; its effort is held in between.
///
/// The port inside receives the sums over the calls that it missed, so its work stays exact, on each axis.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{OnePortExt, Spring};
/// let mut slow = Spring::new(500.0)?.held(2)?; // asked on every second tick
/// let efforts = [0.01, 0.02, 0.03].map(|x: f64| slow.respond(&PortSample::starting(1e-3, x, 0.0)));
/// assert_eq!(efforts, [5.0, 5.0, 15.0]);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ZeroOrderHold<P, V: Signal> {
    port: P,
    ticks: u32,
    left: u32,
    missed: Missed<V>,
    effort: V,
}

lends_port!([P, V: Signal] ZeroOrderHold<P, V>);

/// Sums that the port inside has not received yet.
#[derive(Clone, Copy, Debug)]
struct Missed<V: Signal> {
    period: V::Scalar,
    displacement: V,
    work: V,
}

impl<V: Signal> Missed<V> {
    #[inline(always)]
    fn nothing() -> Self {
        // −0 is the number whose addition changes no bit.
        let nothing = -V::Scalar::of(0.0);
        Self { period: nothing, displacement: V::splat(nothing), work: V::splat(nothing) }
    }
}

impl<P, V: Signal> ZeroOrderHold<P, V> {
    pub(crate) fn new(port: P, ticks: u32) -> Result<Self, ParameterError> {
        Requirement::AtLeast(1.0).check("hold ticks", f64::from(ticks))?;
        Ok(Self { port, ticks, left: 0, missed: Missed::nothing(), effort: V::zero() })
    }

    /// The held effort, N.
    #[inline(always)]
    pub fn effort(&self) -> V {
        self.effort
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for ZeroOrderHold<P, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let period = self.missed.period + sample.period;
        let displacement = self.missed.displacement + sample.displacement;
        let work = self.missed.work + sample.work;
        self.missed = Missed { period, displacement, work };
        if self.left == 0 {
            self.left = self.ticks;
            self.missed = Missed::nothing();
            self.effort = self.port.respond(&PortSample { period, displacement, work, ..*sample });
        }
        self.left -= 1;
        self.effort
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal> Snapshot for ZeroOrderHold<P, V> {
    /// The memory of the port inside, the ticks that are left, period, displacement and work since it was asked, and
    /// the held effort. What was missed may be NaN.
    type State = (P::State, u32, (V::Scalar, V, V), V);

    fn state(&self) -> Self::State {
        let Missed { period, displacement, work } = self.missed;
        (self.port.state(), self.left, (period, displacement, work), self.effort)
    }

    fn restored(
        self,
        (port, left, (period, displacement, work), effort): Self::State,
    ) -> Result<Self, ParameterError> {
        Requirement::AtMost(f64::from(self.ticks - 1))
            .check("stored hold ticks", f64::from(left))?;
        let missed = Missed { period, displacement, work };
        Ok(Self { port: self.port.restored(port)?, left, missed, effort, ..self })
    }
}
