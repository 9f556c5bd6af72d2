//! Reader of the rows of a log, one by one.

use std::io::{self, Read};

use super::bad::{Bad, LARGEST, Reason, SHORTEST};
use super::columns::{Column, Columns, Role};
use super::error::ObserveError;
use super::layout::Layout;
use super::lines::{Lines, Next};
use super::notation::{Fault, Mark, Notation};
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

impl Sample {
    /// Whether `later` comes after this row, by more than a division by the time between them can bear.
    pub(crate) fn is_before(&self, later: &Self) -> bool {
        later.t - self.t >= SHORTEST
    }
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
    columns: Vec<Column>,
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
        let (mut factors, mut scaled) = ([1.0; 4], [false; 4]);
        for Scale { role, factor } in scales {
            factors[role.index()] *= factor;
            scaled[role.index()] = true;
        }
        let (read, powers) = layout.units(name, &factors, &scaled)?;
        let has_velocity = columns.has(Role::V);
        let pending = layout.is_row;
        let notation = Notation::of(layout.delimiter);
        let row = RowReader { layout, factors, powers, notation, has_velocity };
        Ok(Self { lines, row, columns: read, first: pending.then_some(first), pending })
    }

    /// The columns as they are read.
    pub(crate) fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Whether the numbers so far have decimal commas.
    pub(crate) fn has_decimal_commas(&self) -> bool {
        self.row.notation.mark() == Some(Mark::Comma)
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
    /// Powers of ten from the units of the headings.
    powers: [i32; 4],
    notation: Notation,
    has_velocity: bool,
}

impl RowReader {
    fn read<'a>(&mut self, text: &'a [u8], line: u64) -> Entry<'a> {
        let fields = match self.layout.pick(text) {
            Ok(fields) => fields,
            Err(reason) => return Entry::Bad(Bad { line, reason, time: None, force: None }),
        };
        match self.sample(&fields, line) {
            Ok(sample) => Entry::Good(sample),
            Err(reason) => {
                let [time, force] = [Role::T, Role::F].map(|role| self.value(role, &fields).ok());
                Entry::Bad(Bad { line, reason, time, force })
            }
        }
    }

    fn sample<'a>(&mut self, fields: &[&'a [u8]; 4], line: u64) -> Result<Sample, Reason<'a>> {
        let [t, x, f] = [Role::T, Role::X, Role::F].map(|role| self.value(role, fields));
        let v = self.has_velocity.then(|| self.value(Role::V, fields)).transpose();
        Ok(Sample { line, t: t?, x: x?, f: f?, v: v? })
    }

    /// The value of a column in SI units.
    fn value<'a>(&mut self, role: Role, fields: &[&'a [u8]; 4]) -> Result<f64, Reason<'a>> {
        let field = fields[role.index()];
        let number = self.notation.read(field, self.powers[role.index()]);
        let number = number.map_err(|fault| match fault {
            Fault::NoNumber => Reason::Number { role, field },
            Fault::OtherMark(known) => Reason::Mark { role, field, known },
        })?;
        let value = number * self.factors[role.index()];
        if value.abs() <= LARGEST { Ok(value) } else { Err(Reason::Range { role, field }) }
    }
}
