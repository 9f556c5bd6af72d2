//! Columns of a table.

use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::errors;

/// Column of a table.
#[derive(Clone, Debug)]
pub(crate) enum Column {
    /// Numbers; NaN where there is none.
    Numbers(Vec<f64>),
    Words(Vec<String>),
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
                true => Column::Words(fields),
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
                Column::Words(words) => table.set_item(name, PyList::new(py, words)?)?,
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
