//! Rows as text that reads back exactly.

use std::borrow::Cow;
use std::io::{self, Write};

use crate::Row;

/// The names of the columns.
pub const COLUMNS: &str =
    "t,x,x_measured,v,f_env,f_ctl,f_out,f_act,observer,alpha,shortfall,accepted";

/// Writes rows as comma-separated values, the names of the columns first.
#[derive(Debug)]
pub struct Csv<W> {
    writer: W,
}

impl<W: Write> Csv<W> {
    /// Writes the names of the columns, with those of `further` ones at the end.
    ///
    /// # Errors
    /// What the writer cannot take.
    pub fn new(mut writer: W, further: &[String]) -> io::Result<Self> {
        write!(writer, "{COLUMNS}")?;
        further.iter().try_for_each(|name| write!(writer, ",{name}"))?;
        writeln!(writer)?;
        Ok(Self { writer })
    }

    /// Writes one row with its `further` numbers, each with as many digits as it takes to read it back exactly.
    ///
    /// # Errors
    /// What the writer cannot take.
    pub fn write(&mut self, row: &Row, further: impl IntoIterator<Item = f64>) -> io::Result<()> {
        for number in row.numbers() {
            // The sum turns -0.0 into 0.0.
            write!(self.writer, "{:?},", number + 0.0)?;
        }
        write!(self.writer, "{}", u8::from(row.accepted))?;
        further.into_iter().try_for_each(|number| write!(self.writer, ",{:?}", number + 0.0))?;
        writeln!(self.writer)
    }

    /// Hands back the writer.
    pub fn into_inner(self) -> W {
        self.writer
    }
}

/// A text as one cell of a table.
pub(crate) fn quoted(text: &str) -> Cow<'_, str> {
    if text.contains([',', '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", text.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(text)
    }
}
