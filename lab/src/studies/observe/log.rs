//! Reader of the rows of a log, one by one.

use std::io::{self, Read};

use super::bad::{Bad, LARGEST, Reason};
use super::columns::{Columns, Role};
use super::error::ObserveError;
use super::fields::number;
use super::layout::Layout;
use super::lines::{Lines, Next};
use super::scale::Scale;

/// A good row, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub(crate) line: u64,
    pub(crate) t: f64,
    pub(crate) x: f64,
    pub(crate) f: f64,
    pub(crate) v: Option<f64>,
}

/// A row, good or bad.
#[derive(Debug, PartialEq)]
pub(crate) enum Entry<'a> {
    Good(Sample),
    Bad(Bad<'a>),
}

/// Reader of the rows of a log.
#[derive(Debug)]
pub(crate) struct Log<R> {
    lines: Lines<R>,
    row: RowReader,
    /// The first line, where it is itself a row.
    first: Option<Vec<u8>>,
    pending: bool,
}

impl<R: Read> Log<R> {
    /// Reads up to the names of the columns, or to the first row where there are no names.
    pub(crate) fn open(
        reader: R,
        name: &str,
        columns: &Columns,
        scales: &[Scale],
    ) -> Result<Self, ObserveError> {
        let mut lines = Lines::new(reader);
        let (layout, first) = head(&mut lines, name, columns)?;
        let mut factors = [1.0; 4];
        scales.iter().for_each(|scale| factors[scale.role.index()] *= scale.factor);
        let has_velocity = columns.has(Role::V);
        let pending = layout.is_row;
        let row = RowReader { layout, factors, has_velocity };
        Ok(Self { lines, row, first: pending.then_some(first), pending })
    }

    /// The next row; none at the end.
    pub(crate) fn read(&mut self) -> io::Result<Option<Entry<'_>>> {
        if std::mem::take(&mut self.pending)
            && let Some(first) = &self.first
        {
            return Ok(Some(self.row.read(first, self.lines.number())));
        }
        loop {
            match self.lines.read()? {
                Next::Line if blank(self.lines.text()) => {}
                Next::Line => break,
                Next::TooLong => {
                    let (line, reason) = (self.lines.number(), Reason::TooLong);
                    return Ok(Some(Entry::Bad(Bad { line, reason, time: None, force: None })));
                }
                Next::End => return Ok(None),
            }
        }
        Ok(Some(self.row.read(self.lines.text(), self.lines.number())))
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
) -> Result<(Layout, Vec<u8>), ObserveError> {
    const EXPECTED: &str = "give a log of comma-separated values, as text with one row per line";
    loop {
        let next = lines.read().map_err(|error| ObserveError::unreadable(name, &error))?;
        let (line, at) = (lines.text(), lines.number());
        match next {
            Next::Line => {}
            Next::TooLong => {
                let message = "this is no row: the line is longer than 256 KiB";
                return Err(ObserveError::at(name, at, message).with_help(EXPECTED));
            }
            Next::End => {
                return Err(ObserveError::about(name, "the log is empty").with_help(EXPECTED));
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

/// Parser of lines into samples.
#[derive(Debug)]
struct RowReader {
    layout: Layout,
    factors: [f64; 4],
    has_velocity: bool,
}

impl RowReader {
    fn read<'a>(&self, text: &'a [u8], line: u64) -> Entry<'a> {
        let fields = match self.layout.pick(text) {
            Ok(fields) => fields,
            Err(reason) => return Entry::Bad(Bad { line, reason, time: None, force: None }),
        };
        match self.sample(&fields, line) {
            Ok(sample) => Entry::Good(sample),
            Err(reason) => {
                let told = |role| self.value(role, &fields).ok();
                Entry::Bad(Bad { line, reason, time: told(Role::T), force: told(Role::F) })
            }
        }
    }

    fn sample<'a>(&self, fields: &[&'a [u8]; 4], line: u64) -> Result<Sample, Reason<'a>> {
        let [t, x, f] = [Role::T, Role::X, Role::F].map(|role| self.value(role, fields));
        let v = self.has_velocity.then(|| self.value(Role::V, fields)).transpose();
        Ok(Sample { line, t: t?, x: x?, f: f?, v: v? })
    }

    /// The value of a column in SI units.
    fn value<'a>(&self, role: Role, fields: &[&'a [u8]; 4]) -> Result<f64, Reason<'a>> {
        let field = fields[role.index()];
        let number = number(field).ok_or(Reason::Number { role, field })?;
        let value = number * self.factors[role.index()];
        if value.abs() <= LARGEST { Ok(value) } else { Err(Reason::Range { role, field }) }
    }
}
