//! Numbers formatted for readers.

use std::fmt;

/// A computed number, to the four digits that matter.
pub(crate) fn found(value: f64) -> Number {
    Number { value, digits: 4 }
}

/// A number that is compared with 1, to so many decimals; a large one to the digits that matter.
pub(crate) fn near_one(value: f64, decimals: usize) -> String {
    if value < 100.0 { format!("{value:.decimals$}") } else { found(value).to_string() }
}

/// A number from the scene, or a time: close to the written value, and still short.
pub(crate) fn given(value: f64) -> Number {
    Number { value, digits: 9 }
}

/// The number nearest to `value` with so many significant digits.
pub(crate) fn to_digits(value: f64, digits: usize) -> f64 {
    let behind = digits - 1;
    format!("{value:.behind$e}").parse().unwrap_or(value)
}

/// A number rounded to some significant digits, but never before the decimal point, and without trailing zeros.
pub(crate) struct Number {
    value: f64,
    digits: usize,
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (value, size) = (self.value, self.value.abs());
        if size.is_infinite() {
            f.write_str(if value > 0.0 { "over 1.797e308" } else { "under -1.797e308" })
        } else if size.is_nan() {
            f.write_str("NaN")
        } else if size == 0.0 {
            f.write_str("0")
        } else if (1e-3..1e6).contains(&size) {
            let decimals = (self.digits as i32 - 1 - size.log10().floor() as i32).max(0) as usize;
            f.write_str(trimmed(&format!("{value:.decimals$}")))
        } else {
            let decimals = self.digits - 1;
            let text = format!("{value:.decimals$e}");
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            write!(f, "{}e{exponent}", trimmed(digits))
        }
    }
}

/// The number without the trailing zeros of its fraction.
fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}
