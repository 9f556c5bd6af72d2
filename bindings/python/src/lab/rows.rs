//! Rows of a run as columns, for which room is taken before the run.

use lyapunov_lab::{RowFile, scene as lab};
use pyo3::exceptions::PyMemoryError;

use super::columns::{Column, Columns, MOST_ROWS};
use super::work::Fault;

/// The column of truths.
const ACCEPTED: &str = "accepted";

/// Rows of a run.
#[derive(Debug)]
pub(super) struct Rows(Vec<(String, Column)>);

impl Rows {
    /// Room for all rows of a run of `scene`, or for none if they are not `kept`.
    pub(super) fn of(scene: &lab::Scene, kept: bool) -> Result<Self, Fault> {
        if !kept {
            return Ok(Self(Vec::new()));
        }
        // The tick at 0 s is one more.
        let rows = scene.ticks() + 1;
        let names: Vec<String> = RowFile::of(scene).columns.into_iter().map(|it| it.name).collect();
        let told = |problem: &str| {
            let bytes = rows as f64 * size(&names) as f64;
            format!(
                "{problem}: the run has {rows} rows, of {} columns, {:.3} GB in all\n  = give rows=False, which leaves the rows out, or a \
                 shorter duration; `python -m lyapunov run SCENE --csv FILE` writes them into a file as it runs",
                names.len(),
                1e-9 * bytes
            )
        };
        if rows > MOST_ROWS {
            return Err(Fault::input(told(&format!("a table has at most {MOST_ROWS} rows"))));
        }
        let columns = names.iter().map(|name| Some((name.clone(), room(name, rows as usize)?)));
        let columns: Option<Vec<_>> = columns.collect();
        columns.map(Self).ok_or_else(|| {
            Fault::Raised(PyMemoryError::new_err(told("there is no memory for the table")))
        })
    }

    /// Adds a row, with 1 for what is true and 0 for what is not.
    pub(super) fn add(&mut self, numbers: impl Iterator<Item = f64>) {
        for ((_, column), number) in self.0.iter_mut().zip(numbers) {
            match column {
                Column::Truths(truths) => truths.push(number != 0.0),
                Column::Numbers(numbers) => numbers.push(number),
                _ => unreachable!("rows are numbers and truths"),
            }
        }
    }

    /// The columns.
    pub(super) fn columns(self) -> Columns {
        Columns(self.0)
    }
}

/// The bytes of a row.
fn size(names: &[String]) -> usize {
    names.iter().map(|name| if name == ACCEPTED { 1 } else { size_of::<f64>() }).sum()
}

/// An empty column with room for `rows`; none where there is no memory.
fn room(name: &str, rows: usize) -> Option<Column> {
    fn of<T>(rows: usize) -> Option<Vec<T>> {
        let mut column = Vec::new();
        column.try_reserve_exact(rows).ok().map(|()| column)
    }
    match name {
        ACCEPTED => of(rows).map(Column::Truths),
        _ => of(rows).map(Column::Numbers),
    }
}
