//! Conversion of TOML numbers to Rust numbers.

use toml::de::{DeFloat, DeInteger};

/// The nearest f64, also of a whole number beyond 64 bits; none if the number is beyond the range of f64.
pub(super) fn real_of_integer(integer: &DeInteger<'_>) -> Option<f64> {
    if integer.radix() == 10 {
        let real: f64 = integer.as_str().parse().ok()?;
        return real.is_finite().then_some(real);
    }
    let whole = u128::from_str_radix(integer.as_str(), integer.radix()).ok()?;
    Some(whole as f64)
}

/// The nearest f64; none if only rounding makes it infinite.
pub(super) fn real_of_float(float: &DeFloat<'_>) -> Option<f64> {
    let text = float.as_str();
    let real: f64 = text.parse().ok()?;
    (real.is_finite() || text.contains("inf") || text.contains("nan")).then_some(real)
}

/// The whole number, if it fits in 64 bits.
pub(super) fn whole(integer: &DeInteger<'_>) -> Option<i64> {
    i64::from_str_radix(integer.as_str(), integer.radix()).ok()
}

/// The whole number, if it fits in 64 bits without a sign.
pub(super) fn natural(integer: &DeInteger<'_>) -> Option<u64> {
    u64::from_str_radix(integer.as_str(), integer.radix()).ok()
}
