//! Checksum of text and numbers.

use std::fmt;

/// Checksum of 64 bits after Fowler, Noll and Vo (FNV-1a), shown as 16 hexadecimal digits.
///
/// Each byte is mixed in by a step that can be undone, so two texts of one length that differ in a single byte never have
/// the same checksum. It notices damage; it is no protection against somebody who wants to deceive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Checksum(u64);

impl Checksum {
    /// The checksum of nothing.
    pub(crate) const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    /// The checksum of what this one is of, followed by `bytes`.
    pub(crate) fn and(self, bytes: &[u8]) -> Self {
        let mix = |sum: u64, byte: &u8| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        Self(bytes.iter().fold(self.0, mix))
    }
}

impl fmt::Display for Checksum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Checksum;

    /// From the published test vectors of FNV-1a.
    #[test]
    fn published_values() {
        for (text, sum) in
            [("", "cbf29ce484222325"), ("a", "af63dc4c8601ec8c"), ("foobar", "85944171f73967e8")]
        {
            assert_eq!(Checksum::EMPTY.and(text.as_bytes()).to_string(), sum);
        }
        let halves = Checksum::EMPTY.and(b"foo").and(b"bar");
        assert_eq!(halves, Checksum::EMPTY.and(b"foobar"));
    }
}
