//! Prefix of a unit.

/// Readable unit for a magnitude: its factor from SI, and its prefix.
pub(crate) fn prefix(largest: f64) -> (f64, &'static str) {
    match largest {
        size if size >= 1.0 || size == 0.0 => (1.0, ""),
        size if size >= 1e-3 => (1e3, "m"),
        _ => (1e6, "µ"),
    }
}
