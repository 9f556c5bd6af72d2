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
    /// The columns of comma-separated values as a command writes them.
    pub(crate) fn of_csv(text: &str) -> PyResult<Self> {
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let names: Vec<String> =
            reader.headers().map_err(errors::internal)?.iter().map(str::to_owned).collect();
        let mut words: Vec<Vec<String>> = vec![Vec::new(); names.len()];
        for row in reader.records() {
            let row = row.map_err(errors::internal)?;
            for (column, field) in words.iter_mut().zip(&row) {
                column.push(field.to_owned());
            }
        }
        Ok(Self(names.into_iter().zip(words.into_iter().map(Column::of)).collect()))
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
    /// Numbers if every field that is not empty is one, and one is there.
    fn of(words: Vec<String>) -> Self {
        let number = |word: &String| match &word[..] {
            "" => Some(f64::NAN),
            word => word.parse().ok(),
        };
        let numbers: Option<Vec<f64>> = words.iter().map(number).collect();
        match numbers.filter(|numbers| numbers.iter().any(|it| !it.is_nan())) {
            Some(numbers) => Self::Numbers(numbers),
            None => Self::Words(words),
        }
    }
}
