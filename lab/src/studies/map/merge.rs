//! Merge of a map's shards.

use std::fmt;
use std::fs::File;
use std::io::{BufReader, Write};
use std::path::{Path, PathBuf};

use super::checkpoint::CheckpointError;
use super::grid::Grid;
use super::shard::Shard;
use super::survey::Survey;
use super::table::{self, Rows, TableError, TableHeader};
use crate::show::OutputError;
use crate::show::csv::Records;

/// Reason why shards do not make a map.
#[derive(Debug)]
pub enum MergeError {
    /// A shard that cannot be read, or a place that cannot be written to.
    Checkpoint(CheckpointError),
    /// Two tables that are not of the same map.
    Strangers(PathBuf, PathBuf),
    /// A shard that is there twice.
    Twice(PathBuf, Shard),
    /// A shard that is not there.
    Missing(Shard),
    /// A shard that is not finished.
    Unfinished(PathBuf, u64, u64),
}

impl fmt::Display for MergeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Checkpoint(error) => error.fmt(f),
            Self::Strangers(one, other) => write!(
                f,
                "{} and {} are not of the same map\n  = merge shards of one scene with the same axes and stabilizers",
                one.display(),
                other.display()
            ),
            Self::Twice(path, shard) => {
                write!(f, "{} is shard {shard} once more\n  = name each shard once", path.display())
            }
            Self::Missing(shard) => {
                write!(f, "shard {shard} is missing\n  = name all of them, or run what is not done")
            }
            Self::Unfinished(path, done, all) => write!(
                f,
                "{} has {done} of {all} cells\n  = finish it with --resume, then merge",
                path.display()
            ),
        }
    }
}

impl std::error::Error for MergeError {}

impl<E: Into<CheckpointError>> From<E> for MergeError {
    fn from(error: E) -> Self {
        Self::Checkpoint(error.into())
    }
}

/// Writes the map of all shards at `paths` to `out`, which is at `place`, and returns its survey.
///
/// # Errors
/// Tables that do not make a whole map; a place that cannot be written to.
pub fn merge(paths: &[PathBuf], out: &mut impl Write, place: &Path) -> Result<Survey, MergeError> {
    let mut shards = Vec::new();
    for path in paths {
        let (_, head) = open(path)?;
        let (grid, shard) =
            head.parse().map_err(|error| CheckpointError::Table(path.clone(), error))?;
        shards.push((path, head, grid, shard));
    }
    let Some((first, head, grid, shard)) = shards.first() else {
        return Err(MergeError::Missing(Shard::WHOLE));
    };
    for (path, other, _, other_shard) in &shards {
        if !head.is_kin(other) || shard.count != other_shard.count {
            return Err(MergeError::Strangers((*first).clone(), (*path).clone()));
        }
    }
    let mut survey = Survey::of(grid);
    let whole = TableHeader::of(grid, Shard::WHOLE);
    let count = shard.count;
    out.write_all(whole.text().as_bytes()).map_err(|error| OutputError::new(place, error))?;
    let mut rows = Records::new(&mut *out);
    for index in 0..count {
        let shard = Shard { index, count };
        let mut these = shards.iter().filter(|(.., one)| *one == shard);
        let Some((path, ..)) = these.next() else { return Err(MergeError::Missing(shard)) };
        if let Some((path, ..)) = these.next() {
            return Err(MergeError::Twice((*path).clone(), shard));
        }
        append(path, grid, shard, &mut survey, &mut rows, place)?;
    }
    let flushed = rows.into_inner().map(drop);
    flushed.map_err(|error| OutputError::new(place, error))?;
    Ok(survey)
}

fn append(
    path: &Path,
    grid: &Grid,
    shard: Shard,
    survey: &mut Survey,
    out: &mut Records<impl Write>,
    place: &Path,
) -> Result<(), MergeError> {
    let (lines, _) = open(path)?;
    let cells = shard.cells(grid.cells());
    let mut rows = Rows::new(lines, grid.clone(), cells.start);
    let wrong = |error| CheckpointError::Table(path.to_owned(), error);
    for cell in cells.clone() {
        let row = rows.next_cell().map_err(wrong)?;
        let Some((_, outcomes)) = row else {
            let (done, all) = (cell - cells.start, cells.end - cells.start);
            return Err(MergeError::Unfinished(path.to_owned(), done, all));
        };
        survey.add(cell, &outcomes);
        table::write(out, grid, cell, &outcomes).map_err(|error| OutputError::new(place, error))?;
    }
    Ok(rows.end().map_err(wrong)?)
}

fn open(path: &Path) -> Result<(BufReader<File>, TableHeader), CheckpointError> {
    let wrong = |error: TableError| CheckpointError::Table(path.to_owned(), error);
    let file = File::open(path).map_err(|error| wrong(TableError::Unreadable(error)))?;
    let mut lines = BufReader::new(file);
    let head = TableHeader::read(&mut lines).map_err(wrong)?;
    Ok((lines, head))
}
