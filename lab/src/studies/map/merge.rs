//! Merge of a map's shards.

use std::fmt;
use std::fs::File;
use std::io::{BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::checkpoint::CheckpointError;
use super::grid::Grid;
use super::shard::Shard;
use super::survey::Survey;
use super::table::{Rows, TableHeader};
use super::table_error::TableError;
use crate::measure::runs::Outcome;
use crate::show::OutputError;

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

/// Writes the map of all shards at `paths` to `out`, which is at `place`, and returns its survey; `each` learns the outcomes of
/// every cell.
///
/// # Errors
/// Tables that do not make a whole map; a place that cannot be written to.
pub fn merge(
    paths: &[PathBuf],
    out: &mut impl Write,
    place: &Path,
    mut each: impl FnMut(&Grid, u64, &[Outcome]),
) -> Result<Survey, MergeError> {
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
    let unwritten = |error| OutputError::new(place, error);
    let mut out = BufWriter::new(out);
    out.write_all(whole.text().as_bytes()).map_err(unwritten)?;
    for index in 0..count {
        let shard = Shard { index, count };
        let mut these = shards.iter().filter(|(.., one)| *one == shard);
        let Some((path, ..)) = these.next() else { return Err(MergeError::Missing(shard)) };
        if let Some((path, ..)) = these.next() {
            return Err(MergeError::Twice((*path).clone(), shard));
        }
        let (lines, _) = open(path)?;
        let cells = shard.cells(grid.cells());
        let mut rows = Rows::new(lines, grid.clone(), cells.start);
        let wrong = |error| CheckpointError::Table((*path).clone(), error);
        let mut cell = cells.start;
        while cell < cells.end {
            let read = rows.next_cells(cells.end - cell).map_err(wrong)?;
            if read.is_empty() {
                let (done, all) = (cell - cells.start, cells.end - cells.start);
                return Err(MergeError::Unfinished((*path).clone(), done, all));
            }
            for outcomes in read {
                survey.add(cell, &outcomes);
                each(grid, cell, &outcomes);
                cell += 1;
            }
            out.write_all(rows.text().as_bytes()).map_err(unwritten)?;
        }
        rows.end().map_err(wrong)?;
    }
    out.flush().map_err(unwritten)?;
    Ok(survey)
}

fn open(path: &Path) -> Result<(BufReader<File>, TableHeader), CheckpointError> {
    let wrong = |error: TableError| CheckpointError::Table(path.to_owned(), error);
    let file = File::open(path).map_err(|error| wrong(TableError::Unreadable(error)))?;
    let mut lines = BufReader::new(file);
    let head = TableHeader::read(&mut lines).map_err(wrong)?;
    Ok((lines, head))
}
