//! Head of a log: the names of its columns, or its first row.

use std::collections::VecDeque;
use std::io::Read;

use super::blank;
use super::columns::Columns;
use super::error::LogError;
use super::fields::{BLANK, Fields, delimiter};
use super::layout::Layout;
use super::lines::{Lines, Next};

/// The most comments that are kept below one that may hold the names.
const COMMENTS: usize = 64;

/// Layout of a log, and the lines below its names that had to be read to find it, each with its number; the first row where there
/// are no names.
pub(super) struct Head {
    pub(super) layout: Layout,
    pub(super) below: VecDeque<(u64, Vec<u8>)>,
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
        const EXPECTED: &str =
            "give a log of comma-separated values, as text with one row per line";
        let mut found: Option<Self> = None;
        loop {
            let next = lines.read().map_err(|error| LogError::unreadable(name, &error))?;
            let (line, at) = (lines.text(), lines.number());
            match next {
                Next::Line => {}
                Next::TooLong => {
                    let message = "this is no row: the line is longer than 256 KiB";
                    return Err(LogError::at(name, at, message).with_help(EXPECTED));
                }
                Next::End => {
                    let empty = || LogError::about(name, "the log is empty").with_help(EXPECTED);
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
                let (mut head, is_row) = match found.filter(fits) {
                    Some(head) => (head, true),
                    None => {
                        let layout = Layout::of(line, columns, name, at)?;
                        let is_row = layout.is_row;
                        (Self { layout, below: VecDeque::new() }, is_row)
                    }
                };
                if is_row {
                    head.below.push_back((at, line.to_vec()));
                }
                return Ok(head);
            };
            let named = (!columns.numbered()).then(|| Layout::of(comment, columns, name, at));
            match (named, &mut found) {
                (Some(Ok(layout)), _) => {
                    let head = Self { layout, below: VecDeque::new() };
                    if head.layout.delimiter != BLANK {
                        return Ok(head);
                    }
                    found = Some(head);
                }
                (_, Some(head)) if head.below.len() < COMMENTS => {
                    head.below.push_back((at, line.to_vec()));
                }
                _ => {}
            }
        }
    }
}
