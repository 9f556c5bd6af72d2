//! Comma-separated values of a ring of ticks.

use core::fmt;

use super::{RecordedTick, TickRing};
use crate::signal_axes::{axes, axis_of};
use crate::{DoubleDouble, Mask, Scalar, Signal};

/// Ticks of a [`TickRing`] as comma-separated values: the log that `lyapunov observe` reads without further settings.
///
/// | column | unit | |
/// |---|---|---|
/// | `t` | s | time since the oldest tick in the ring, the sum of the periods |
/// | `x`, `v` | m, m/s | position and velocity of the sample |
/// | `f` | N | the effort that acted from this tick until the next: the next sample tells it, the last row has the commanded one |
/// | `f_out` | N | the commanded effort |
/// | `observer`, `alpha`, `shortfall`, `accepted` | J, N·s/m, J, 0 or 1 | of the correction, as in the rows of `lyapunov run` |
///
/// After the columns of the first axis follow those of the others: `y`, `y_v`, `y_f`, `y_f_out`, then `z`, then `x4` and
/// so on. `lyapunov observe --columns t,y,y_f` reads another axis. Numbers have all their digits. A number that is not
/// finite is written as it is, and `observe` counts its row as bad; a period that is not above 0 and finite counts in
/// `t` as the one before it.
///
/// `observe` forms the work of a period as `f Δx`. A sample that [spans](crate::PortSample::spanning) several efforts
/// carries a work of its own, which a log of one force per row cannot show.
///
/// ```
/// use core::fmt::Write;
/// use lyapunov_core::telemetry::TickRing;
/// use lyapunov_core::{Correction, HeldTick, PortSample};
/// # struct Uart(String);
/// # impl Write for Uart {
/// #     fn write_str(&mut self, text: &str) -> core::fmt::Result {
/// #         self.0.write_str(text)
/// #     }
/// # }
/// fn dump<const N: usize>(ring: &TickRing<f64, N>, uart: &mut impl Write) -> core::fmt::Result {
///     write!(uart, "{}", ring.csv())
/// }
/// # let mut uart = Uart(String::new());
/// let mut ring = TickRing::<f64, 8>::new();
/// ring.push(&PortSample::starting(1e-3, 0.0, 0.0), &Correction::none(2.0));
/// let tick = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: 1.5 };
/// ring.push(&tick.sample(), &Correction::none(3.0)); // 1.5 N of the 2 N acted
/// dump(&ring, &mut uart)?;
/// assert_eq!(
///     uart.0,
///     "t,x,v,f,f_out,observer,alpha,shortfall,accepted\n\
///      0.0,0.0,0.0,1.5,2.0,0.0,0.0,0.0,1\n\
///      0.001,0.0001,0.1,3.0,3.0,0.0,0.0,0.0,1\n"
/// );
/// # Ok::<(), core::fmt::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Csv<'a, V: Signal, const N: usize> {
    ring: &'a TickRing<V, N>,
    lane: usize,
}

impl<'a, V: Signal, const N: usize> Csv<'a, V, N> {
    pub(super) fn of(ring: &'a TickRing<V, N>) -> Self {
        Self { ring, lane: 0 }
    }

    /// The same of another lane than the first; past the last one all numbers are NaN.
    #[must_use]
    pub fn of_lane(self, lane: usize) -> Self {
        Self { lane, ..self }
    }

    fn row(
        &self,
        f: &mut fmt::Formatter<'_>,
        time: f64,
        tick: &RecordedTick<V>,
        acting: V,
    ) -> fmt::Result {
        let RecordedTick { sample, correction } = tick;
        write!(f, "{time:?}")?;
        let columns = [sample.position, sample.velocity, acting, correction.effort];
        for axis in 0..axes::<V>() {
            for column in columns {
                write!(f, ",{:?}", axis_of(column, axis).lane(self.lane))?;
            }
        }
        for value in [correction.observed_energy, correction.alpha, correction.shortfall] {
            write!(f, ",{:?}", value.lane(self.lane))?;
        }
        writeln!(f, ",{}", u8::from(correction.accepted.lane(self.lane)))
    }
}

impl<V: Signal, const N: usize> fmt::Display for Csv<'_, V, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("t")?;
        for axis in 0..axes::<V>() {
            match axis {
                0 => f.write_str(",x,v,f,f_out")?,
                1 => f.write_str(",y,y_v,y_f,y_f_out")?,
                2 => f.write_str(",z,z_v,z_f,z_f_out")?,
                _ => write!(f, ",x{0},x{0}_v,x{0}_f,x{0}_f_out", axis + 1)?,
            }
        }
        f.write_str(",observer,alpha,shortfall,accepted\n")?;

        let (mut time, mut period) = (DoubleDouble::of(0.0), 0.0);
        let mut ticks = self.ring.iter().peekable();
        while let Some(tick) = ticks.next() {
            let acting = ticks.peek().map_or(tick.correction.effort, |next| next.sample.applied);
            self.row(f, time.high(), tick, acting)?;
            if let Some(next) = ticks.peek() {
                let own = next.sample.period.lane(self.lane);
                period = if own.is_finite() && own > 0.0 { own } else { period };
                time += DoubleDouble::of(period);
            }
        }
        Ok(())
    }
}
