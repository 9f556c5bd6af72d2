//! Logs of any device: rows of time, position and force, read one by one in memory that does not grow.

mod axes;
mod bad;
mod columns;
mod error;
mod fields;
mod head;
mod heading;
mod layout;
mod lines;
mod notation;
mod opened;
mod row;
mod sample;
mod scale;
mod stamp;
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

use head::Head;
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
    unread_axes: Option<String>,
    /// The first row, where it was read while the log was opened.
    first: Vec<u8>,
    /// The kind of that row until it is told.
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
        if let Some(scale) = scales.iter().find(|scale| !columns.has(scale.role)) {
            let letter = scale.role.letter();
            return Err(LogError::new(format!("there is no column of {letter} to scale"))
                .with_help("name it as the fourth of --columns, or leave its --scale out"));
        }
        let mut lines = Lines::new(reader);
        let Head { layout, below, mut first } = Head::read(&mut lines, name, columns)?;
        let (mut factors, mut scaled) = ([1.0; 4], [false; 4]);
        for Scale { role, factor } in scales {
            factors[role.index()] *= factor;
            scaled[role.index()] = true;
        }
        // A factor of −1 turns the sign and leaves the unit.
        let scaled = std::array::from_fn(|at| scaled[at] && factors[at] != -1.0);
        let (mut read, mut powers) = layout.units(name, &scaled)?;
        let has_velocity = columns.has(Role::V);
        let mut take = |line: &[u8], at| {
            take_units(&layout, line, (name, at), &scaled, &mut read, &mut powers)
        };
        let mut has_units = match &below {
            Some((at, comment)) => take(comment, *at)?,
            None => false,
        };
        let mut pending = (!first.is_empty()).then_some(Next::Line);
        while pending.is_none() && !has_units {
            let next = lines.read().map_err(|error| LogError::unreadable(name, &error))?;
            let line = lines.text();
            has_units = next == Next::Line && take(line, lines.number())?;
            if next != Next::Line || !(has_units || blank(line) || line.starts_with(b"#")) {
                (first, pending) = (line.to_vec(), Some(next));
            }
        }
        let unread_axes = layout.unread_axes.clone();
        let row = RowReader::new(layout, factors, powers, has_velocity);
        Ok(Self { lines, row, columns: read, unread_axes, first, pending })
    }

    /// The columns as they are read.
    pub(crate) fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// A sentence about axes whose columns are not read; none without them.
    pub(crate) fn unread_axes(&self) -> Option<&str> {
        self.unread_axes.as_deref()
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
