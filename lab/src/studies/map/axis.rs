//! An axis of a map.

use std::fmt;
use std::str::FromStr;

pub use crate::files::scene::Spacing;
use crate::files::scene::unit;

/// The most values along an axis.
const MOST: u64 = 1_000_000;

/// The most values that stand for a long axis.
const SAMPLES: u64 = 97;

const FORM: &str =
    "KEY=FROM..TO:N or KEY=FROM..TO:N:log, for example environment.wall.stiffness=100..50000:256";

/// A number of the scene, by its dotted key, over a range: `KEY=FROM..TO:N[:log]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The key with its table path.
    pub key: String,
    /// The first value.
    pub from: f64,
    /// The last value, greater than the first unless that is the only one.
    pub to: f64,
    /// The number of values, 1 or more.
    pub count: u64,
    /// The spacing of the values.
    pub spacing: Spacing,
}

impl Axis {
    /// Value number `index`, from 0 to `count - 1`; both ends are exactly `from` and `to`.
    pub fn value(&self, index: u64) -> f64 {
        let last = self.count.saturating_sub(1);
        let (index, steps) = (index.min(last) as f64, last as f64);
        if index == steps {
            return self.to;
        }
        match self.spacing {
            Spacing::Linear => self.from + (self.to - self.from) * index / steps,
            Spacing::Logarithmic => self.from * libm::pow(self.to / self.from, index / steps),
        }
    }

    /// The indices of values, the first and the last among them, that stand for a long axis.
    pub(super) fn samples(&self) -> Vec<u64> {
        let last = self.count.saturating_sub(1);
        let steps = last.min(SAMPLES - 1);
        (0..=steps).map(|number| number * last / steps.max(1)).collect()
    }

    /// The number of the sample that value `index` is, if it is one.
    pub(super) fn sample_at(&self, index: u64) -> Option<usize> {
        let last = self.count.saturating_sub(1);
        let steps = last.min(SAMPLES - 1);
        let number = (index * steps).div_ceil(last.max(1));
        (number * last / steps.max(1) == index).then_some(number as usize)
    }

    /// Unit of the width: that of the number, or decades; empty where it has none.
    pub fn unit(&self) -> &'static str {
        match self.spacing {
            Spacing::Linear => unit(&self.key),
            Spacing::Logarithmic => "decades",
        }
    }

    /// Width of the axis in its unit; of a logarithmic one in decades.
    pub(super) fn width(&self) -> f64 {
        match self.spacing {
            // A single value takes nothing from the area over the other axis.
            _ if self.count == 1 => 1.0,
            Spacing::Linear => self.to - self.from,
            Spacing::Logarithmic => libm::log10(self.to / self.from),
        }
    }
}

/// An axis that cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisError(String);

impl fmt::Display for AxisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n  = give {FORM}", self.0)
    }
}

impl std::error::Error for AxisError {}

impl FromStr for Axis {
    type Err = AxisError;

    fn from_str(text: &str) -> Result<Self, AxisError> {
        let no = |problem: String| Err(AxisError(problem));
        let Some((key, range)) = text.split_once('=') else {
            return no("an axis is a key, `=` and a range".to_owned());
        };
        let key = key.trim();
        if key.split('.').any(str::is_empty) {
            return no(format!("`{key}` has an empty part: one dot stands between two names"));
        }
        let mut parts = range.split(':');
        let (ends, count, word) = (parts.next().unwrap_or_default(), parts.next(), parts.next());
        let Some((from, to)) = ends.split_once("..") else {
            return no(format!("`{ends}` is not a range FROM..TO"));
        };
        let number = |text: &str| match text.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(AxisError(format!("`{text}` is not a finite number"))),
        };
        let (from, to) = (number(from)?, number(to)?);
        if from > to {
            return no(format!("the range {from}..{to} is reversed: FROM has to be less than TO"));
        }
        let Some(count) = count else {
            return no(format!("the range {from}..{to} lacks the number of values"));
        };
        let Some(count) = count.trim().parse().ok().filter(|count| (1..=MOST).contains(count))
        else {
            return no(format!("`{count}` is not a number of values from 1 to {MOST}"));
        };
        if (from == to) != (count == 1) {
            return no(match count {
                1 => format!("one value is a range of its own, {from}..{from}:1"),
                _ => format!("the range {from}..{to} is empty: FROM has to be less than TO"),
            });
        }
        let spacing = match (word.map(str::trim), parts.next()) {
            (None, _) => Spacing::Linear,
            (Some("log"), None) => Spacing::Logarithmic,
            _ => return no(format!("`{range}` ends in something other than `:log`")),
        };
        if spacing == Spacing::Logarithmic && from <= 0.0 {
            return no(format!("a logarithmic range begins above 0, not at {from}"));
        }
        let width = match spacing {
            Spacing::Linear => to - from,
            Spacing::Logarithmic => to / from,
        };
        if !width.is_finite() {
            return no(format!("the range {from}..{to} is wider than numbers can tell"));
        }
        Ok(Self { key: key.to_owned(), from, to, count, spacing })
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = if self.spacing == Spacing::Logarithmic { ":log" } else { "" };
        write!(f, "{}={:?}..{:?}:{}{word}", self.key, self.from, self.to, self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_found_by_their_values() {
        for count in [1, 2, 3, 96, 97, 98, 99, 100, 193, 500, 999_983, MOST] {
            let range = if count == 1 { "1..1" } else { "1..2" };
            let axis: Axis = format!("device.mass={range}:{count}").parse().unwrap();
            let samples = axis.samples();
            assert_eq!((samples[0], samples[samples.len() - 1]), (0, count - 1));
            assert_eq!(samples.len() as u64, count.min(SAMPLES));
            let mut number = 0;
            for index in 0..count {
                let is_next = samples.get(number) == Some(&index);
                assert_eq!(axis.sample_at(index), is_next.then_some(number), "{index} of {count}");
                number += usize::from(is_next);
            }
        }
    }
}
