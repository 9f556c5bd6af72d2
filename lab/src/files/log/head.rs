//! Head of a log: the names of its columns, or its first row.

use std::io::Read;

use super::blank;
use super::columns::Columns;
use super::error::LogError;
use super::fields::{BLANK, Fields, delimiter};
use super::layout::{EXPECTED, Layout, RETURNS, has_returns};
use super::lines::{Lines, Next};

/// Layout of a log, and what had to be read below its names to find it.
pub(super) struct Head {
    pub(super) layout: Layout,
    /// The comment right below the names, with the number of its line.
    pub(super) below: Option<(u64, Vec<u8>)>,
    /// The first row; empty where it was not read.
    pub(super) first: Vec<u8>,
}

impl Head {
    /// Reads `lines` up to the names of the columns, or to the first row where there are none.
    ///
    /// Lines that begin with `#` are comments, except for one that holds all the names: some programs write the names behind such a
    /// sign. A sentence may hold them too, so that where blanks part them the first row has to have as many fields.
    pub(super) fn read<R: Read>(
        lines: &mut Lines<R>,
        name: &str,
        columns: &Columns,
    ) -> Result<Self, LogError> {
        let (mut found, mut expected): (Option<Self>, &str) = (None, EXPECTED);
        loop {
            let next = lines.read().map_err(|error| LogError::unreadable(name, &error))?;
            let (line, at) = (lines.text(), lines.number());
            expected = if has_returns(line) { RETURNS } else { expected };
            match next {
                Next::Line => {}
                Next::TooLong => {
                    let message = "this is no row: the line is longer than 256 KiB";
                    return Err(LogError::at(name, at, message).with_help(expected));
                }
                Next::End => {
                    let empty = || LogError::about(name, "the log is empty").with_help(expected);
                    return found.ok_or_else(empty);
                }
            }
            let line =
                if at == 1 { line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line) } else { line };
            if blank(line) {
                continue;
            }
            let Some(comment) = line.strip_prefix(b"#") else {
                let fields = Fields::new(line, BLANK).count();
                let fits = |it: &Self| delimiter(line) == BLANK && it.layout.width == fields;
                return match found.filter(fits) {
                    Some(head) => Ok(Self { first: line.to_vec(), ..head }),
                    None => {
                        let layout = Layout::of(line, columns, name, at)?;
                        let first = if layout.is_row { line.to_vec() } else { Vec::new() };
                        Ok(Self { layout, below: None, first })
                    }
                };
            };
            let named = (!columns.numbered()).then(|| Layout::of(comment, columns, name, at));
            match (named, &mut found) {
                (Some(Ok(layout)), _) => {
                    let head = Self { layout, below: None, first: Vec::new() };
                    if head.layout.delimiter != BLANK {
                        return Ok(head);
                    }
                    found = Some(head);
                }
                (_, Some(Self { below: below @ None, .. })) => *below = Some((at, line.to_vec())),
                _ => {}
            }
        }
    }
}
