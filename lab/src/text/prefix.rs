//! Prefix of a unit.

use super::numbers::found;

/// Readable unit for a magnitude: its factor from SI, and its prefix.
pub(crate) fn prefix(largest: f64) -> (f64, &'static str) {
    match largest {
        size if size >= 1.0 || size == 0.0 => (1.0, ""),
        size if size >= 1e-3 => (1e3, "m"),
        _ => (1e6, "µ"),
    }
}

/// A number with the prefix of its unit that suits it.
pub(crate) fn prefixed(value: f64, unit: &str) -> String {
    let (factor, prefix) = prefix(value.abs());
    format!("{} {prefix}{unit}", found(factor * value))
}
