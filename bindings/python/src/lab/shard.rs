//! Shards of a map: a share of its cells as a table, and all shares put together.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::map::{Axis, Checkpoint, Run, Shard, Survey, TableHeader, merge, table_name};
use pyo3::prelude::*;

use super::map::{Rows, fault, grid_of, told};
use super::work::{Fault, wait};
use super::{Scene, Told};
use crate::errors;

/// The number of cells of a map, whose input is checked, and the head of the table of share `shard`, as i/n: two maps are
/// alike if their heads are.
#[pyfunction]
pub(crate) fn shard_head(
    scene: &Bound<'_, Scene>,
    x: &str,
    y: &str,
    stabilizers: &str,
    shard: &str,
) -> PyResult<(u64, String)> {
    let Scene { scene, name } = scene.get().clone();
    let names: StabilizerNames = stabilizers.parse().map_err(errors::input)?;
    let axes: [Axis; 2] = [x.parse().map_err(errors::input)?, y.parse().map_err(errors::input)?];
    let [x, y] = axes;
    let grid = grid_of(&name, scene, x, y, &names)?;
    Run::of(&grid, Some(1)).map_err(|error| errors::input(format!("{name}: {error}")))?;
    let shard: Shard = shard.parse().map_err(errors::input)?;
    Ok((grid.cells(), TableHeader::of(&grid, shard).text().to_owned()))
}

/// Computes share `shard`, as i/n, into `folder`; returns the name of its table there, the one that `lyapunov map --shard`
/// writes.
#[pyfunction]
#[pyo3(signature = (scene, x, y, stabilizers, shard, folder, threads=None))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn map_shard(
    py: Python<'_>,
    scene: &Bound<'_, Scene>,
    x: &str,
    y: &str,
    stabilizers: &str,
    shard: &str,
    folder: PathBuf,
    threads: Option<usize>,
) -> PyResult<String> {
    let Scene { scene, name } = scene.get().clone();
    let names: StabilizerNames = stabilizers.parse().map_err(errors::input)?;
    let axes: [Axis; 2] = [x.parse().map_err(errors::input)?, y.parse().map_err(errors::input)?];
    let shard: Shard = shard.parse().map_err(errors::input)?;
    let [x, y] = axes;
    let grid = grid_of(&name, scene, x, y, &names)?;
    wait(py, None, 1, move |watched| {
        let run = Run::of(&grid, threads).map_err(|error| fault(&name, error))?;
        let mut survey = Survey::of(&grid);
        let opened = Checkpoint::open(&folder, &grid, shard, true, &mut survey);
        let mut checkpoint = opened.map_err(Fault::input)?;
        let cells = checkpoint.next()..shard.cells(grid.cells()).end;
        let go_on = || watched.go_on().is_continue();
        run.cells(cells, &go_on, &mut |_, outcomes| checkpoint.put(&grid, outcomes))
            .map_err(|error| fault(&name, error))?;
        let table = table_name(shard);
        write_whole(&folder.join(&table), |file, place| {
            checkpoint.write_table(file, place).map_err(Fault::input)
        })?;
        checkpoint.remove().map_err(Fault::input)?;
        Ok(table)
    })
}

/// Puts the tables of all shards together into the table at `path`, and tells the map.
#[pyfunction]
pub(crate) fn map_merge(py: Python<'_>, tables: Vec<PathBuf>, path: PathBuf) -> PyResult<Told> {
    wait(py, None, 1, move |_| {
        let (mut survey, mut rows) = (None, Rows::default());
        write_whole(&path, |file, place| {
            let each = |grid: &_, cell, outcomes: &[_]| rows.add(grid, cell, outcomes);
            survey = Some(merge(&tables, file, place, each).map_err(Fault::input)?);
            Ok(())
        })?;
        let survey = survey.ok_or_else(|| Fault::internal("there is no map"))?;
        Ok(Told { columns: rows.columns(survey.grid()), ..told(&survey, None)? })
    })
}

/// Writes the file at `path` under another name, and names it when it is complete.
fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut File, &Path) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let refused = |error: std::io::Error| {
        Fault::input(format_args!("{} cannot be written: {error}", path.display()))
    };
    let begun = path.with_extension(format!("{}.begun", std::process::id()));
    let mut file = File::create(&begun).map_err(refused)?;
    write(&mut file, path)?;
    file.sync_all().map_err(refused)?;
    fs::rename(&begun, path).map_err(refused)
}
