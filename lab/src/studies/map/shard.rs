//! Shards: shares of a map for several jobs.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// Share `index` of `count`, counted from 0: consecutive cells. Shards differ by at most one cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// The index of the shard, from 0.
    pub index: u64,
    /// The number of shards.
    pub count: u64,
}

impl Shard {
    /// The whole map.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// The cells of this shard, of `cells` in all.
    pub fn cells(self, cells: u64) -> Range<u64> {
        let at =
            |index: u64| (u128::from(cells) * u128::from(index) / u128::from(self.count)) as u64;
        at(self.index)..at(self.index + 1)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

/// A text that is no shard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShardError(String);

impl fmt::Display for ShardError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n  = give i/n with i from 0 to n - 1, for example 0/4 to 3/4", self.0)
    }
}

impl std::error::Error for ShardError {}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let parts = text.split_once('/');
        let numbers = parts.and_then(|(index, count)| {
            Some((index.trim().parse().ok()?, count.trim().parse::<u64>().ok()?))
        });
        match numbers {
            Some((index, count)) if index < count => Ok(Self { index, count }),
            Some((index, count)) => {
                Err(ShardError(format!("there is no shard {index} of {count}")))
            }
            None => Err(ShardError(format!("`{text}` is not a shard"))),
        }
    }
}
