//! Lines of a stream, in memory that does not grow.

use std::io::{self, BufRead, BufReader, Read};

/// Size of the line buffer, in bytes.
pub(super) const LONGEST: usize = 1 << 18;

/// Bytes without a line break after which reading fails.
const ENDLESS: u64 = 1 << 30;

/// The first index of a byte.
pub(super) fn find(byte: u8, text: &[u8]) -> Option<usize> {
    text.iter().position(|other| *other == byte)
}

/// Result of reading a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    /// A line, which [`Lines::text`] gives.
    Line,
    /// A line that does not fit [`LONGEST`] bytes; reading the next line skips the rest of it.
    TooLong,
    /// The end of the stream.
    End,
}

/// The lines of a stream.
///
/// Lines of the standard library grow with the longest line, and a file of zeros is one long line.
#[derive(Debug)]
pub(super) struct Lines<R> {
    reader: BufReader<R>,
    number: u64,
    text: Vec<u8>,
    /// Whether the rest of a line that did not fit comes next.
    overfull: bool,
}

impl<R: Read> Lines<R> {
    pub(super) fn new(reader: R) -> Self {
        let reader = BufReader::with_capacity(LONGEST, reader);
        Self { reader, number: 0, text: Vec::new(), overfull: false }
    }

    /// The number of the last line read, from 1.
    pub(super) fn number(&self) -> u64 {
        self.number
    }

    /// The last line read, without its line break.
    pub(super) fn text(&self) -> &[u8] {
        let text = self.text.strip_suffix(b"\n").unwrap_or(&self.text);
        text.strip_suffix(b"\r").unwrap_or(text)
    }

    /// Reads the next line.
    pub(super) fn read(&mut self) -> io::Result<Next> {
        if std::mem::take(&mut self.overfull) {
            let passed = self.reader.by_ref().take(ENDLESS).skip_until(b'\n')?;
            if passed as u64 == ENDLESS {
                let line = self.number;
                return Err(io::Error::other(format!("line {line} has no end within 1 GiB")));
            }
        }
        self.text.clear();
        self.reader.by_ref().take(LONGEST as u64).read_until(b'\n', &mut self.text)?;
        if self.text.is_empty() {
            return Ok(Next::End);
        }
        self.number += 1;
        self.overfull = self.text.len() == LONGEST && !self.text.ends_with(b"\n");
        Ok(if self.overfull { Next::TooLong } else { Next::Line })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reader that gives a few bytes at a time, as a pipe may.
    struct Drip<'a>(&'a [u8], usize);

    impl Read for Drip<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let size = self.1.min(self.0.len()).min(buffer.len());
            let (now, rest) = self.0.split_at(size);
            buffer[..size].copy_from_slice(now);
            self.0 = rest;
            Ok(size)
        }
    }

    fn all(text: &[u8], step: usize) -> Vec<Option<Vec<u8>>> {
        let mut lines = Lines::new(Drip(text, step));
        let mut found = Vec::new();
        loop {
            match lines.read().unwrap() {
                Next::Line => found.push(Some(lines.text().to_vec())),
                Next::TooLong => found.push(None),
                Next::End => break,
            }
        }
        assert_eq!(lines.number(), found.len() as u64);
        found
    }

    #[test]
    fn lines_end_with_a_break_or_with_the_stream() {
        for step in [1, 2, 3, 1000] {
            let expected = [&b"a,b"[..], b"", b"c", b"last"].map(|line| Some(line.to_vec()));
            assert_eq!(all(b"a,b\r\n\nc\nlast", step), expected);
            assert_eq!(all(b"a,b\r\n\nc\nlast\n", step), expected);
        }
        assert!(all(b"", 1).is_empty());
    }

    #[test]
    fn a_line_that_does_not_fit_is_skipped_and_the_next_one_read() {
        for extra in [0, 1, 2, LONGEST, 3 * LONGEST] {
            let mut text = b"first\n".to_vec();
            text.resize(text.len() + LONGEST + extra, b'x');
            text.extend(b"\nnext\n");
            for step in [1000, LONGEST, usize::MAX] {
                let found = all(&text, step);
                assert_eq!(found.len(), 3);
                assert_eq!((&found[1], &found[2]), (&None, &Some(b"next".to_vec())));
            }
        }
    }

    #[test]
    fn a_line_that_just_fits_is_read() {
        let mut text = vec![b'x'; LONGEST - 1];
        text.push(b'\n');
        assert_eq!(all(&text, usize::MAX)[0].as_ref().map(Vec::len), Some(LONGEST - 1));
    }
}
