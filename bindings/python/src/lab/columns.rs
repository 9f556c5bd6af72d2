//! Columns of a table.

use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};

use crate::errors;

/// Column of a table.
#[derive(Clone, Debug)]
pub(crate) enum Column {
    /// Numbers; NaN where there is none.
    Numbers(Vec<f64>),
    Words(Words),
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
    /// The columns of comma-separated values as a command writes them: those called `words` hold words, all others numbers.
    pub(crate) fn of_csv(text: &str, words: &[&str]) -> PyResult<Self> {
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
            let column = match words.contains(&&name[..]) {
                true => Column::Words(fields.iter().collect()),
                false => Column::numbers(&name, &fields)?,
            };
            Ok((name, column))
        });
        Ok(Self(columns.collect::<PyResult<_>>()?))
    }

    /// A dictionary: numbers as float64 arrays, words as lists.
    pub(crate) fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let table = PyDict::new(py);
        for (name, column) in self.0 {
            match column {
                Column::Numbers(numbers) => table.set_item(name, numbers.into_pyarray(py))?,
                Column::Words(words) => table.set_item(name, words.into_list(py)?)?,
            }
        }
        Ok(table)
    }
}

impl Column {
    /// Numbers; an empty field is none.
    fn numbers(name: &str, fields: &[String]) -> PyResult<Self> {
        let number = |field: &String| match &field[..] {
            "" => Ok(f64::NAN),
            field => field.parse().map_err(|_| {
                errors::internal(format_args!("{field:?} is no number in the column {name}"))
            }),
        };
        Ok(Self::Numbers(fields.iter().map(number).collect::<PyResult<_>>()?))
    }
}
