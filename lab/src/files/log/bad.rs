//! Bad rows: rows that cannot be used.

use std::fmt;

use serde::Serialize;

use super::columns::Role;
use super::notation::Mark;
use crate::text::{counted, shorten};

/// Number of bad rows that are listed; the rest are only counted.
const NAMED: usize = 10;

/// The largest number in SI units, of either sign, that a row may hold.
///
/// Up to it no product or sum of a report can leave the range of an `f64`.
pub(crate) const LARGEST: f64 = 1e50;

/// The shortest time between two rows, s, for the same reason.
pub(super) const SHORTEST: f64 = 1e-50;

/// Reason why a row cannot be used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Reason<'a> {
    Fields { found: usize, expected: usize },
    Number { role: Role, field: &'a [u8] },
    Mark { role: Role, field: &'a [u8], known: Mark },
    Range { role: Role, field: &'a [u8] },
    Order { time: f64, last: f64, line: u64 },
    TooLong,
}

impl Reason<'_> {
    /// Remedy for such a row.
    pub(crate) fn remedy(&self) -> &'static str {
        match self {
            Self::Fields { found, expected } if found > expected => {
                "every row needs as many fields as the first line; does each row end in a separator?"
            }
            Self::Fields { found: 1, .. } => {
                "every row needs as many fields as the first line; rows and names need the same separator"
            }
            Self::Fields { .. } | Self::TooLong => {
                "every row needs as many fields as the first line; is it cut off?"
            }
            Self::Number { role: Role::T, field } if field.contains(&b':') => {
                "t is a time of day: give t in seconds"
            }
            Self::Number { .. } | Self::Mark { .. } => {
                "write numbers as 0.5 or 5e-1, all with a point or, between semicolons or tabs, all with a comma; \
                 --columns may be wrong"
            }
            Self::Range { .. } => "NaN and infinities are no measurements; --scale may be wrong",
            Self::Order { time, last, .. } if time == last => {
                "equal stamps: write t with more digits, or give each row once"
            }
            Self::Order { .. } => {
                "time must increase: sort the log, or cut it where the clock went back"
            }
        }
    }
}

impl fmt::Display for Reason<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |field| shorten(String::from_utf8_lossy(field).trim());
        match self {
            Self::Fields { found, expected } => {
                write!(f, "{}, not {expected}", counted(*found, "field"))
            }
            Self::Number { role, field } if field.trim_ascii().is_empty() => {
                write!(f, "{} is empty", role.letter())
            }
            Self::Number { role, field } => {
                write!(f, "{} is `{}`, no number", role.letter(), text(field))
            }
            Self::Mark { role, field, known } => {
                let (letter, known) = (role.letter(), known.name());
                write!(
                    f,
                    "{letter} is `{}`, and numbers before have a decimal {known}",
                    text(field)
                )
            }
            Self::Range { role, field } => {
                write!(f, "{} is `{}`, out of range", role.letter(), text(field))
            }
            Self::Order { time, last, line } => {
                write!(f, "t = {time:?} s is not after {last:?} s of line {line}")
            }
            Self::TooLong => f.write_str("longer than 256 KiB"),
        }
    }
}

/// A bad row, with the time and force that can be read all the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bad<'a> {
    pub(crate) line: u64,
    pub(crate) reason: Reason<'a>,
    pub(crate) time: Option<f64>,
    pub(crate) force: Option<f64>,
}

/// A bad row in a report.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BadRow {
    /// The number of the line, from 1.
    pub line: u64,
    /// The reason why it cannot be used.
    pub reason: String,
}

/// The rows of a log that cannot be used.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct BadRows {
    /// The number of bad rows.
    pub count: u64,
    /// Rows with more or fewer fields than the first line, or too long.
    pub fields: u64,
    /// Rows with a field that is no number.
    pub numbers: u64,
    /// Rows with a NaN, an infinity or a number beyond ±1e50 in SI units.
    pub range: u64,
    /// Rows with a time stamp that is not after that of the last good row.
    pub order: u64,
    /// The first ten bad rows.
    pub first: Vec<BadRow>,
    /// Rows that have the same remedy.
    #[serde(skip)]
    remedies: Vec<(&'static str, u64)>,
}

impl BadRows {
    pub(crate) fn add(&mut self, line: u64, reason: &Reason<'_>) {
        self.count += 1;
        *match reason {
            Reason::Fields { .. } | Reason::TooLong => &mut self.fields,
            Reason::Number { .. } | Reason::Mark { .. } => &mut self.numbers,
            Reason::Range { .. } => &mut self.range,
            Reason::Order { .. } => &mut self.order,
        } += 1;
        let remedy = reason.remedy();
        match self.remedies.iter_mut().find(|it| it.0 == remedy) {
            Some(it) => it.1 += 1,
            None => self.remedies.push((remedy, 1)),
        }
        if self.first.len() < NAMED {
            self.first.push(BadRow { line, reason: reason.to_string() });
        }
    }

    /// Remedy for the most bad rows.
    pub fn remedy(&self) -> Option<&'static str> {
        self.remedies.iter().max_by_key(|it| it.1).map(|it| it.0)
    }

    /// The count, the first of them and a remedy, for an error that they may have caused; none without bad rows.
    pub(crate) fn blamed(&self) -> Option<String> {
        let (BadRow { line, reason }, remedy) = (self.first.first()?, self.remedy()?);
        let rows = match self.count {
            1 => "1 row is bad, at".to_owned(),
            count => format!("{count} rows are bad, the first at"),
        };
        Some(format!("{rows} line {line}: {reason}; {remedy}"))
    }

    /// The count, with the `fate` of the rows; the first ten, how many more, and each remedy: a line each. None without bad rows.
    pub(crate) fn lines(&self, fate: &str) -> Vec<String> {
        if self.count == 0 {
            return Vec::new();
        }
        let mut lines = vec![format!("{}{fate}", self.count)];
        lines.extend(self.first.iter().map(|row| format!("line {}: {}", row.line, row.reason)));
        let more = self.count.saturating_sub(self.first.len() as u64);
        if more > 0 {
            lines.push(format!("and {more} more"));
        }
        lines.extend(self.remedies.iter().map(|(remedy, _)| format!("= {remedy}")));
        lines
    }
}
