//! Shards of a map: a share of its cells as a table, and all shares put together.

use std::fs::{self, File};
use std::mem;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::map::{Axis, Grid, Merge, MergeError, Run, Shard, TableHeader, rows};
use lyapunov_lab::{OutputError, sync_folder};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::map::{Rows, fault, grid_of, told};
use super::work::{Fault, wait};
use super::{Scene, Told};
use crate::errors;

/// The number of cells of a map, whose input is checked.
#[pyfunction]
pub(crate) fn map_cells(
    scene: &Bound<'_, Scene>,
    x: &str,
    y: &str,
    stabilizers: &str,
) -> PyResult<u64> {
    let (name, grid) = asked(scene, x, y, stabilizers)?;
    Run::of(&grid, Some(1)).map_err(|error| errors::input(format!("{name}: {error}")))?;
    Ok(grid.cells())
}

/// The head of the table of share `shard`, as i/n: two maps are alike if their heads are.
#[pyfunction]
pub(crate) fn shard_head(
    scene: &Bound<'_, Scene>,
    x: &str,
    y: &str,
    stabilizers: &str,
    shard: &str,
) -> PyResult<String> {
    let (_, grid) = asked(scene, x, y, stabilizers)?;
    let shard: Shard = shard.parse().map_err(errors::input)?;
    Ok(TableHeader::of(&grid, shard).text().to_owned())
}

/// The table of share `shard`, as i/n, the one that `lyapunov map --shard` writes; computed on one core.
#[pyfunction]
pub(crate) fn map_shard<'py>(
    py: Python<'py>,
    scene: &Bound<'_, Scene>,
    x: &str,
    y: &str,
    stabilizers: &str,
    shard: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let (name, grid) = asked(scene, x, y, stabilizers)?;
    let shard: Shard = shard.parse().map_err(errors::input)?;
    let table = wait(py, None, 1, move |watched| {
        let run = Run::of(&grid, Some(1)).map_err(|error| fault(&name, error))?;
        let mut table = TableHeader::of(&grid, shard).text().as_bytes().to_vec();
        let go_on = || watched.go_on().is_continue();
        run.cells(shard.cells(grid.cells()), &go_on, &mut |first, outcomes| {
            table.extend(rows(&grid, first, outcomes));
            Ok(())
        })
        .map_err(|error| fault(&name, error))?;
        Ok(table)
    })?;
    Ok(PyBytes::new(py, &table))
}

/// The grid of a map, after the name of its scene.
fn asked(scene: &Bound<'_, Scene>, x: &str, y: &str, names: &str) -> PyResult<(String, Grid)> {
    let Scene { scene, name } = scene.get().clone();
    let names: StabilizerNames = names.parse().map_err(errors::input)?;
    let axis = |text: &str| text.parse::<Axis>().map_err(errors::input);
    let grid = grid_of(&name, scene, axis(x)?, axis(y)?, &names)?;
    Ok((name, grid))
}

/// A map that is put together from the tables of its shards, one after the other.
#[pyclass(module = "lyapunov._lyapunov")]
pub(crate) struct MapMerge {
    path: PathBuf,
    /// The file while it is unfinished, and the process that began it: a fork of that leaves the file alone.
    part: PathBuf,
    process: u32,
    /// None where the last table was refused.
    begun: Option<Begun>,
}

struct Begun {
    merge: Merge<File>,
    rows: Rows,
    file: File,
}

/// The merges begun in this process, so that no two have one file.
static MERGES: AtomicU64 = AtomicU64::new(0);

#[pymethods]
impl MapMerge {
    /// Begins the map of which `table` is a shard, in a file that has the name `path` when it is complete.
    #[new]
    fn new(table: PathBuf, path: PathBuf) -> PyResult<Self> {
        let (number, process) = (MERGES.fetch_add(1, Ordering::Relaxed), process::id());
        let part = path.with_extension(format!("{process}.{number}.begun"));
        let refused = |error| errors::input(OutputError::new(&path, error));
        let out = File::create(&part).map_err(refused)?;
        // From here on its file is removed with it.
        let mut this = Self { path: path.clone(), part, process, begun: None };
        let file = out.try_clone().map_err(refused)?;
        let merge = Merge::begin(&table, out, &path).map_err(errors::input)?;
        this.begun = Some(Begun { merge, rows: Rows::default(), file });
        Ok(this)
    }

    /// Adds the next shard, whose table is at `table`.
    fn add(&mut self, py: Python<'_>, table: PathBuf) -> PyResult<()> {
        let Begun { merge, mut rows, file } = self.taken()?;
        self.begun = Some(wait(py, None, 1, move |watched| {
            let each = |grid: &_, cell, outcomes: &[_]| rows.add(grid, cell, outcomes);
            let go_on = || watched.go_on().is_continue();
            let merge = merge.add(&table, &go_on, each).map_err(|error| match error {
                MergeError::Stopped => Fault::Stopped,
                error => Fault::input(error),
            })?;
            Ok(Begun { merge, rows, file })
        })?);
        Ok(())
    }

    /// Ends the map, and tells it.
    fn end(&mut self, py: Python<'_>) -> PyResult<Told> {
        let Begun { merge, rows, file } = self.taken()?;
        let (part, path) = (self.part.clone(), self.path.clone());
        wait(py, None, 1, move |_| {
            let survey = merge.end().map_err(Fault::input)?;
            let folder = path.parent().unwrap_or(Path::new(""));
            let named = file
                .sync_all()
                .and_then(|()| fs::rename(part, &path))
                .and_then(|()| sync_folder(folder));
            named.map_err(|error| Fault::input(OutputError::new(&path, error)))?;
            Ok(Told { columns: rows.columns(survey.grid()).into(), ..told(&survey, None)? })
        })
    }
}

impl MapMerge {
    fn taken(&mut self) -> PyResult<Begun> {
        self.begun.take().ok_or_else(|| errors::input("the merge has ended: begin another"))
    }
}

impl Drop for MapMerge {
    fn drop(&mut self) {
        if process::id() == self.process {
            // A complete map has its own name by now, and nothing is left under this one.
            let _ = fs::remove_file(&self.part);
        } else {
            // To drop it would write its buffer, which the process that began it writes as well.
            mem::forget(self.begun.take());
        }
    }
}
