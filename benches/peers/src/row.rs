//! One line of the table.

use std::fmt::{self, Display, Formatter};

use crate::scene::Positions;

/// What a method is turned by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setting {
    /// Nothing.
    None,
    /// Steps of equal length per period.
    Steps(u32),
    /// The negative decimal logarithm of the absolute (m, m/s) and the relative tolerance.
    Tolerance(i32),
}

impl Display for Setting {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => formatter.write_str("-"),
            Self::Steps(1) => formatter.write_str("1 step"),
            Self::Steps(steps) => write!(formatter, "{steps} steps"),
            Self::Tolerance(digits) => write!(formatter, "1e-{digits}"),
        }
    }
}

/// Whose a method is.
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

/// A method at a setting, compiled into this program.
pub(crate) struct Compiled {
    pub(crate) origin: Origin,
    pub(crate) method: &'static str,
    pub(crate) setting: Setting,
    pub(crate) run: Box<dyn Fn(&mut Positions)>,
}

/// Rows of a method at equal steps.
pub(crate) fn stepped(
    origin: Origin,
    method: &'static str,
    counts: &'static [u32],
    run: impl Fn(&mut Positions, u32) + Copy + 'static,
) -> impl Iterator<Item = Compiled> {
    counts.iter().map(move |&steps| Compiled {
        origin,
        method,
        setting: Setting::Steps(steps),
        run: Box::new(move |positions| run(positions, steps)),
    })
}

/// Rows of a method that chooses its steps by a tolerance, from 0.1 on.
pub(crate) fn adaptive(
    origin: Origin,
    method: &'static str,
    run: impl Fn(&mut Positions, f64) + Copy + 'static,
) -> impl Iterator<Item = Compiled> {
    (1..=13).map(move |digits| Compiled {
        origin,
        method,
        setting: Setting::Tolerance(digits),
        run: Box::new(move |positions| run(positions, 10.0_f64.powi(-digits))),
    })
}
