//! Row of the table: a method at a setting.

use std::fmt::{self, Display, Formatter};
use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::scene::{DURATION, PERIODS, Positions};

/// Setting of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setting {
    /// No setting.
    None,
    /// Steps of equal length per period.
    Steps(u32),
    /// The absolute (m, m/s) and the relative tolerance.
    Tolerance(f64),
}

impl Display for Setting {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => formatter.pad("-"),
            Self::Steps(1) => formatter.pad("1 step"),
            Self::Steps(steps) => formatter.pad(&format!("{steps} steps")),
            Self::Tolerance(tolerance) => formatter.pad(&format!("{tolerance:.0e}")),
        }
    }
}

/// Origin of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// This library.
    Ours,
    /// Written by hand for this comparison.
    Hand,
    /// A crate.
    Crate,
    /// A Python package.
    Python,
}

/// Method at a setting.
pub(crate) struct Row {
    pub(crate) origin: Origin,
    pub(crate) method: String,
    pub(crate) setting: Setting,
    pub(crate) run: Run,
}

/// Run of the mass through the positions; it returns the ns per simulated second, or the reason of its failure.
pub(crate) type Run = Box<dyn FnMut(&mut Positions) -> Result<f64, String>>;

impl Row {
    /// A row that is compiled into this program.
    pub(crate) fn compiled(
        origin: Origin,
        method: &str,
        setting: Setting,
        run: impl Fn(&mut Positions) + 'static,
    ) -> Self {
        Self { origin, method: method.into(), setting, run: repeated(run, 1) }
    }

    /// The same for a method that runs several `rollouts` at once; its time is that of one.
    pub(crate) fn side_by_side(
        origin: Origin,
        method: &str,
        rollouts: u32,
        run: impl Fn(&mut Positions) + 'static,
    ) -> Self {
        Self { origin, method: method.into(), setting: Setting::None, run: repeated(run, rollouts) }
    }

    /// Rows of a method at equal steps.
    pub(crate) fn stepped(
        origin: Origin,
        method: &str,
        counts: &[u32],
        run: impl Fn(&mut Positions, u32) + Copy + 'static,
    ) -> impl Iterator<Item = Self> {
        counts.iter().map(move |&steps| {
            Self::compiled(origin, method, Setting::Steps(steps), move |at| run(at, steps))
        })
    }

    /// Rows of a method that chooses its steps by a tolerance: 0.1, and tighter as far as `f64` reaches.
    pub(crate) fn adaptive(
        origin: Origin,
        method: &str,
        run: impl Fn(&mut Positions, f64) + Copy + 'static,
    ) -> impl Iterator<Item = Self> {
        (1..=13).map(move |digits| {
            let tolerance = 10.0_f64.powi(-digits);
            let setting = Setting::Tolerance(tolerance);
            Self::compiled(origin, method, setting, move |at| run(at, tolerance))
        })
    }
}

/// `run` of so many `rollouts`, repeated often enough that reading the clock does not matter; the first call runs once, to find how
/// often.
fn repeated(run: impl Fn(&mut Positions) + 'static, rollouts: u32) -> Run {
    const BLOCK: Duration = Duration::from_millis(1);
    let mut times = 1;
    Box::new(move |positions| {
        let start = Instant::now();
        for _ in 0..times {
            run(black_box(positions));
        }
        let once = start.elapsed().as_secs_f64() / f64::from(times);
        times = (BLOCK.as_secs_f64() / once).ceil().clamp(1.0, 1e4) as u32;
        Ok(once * 1e9 / DURATION / f64::from(rollouts))
    })
}

/// Positions before a run.
pub(crate) const NOWHERE: Positions = [f64::NAN; PERIODS + 1];
