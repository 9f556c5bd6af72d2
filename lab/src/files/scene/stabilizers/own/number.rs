//! A number of an own stabilizer.

use super::super::Search;
use super::{Allowed, Loop};

/// A number of an own stabilizer or candidate, which scenes write in its table, `tune` searches and its maker reads.
///
/// Declare it as a constant, list it in `NUMBERS`, and read it by [`Loop::number`]:
///
/// ```
/// use lyapunov_lab::own::{Allowed, OwnNumber, Search};
///
/// /// Time in which credit leaks away: by default a hundred ticks.
/// const LEAK: OwnNumber = OwnNumber::new("leak", "s", Allowed::Positive, |on| 100.0 * on.period())
///     .searched(|default, _| Search::ratios(0.1 * default, 10.0 * default));
/// # let _ = LEAK;
/// ```
#[derive(Clone, Copy, Debug)]
pub struct OwnNumber {
    pub(super) key: &'static str,
    pub(super) unit: &'static str,
    pub(super) allowed: Allowed,
    pub(super) default: fn(&Loop<'_>) -> f64,
    pub(super) search: fn(f64, &Loop<'_>) -> Option<Search>,
}

impl OwnNumber {
    /// The limit of the injected damping, m / T: the key, default and range that every stabilizer with a damper has.
    /// [`Loop::damping_limit`] reads it.
    pub const DAMPING_CAP: Self =
        Self::new("damping_cap", "m / T", Allowed::Limit, |on| on.default_cap())
            .searched(|_, on| on.caps());

    /// A number under `key` in the table of its stabilizer, in `unit` (empty if it has none), one of those `allowed`;
    /// where the scene writes none, `default` gives it. `tune` leaves it alone.
    ///
    /// A default that is not allowed, such as NaN, says that this loop gives none: then the scene has to write it.
    pub const fn new(
        key: &'static str,
        unit: &'static str,
        allowed: Allowed,
        default: fn(&Loop<'_>) -> f64,
    ) -> Self {
        Self { key, unit, allowed, default, search: |_, _| None }
    }

    /// The same number, which `tune` searches in the range that `search` makes of its default.
    #[must_use]
    pub const fn searched(self, search: fn(f64, &Loop<'_>) -> Option<Search>) -> Self {
        Self { search, ..self }
    }
}
