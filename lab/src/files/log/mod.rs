//! Logs of any device: rows of time, position and force, read one by one in memory that does not grow.

mod bad;
mod columns;
mod error;
mod fields;
mod heading;
mod layout;
mod lines;
mod notation;
mod opened;
mod row;
mod sample;
mod scale;
mod time_step;
mod unit_row;

pub(crate) use bad::{Bad, LARGEST, Reason};
pub use bad::{BadRow, BadRows};
pub(crate) use columns::described;
pub use columns::{Column, Columns, Role};
pub use error::LogError;
pub use opened::opened;
pub(crate) use row::Entry;
pub(crate) use sample::Sample;
pub use scale::Scale;
pub(crate) use time_step::{GAP, TimeStep, median_period};

use std::io::{self, Read};

use layout::Layout;
use lines::{Lines, Next};
use notation::Mark;
use row::RowReader;
use unit_row::take_units;

/// Reader of the rows of a log.
#[derive(Debug)]
pub(crate) struct Log<R> {
    lines: Lines<R>,
    row: RowReader,
    columns: Vec<Column>,
    /// The first row, where it was read while the log was opened.
    first: Vec<u8>,
    /// What it is.
    pending: Option<Next>,
}

impl<R: Read> Log<R> {
    /// Reads up to the names of the columns, or to the first row where there are no names.
    pub(crate) fn open(
        reader: R,
        name: &str,
        columns: &Columns,
        scales: &[Scale],
    ) -> Result<Self, LogError> {
        let mut lines = Lines::new(reader);
        let (layout, first) = head(&mut lines, name, columns)?;
        let (mut factors, mut scaled) = ([1.0; 4], [false; 4]);
        for Scale { role, factor } in scales {
            factors[role.index()] *= factor;
            scaled[role.index()] = true;
        }
        // A factor of −1 turns the sign and leaves the unit.
        let scaled = std::array::from_fn(|at| scaled[at] && factors[at] != -1.0);
        let (mut read, mut powers) = layout.units(name, &scaled)?;
        let has_velocity = columns.has(Role::V);
        let (mut first, mut pending) = (first, layout.is_row.then_some(Next::Line));
        while pending.is_none() {
            let next = lines.read().map_err(|error| LogError::unreadable(name, &error))?;
            let (line, place) = (lines.text(), (name, lines.number()));
            let is_row = next != Next::Line || !(blank(line) || line.starts_with(b"#"));
            if next == Next::Line
                && take_units(&layout, line, place, &scaled, &mut read, &mut powers)?
            {
                break;
            }
            if is_row {
                (first, pending) = (line.to_vec(), Some(next));
            }
        }
        let row = RowReader::new(layout, factors, powers, has_velocity);
        Ok(Self { lines, row, columns: read, first, pending })
    }

    /// The columns as they are read.
    pub(crate) fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Whether the numbers so far have decimal commas.
    pub(crate) fn has_decimal_commas(&self) -> bool {
        self.row.mark() == Some(Mark::Comma)
    }

    /// The next row; none at the end.
    pub(crate) fn read(&mut self) -> io::Result<Option<Entry<'_>>> {
        let next = match self.pending.take() {
            Some(Next::Line) => return Ok(Some(self.row.read(&self.first, self.lines.number()))),
            Some(next) => next,
            None => loop {
                match self.lines.read()? {
                    Next::Line if blank(self.lines.text()) => {}
                    next => break next,
                }
            },
        };
        let line = self.lines.number();
        Ok(match next {
            Next::Line => Some(self.row.read(self.lines.text(), line)),
            Next::TooLong => {
                Some(Entry::Bad(Bad { line, reason: Reason::TooLong, time: None, force: None }))
            }
            Next::End => None,
        })
    }
}

/// Whether a line is empty, and so no row.
fn blank(line: &[u8]) -> bool {
    line.trim_ascii_start().is_empty()
}

/// The layout, and the line that it was read from unless that is a comment.
///
/// Lines that begin with `#` are comments, except for one that holds all the names: some programs write the names
/// behind such a sign.
fn head<R: Read>(
    lines: &mut Lines<R>,
    name: &str,
    columns: &Columns,
) -> Result<(Layout, Vec<u8>), LogError> {
    const EXPECTED: &str = "give a log of comma-separated values, as text with one row per line";
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
                return Err(LogError::about(name, "the log is empty").with_help(EXPECTED));
            }
        }
        let line = if at == 1 { line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line) } else { line };
        if blank(line) {
            continue;
        }
        match line.strip_prefix(b"#") {
            Some(_) if columns.numbered() => {}
            Some(comment) => {
                if let Ok(layout) = Layout::of(comment, columns, name, at) {
                    return Ok((layout, Vec::new()));
                }
            }
            None => return Ok((Layout::of(line, columns, name, at)?, line.to_vec())),
        }
    }
}
