//! Columns of a table.

use std::str::FromStr;

use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};

use crate::errors;

/// The most rows of a table.
pub(super) const MOST_ROWS: u64 = 10_000_000;

/// Column of a table.
#[derive(Clone, Debug)]
pub(crate) enum Column {
    /// Numbers; NaN where there is none.
    Numbers(Vec<f64>),
    /// Whole numbers, of which none is missing.
    Wholes(Vec<i64>),
    /// Truths, of which none is missing.
    Truths(Vec<bool>),
    /// Truths; none where it is not known.
    Judgements(Vec<Option<bool>>),
    Words(Words),
}

/// Columns of comma-separated values that do not hold numbers, by their names.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Kinds<'a> {
    pub(crate) wholes: &'a [&'a str],
    pub(crate) truths: &'a [&'a str],
    pub(crate) judgements: &'a [&'a str],
    pub(crate) words: &'a [&'a str],
}

/// Words of which most occur in many rows, and each is kept once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Words {
    known: Vec<String>,
    /// The place of each row's word among the known.
    rows: Vec<u32>,
}

impl Words {
    pub(crate) fn push(&mut self, word: &str) {
        // Most are like one of the last.
        let place = self.known.iter().rposition(|known| known == word).unwrap_or_else(|| {
            self.known.push(word.to_owned());
            self.known.len() - 1
        });
        self.rows.push(place as u32);
    }

    fn into_list(self, py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
        let known: Vec<_> = self.known.iter().map(|word| PyString::new(py, word)).collect();
        PyList::new(py, self.rows.iter().map(|row| &known[*row as usize]))
    }
}

impl<W: AsRef<str>> FromIterator<W> for Words {
    fn from_iter<I: IntoIterator<Item = W>>(words: I) -> Self {
        let mut all = Self::default();
        words.into_iter().for_each(|word| all.push(word.as_ref()));
        all
    }
}

/// Columns of a table with their names.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns(pub(crate) Vec<(String, Column)>);

impl Columns {
    /// The columns of comma-separated values as a command writes them: numbers, but for those that `kinds` names.
    pub(crate) fn of_csv(text: &str, kinds: Kinds<'_>) -> PyResult<Self> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names: Vec<String> =
            reader.headers().map_err(errors::internal)?.iter().map(str::to_owned).collect();
        let mut fields: Vec<Vec<String>> = vec![Vec::new(); names.len()];
        for row in reader.records() {
            let row = row.map_err(errors::internal)?;
            for (column, field) in fields.iter_mut().zip(&row) {
                column.push(field.to_owned());
            }
        }
        let columns = names.into_iter().zip(fields).map(|(name, fields)| {
            let column = Column::of(&name, &fields, kinds)?;
            Ok((name, column))
        });
        Ok(Self(columns.collect::<PyResult<_>>()?))
    }

    /// A dictionary: numbers as float64 arrays, whole ones as int64, truths as bool, words and judgements as lists.
    pub(crate) fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let table = PyDict::new(py);
        for (name, column) in self.0 {
            match column {
                Column::Numbers(numbers) => table.set_item(name, numbers.into_pyarray(py))?,
                Column::Wholes(wholes) => table.set_item(name, wholes.into_pyarray(py))?,
                Column::Truths(truths) => table.set_item(name, truths.into_pyarray(py))?,
                Column::Judgements(judged) => table.set_item(name, judged)?,
                Column::Words(words) => table.set_item(name, words.into_list(py)?)?,
            }
        }
        Ok(table)
    }
}

impl Column {
    /// The column called `name` of these fields, of which an empty one is none.
    fn of(name: &str, fields: &[String], kinds: Kinds<'_>) -> PyResult<Self> {
        let is_among = |names: &[&str]| names.contains(&name);
        if is_among(kinds.judgements) {
            let judged = fields.iter().map(|field| match field.is_empty() {
                true => Ok(None),
                false => read(name, field).map(Some),
            });
            return Ok(Self::Judgements(judged.collect::<PyResult<_>>()?));
        }
        if is_among(kinds.words) {
            return Ok(Self::Words(fields.iter().collect()));
        }
        if is_among(kinds.truths) {
            let truths = fields.iter().map(|field| read(name, field));
            return Ok(Self::Truths(truths.collect::<PyResult<_>>()?));
        }
        if is_among(kinds.wholes) {
            let wholes = fields.iter().map(|field| read(name, field));
            return Ok(Self::Wholes(wholes.collect::<PyResult<_>>()?));
        }
        let numbers = fields.iter().map(|field| match field.is_empty() {
            true => Ok(f64::NAN),
            false => read(name, field),
        });
        Ok(Self::Numbers(numbers.collect::<PyResult<_>>()?))
    }
}

/// The value that a field of the column `name` holds.
fn read<T: FromStr>(name: &str, field: &str) -> PyResult<T> {
    field
        .parse()
        .map_err(|_| errors::internal(format_args!("{field:?} cannot stand in the column {name}")))
}
