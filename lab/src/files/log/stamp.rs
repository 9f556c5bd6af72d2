//! Time stamp as the decimal number that it is written as.

/// A time stamp, `digits · 10^exponent`, not yet rounded: of the nanoseconds since 1970 an `f64` keeps the last 256 no more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    digits: i64,
    exponent: i32,
}

impl Stamp {
    /// The stamp in a field without blanks, times ten to the `power`; none with an exponent or more digits than an `i64` holds.
    pub(super) fn of(field: &[u8], power: i32) -> Option<Self> {
        let (sign, field) = field.strip_prefix(b"-").map_or((1, field), |rest| (-1, rest));
        let (mut digits, mut exponent, mut is_part) = (0_i64, power, false);
        for byte in field {
            match byte {
                b'0'..=b'9' => {
                    digits = digits.checked_mul(10)?.checked_add(i64::from(byte - b'0'))?;
                    exponent -= i32::from(is_part);
                }
                b'.' | b',' if !is_part => is_part = true,
                _ => return None,
            }
        }
        Some(Self { digits: sign * digits, exponent })
    }

    /// The time since the stamp `first`, rounded once where its digits fit an `f64`.
    pub(super) fn since(self, first: Self) -> Option<f64> {
        let least = self.exponent.min(first.exponent);
        let digits = |stamp: Self| {
            let factor = 10_i64.checked_pow(stamp.exponent.abs_diff(least))?;
            stamp.digits.checked_mul(factor)
        };
        let passed = digits(self)?.checked_sub(digits(first)?)? as f64;
        let unit = 10_f64.powi(least.abs());
        Some(if least < 0 { passed / unit } else { passed * unit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn between(first: &str, last: &str, power: i32) -> Option<f64> {
        let stamp = |text: &str| Stamp::of(text.as_bytes(), power);
        stamp(last)?.since(stamp(first)?)
    }

    #[test]
    fn differences_of_long_stamps_are_those_of_their_last_digits() {
        for (first, last, power, apart) in [
            ("1700000000000000000", "1700000000001000001", -9, 0.001_000_001_f64),
            ("1700000000.5", "1700000000.500333333", 0, 0.000_333_333),
            ("1700000000", "1700000001.25", 0, 1.25),
            ("-0,5", "0,25", 0, 0.75),
            ("3", "5", 2, 200.0),
        ] {
            let found = between(first, last, power).unwrap();
            assert_eq!(found.to_bits(), apart.to_bits(), "{first} to {last}");
        }
    }

    #[test]
    fn what_does_not_fit_is_no_stamp() {
        for text in ["1e3", "1.2.3", "+1", "NaN", "92233720368547758080"] {
            assert_eq!(Stamp::of(text.as_bytes(), 0), None, "{text}");
        }
        assert_eq!(between("9e0", "1", 0), None);
        assert_eq!(between("9000000000000000000", "0.001", 0), None);
    }
}
