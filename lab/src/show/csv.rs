//! Comma-separated values: text is quoted where necessary, and every number reads back exactly.

use std::fmt::Write as _;
use std::io::{self, Write};

use serde::Serialize;

use crate::files::Scene;
use crate::simulate::row::{further_columns, further_numbers};
use crate::simulate::{Row, Space, Tick};

/// The names of the columns.
pub const COLUMNS: &str =
    "t,x,x_measured,v,f_env,f_ctl,f_out,f_act,observer,alpha,shortfall,accepted";

/// Writer of rows as comma-separated values, the names of the columns first.
#[derive(Debug)]
pub struct Csv<W: Write>(Records<W>);

impl<W: Write> Csv<W> {
    /// Writes the names of the columns of `scene`: those of [`Row`], the further axes of a space, and the operator's motion
    /// where a link sets it apart.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn of(writer: W, scene: &Scene) -> io::Result<Self> {
        let mut records = Records::new(writer);
        let further = further_columns(scene);
        let names = COLUMNS.split(',').chain(further.iter().map(String::as_str));
        records.put(names.map(Field::Text))?;
        Ok(Self(records))
    }

    /// Writes one tick, each number with as many digits as it needs to read back exactly.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write<V: Space>(&mut self, tick: &Tick<V>) -> io::Result<()> {
        // The sum turns -0.0 into 0.0.
        let number = |number: f64| Field::Number(number + 0.0);
        let row = Row::of(tick);
        let accepted = Field::Count(usize::from(row.accepted));
        let further = further_numbers(tick).map(number);
        self.0.put(row.numbers().into_iter().map(number).chain([accepted]).chain(further))
    }

    /// Flushes the writer and returns it.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner()
    }
}

/// Field of a record.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Field<'a> {
    Text(&'a str),
    Number(f64),
    Count(usize),
    Nothing,
}

impl From<Option<f64>> for Field<'_> {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Nothing, Self::Number)
    }
}

/// Writer of records with equally many fields.
#[derive(Debug)]
pub(crate) struct Records<W: Write> {
    writer: ::csv::Writer<W>,
    digits: String,
}

impl<W: Write> Records<W> {
    pub(crate) fn new(writer: W) -> Self {
        Self { writer: ::csv::Writer::from_writer(writer), digits: String::new() }
    }

    /// Writes one record.
    pub(crate) fn put<'a>(
        &mut self,
        fields: impl IntoIterator<Item = Field<'a>>,
    ) -> io::Result<()> {
        for field in fields {
            self.digits.clear();
            let _ = match field {
                Field::Text(text) => self.digits.write_str(text),
                Field::Number(number) => write!(self.digits, "{number:?}"),
                Field::Count(count) => write!(self.digits, "{count}"),
                Field::Nothing => Ok(()),
            };
            self.writer.write_field(&self.digits).map_err(plain)?;
        }
        self.writer.write_record(None::<&str>).map_err(plain)
    }

    /// Flushes the writer and returns it.
    pub(crate) fn into_inner(self) -> io::Result<W> {
        self.writer.into_inner().map_err(::csv::IntoInnerError::into_error)
    }
}

/// The error of the inner writer, with its kind.
fn plain(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ::csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// Records as text, the `names` of the columns first.
pub(crate) fn text<'a, R: IntoIterator<Item = Field<'a>>>(
    names: impl IntoIterator<Item = &'a str>,
    records: impl IntoIterator<Item = R>,
) -> String {
    let mut writer = Records::new(Vec::new());
    // Writing to memory never fails.
    let _ = writer.put(names.into_iter().map(Field::Text));
    let _ = records.into_iter().try_for_each(|record| writer.put(record));
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// Flat records with the names of their fields first; nothing without records.
pub(crate) fn records<T: Serialize>(records: impl IntoIterator<Item = T>) -> String {
    let mut writer = ::csv::Writer::from_writer(Vec::new());
    // Writing to memory never fails, and the records of this crate are flat.
    let _ = records.into_iter().try_for_each(|record| writer.serialize(record));
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// The same, each record after a text in a column called `name`.
pub(crate) fn named_records<'a, T: Serialize>(
    name: &str,
    named: impl IntoIterator<Item = (&'a str, T)>,
) -> String {
    let mut named = named.into_iter().peekable();
    // Names are found for flat records only.
    let names = named.peek().map(|(_, record)| records([record])).unwrap_or_default();
    let names = names.lines().next().unwrap_or_default().split(',');
    let mut writer = ::csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    // Writing to memory never fails.
    let _ = writer.write_record(std::iter::once(name).chain(names));
    let _ = named.try_for_each(|record| writer.serialize(record));
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The kind tells a reader that has enough from a full disk.
    #[test]
    fn an_error_keeps_its_kind() {
        struct Full;
        impl Write for Full {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                Err(io::ErrorKind::StorageFull.into())
            }

            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let mut records = Records::new(Full);
        let long = "x".repeat(1 << 16);
        let error = (0..3).find_map(|_| records.put([Field::Text(&long)]).err()).unwrap();
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        let mut records = Records::new(Full);
        records.put([Field::Text("short")]).unwrap();
        assert_eq!(records.into_inner().err().unwrap().kind(), io::ErrorKind::StorageFull);
    }

    #[test]
    fn written_records_read_back() {
        let name = "mine, \"fast\"\r\nand\tthin";
        let numbers = [-0.0, 0.1, 1e-7, 1e16, f64::MIN_POSITIVE, f64::MAX, f64::INFINITY];
        let fields = numbers.map(|number| [Field::Text(name), Field::Number(number)]);
        let text = text(["name", "number"], fields);
        let mut reader = ::csv::Reader::from_reader(text.as_bytes());
        let read: Vec<_> = reader.records().map(|record| record.unwrap()).collect();
        assert_eq!(read.len(), numbers.len());
        for (record, number) in read.iter().zip(numbers) {
            assert_eq!((&record[0], record.len()), (name, 2));
            assert_eq!(record[1].parse::<f64>().unwrap().to_bits(), number.to_bits());
        }
    }
}
