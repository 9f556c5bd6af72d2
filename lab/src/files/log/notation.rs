//! Notation of the numbers of a log: the decimal mark, and powers of ten.

use super::fields::{bare, number};

/// Mark between the whole and the fraction of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Point,
    Comma,
}

impl Mark {
    /// The mark in words.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Comma => "comma",
        }
    }
}

/// Reason why a field holds no number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    NoNumber,
    /// A mark other than this one, which the fields before have: it might part thousands.
    OtherMark(Mark),
}

/// Notation of the numbers of a log. Its first number with a decimal mark settles which mark that is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Notation {
    takes_comma: bool,
    mark: Option<Mark>,
}

impl Notation {
    /// The notation of a log with this delimiter; where commas part the fields, a number has none.
    pub(super) fn of(delimiter: u8) -> Self {
        Self { takes_comma: delimiter != b',', mark: None }
    }

    /// The decimal mark, once it is settled.
    pub(super) fn mark(&self) -> Option<Mark> {
        self.mark
    }

    /// The number in a field times ten to the `power`, rounded once; NaN and infinities included.
    pub(super) fn read(&mut self, field: &[u8], power: i32) -> Result<f64, Fault> {
        if power == 0 && !self.takes_comma {
            return number(field).ok_or(Fault::NoNumber);
        }
        let text = str::from_utf8(bare(field)).map_err(|_| Fault::NoNumber)?;
        let mark = match (text.contains('.'), text.contains(',')) {
            (false, false) => None,
            (true, false) => Some(Mark::Point),
            (false, true) if self.takes_comma => Some(Mark::Comma),
            _ => return Err(Fault::NoNumber),
        };
        let plain = text.replace(',', ".");
        let value = shifted(&plain, power).ok_or(Fault::NoNumber)?;
        match (self.mark, mark) {
            (Some(known), Some(mark)) if known != mark => return Err(Fault::OtherMark(known)),
            (None, Some(_)) if self.takes_comma => self.mark = mark,
            _ => {}
        }
        Ok(value)
    }
}

/// The number in `text` times ten to the `power`: the exponent moves, so that no digit is rounded twice.
fn shifted(text: &str, power: i32) -> Option<f64> {
    if power == 0 {
        return text.parse().ok();
    }
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let moved = exponent.parse::<i32>().ok().and_then(|exponent| {
        let exponent = exponent.saturating_add(power);
        format!("{digits}e{exponent}").parse().ok()
    });
    // Infinities and NaN have no exponent, and too large a one is infinite.
    moved.or_else(|| text.parse().ok())
}

/// Whether a field of a line with this delimiter is a number.
pub(super) fn is_number(field: &[u8], delimiter: u8) -> bool {
    Notation::of(delimiter).read(field, 0).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_a_decimal_mark_where_it_does_not_part_fields() {
        let mut notation = Notation::of(b';');
        assert_eq!(notation.read(b"-3", 0), Ok(-3.0));
        assert_eq!(notation.read(b" \"1,5e-3\" ", 0), Ok(1.5e-3));
        assert_eq!(notation.mark(), Some(Mark::Comma));
        assert_eq!(notation.read(b"1.5", 0), Err(Fault::OtherMark(Mark::Comma)));
        for field in [&b"1,5"[..], b"1.2.3", b"1,234.5", b"", b"x"] {
            assert_eq!(Notation::of(b',').read(field, 0), Err(Fault::NoNumber));
        }
        for field in [&b"1,2,3"[..], b"1.234,5", b"", b"\xff"] {
            assert_eq!(Notation::of(b'\t').read(field, 0), Err(Fault::NoNumber));
        }
    }

    #[test]
    fn a_power_of_ten_keeps_every_digit() {
        for (text, power, same) in [
            ("4.1", -3, "0.0041"),
            ("4.1e2", -6, "0.00041"),
            ("-0.2578954633330946", 3, "-257.8954633330946"),
            ("123456789", -9, "0.123456789"),
        ] {
            let found = Notation::of(b',').read(text.as_bytes(), power).unwrap();
            assert_eq!(found.to_bits(), same.parse::<f64>().unwrap().to_bits(), "{text}");
        }
        assert!(Notation::of(b',').read(b"NaN", -3).unwrap().is_nan());
        assert_eq!(Notation::of(b',').read(b"1e99999999999", -3), Ok(f64::INFINITY));
    }
}
