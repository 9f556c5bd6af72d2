//! Merge of a map's shards.

use std::cmp::Ordering;
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
    /// The caller did not want to go on.
    Stopped,
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
            Self::Stopped => f.write_str("the merge was stopped"),
        }
    }
}

impl std::error::Error for MergeError {}

impl<E: Into<CheckpointError>> From<E> for MergeError {
    fn from(error: E) -> Self {
        Self::Checkpoint(error.into())
    }
}

/// A map that is put together from its shards, one after the other.
#[derive(Debug)]
pub struct Merge<W: Write> {
    head: TableHeader,
    /// The table whose head that is.
    first: PathBuf,
    next: Shard,
    survey: Survey,
    out: BufWriter<W>,
    place: PathBuf,
}

impl<W: Write> Merge<W> {
    /// Begins the map, of which the table at `path` is a shard, in `out`, which is at `place`.
    ///
    /// # Errors
    /// A table that cannot be read; a place that cannot be written to.
    pub fn begin(path: &Path, out: W, place: &Path) -> Result<Self, MergeError> {
        let (_, head, grid, Shard { count, .. }) = open(path)?;
        let (next, survey) = (Shard { index: 0, count }, Survey::of(&grid));
        let (first, place) = (path.to_owned(), place.to_owned());
        let mut merge = Self { head, first, next, survey, out: BufWriter::new(out), place };
        merge.write(TableHeader::of(&grid, Shard::WHOLE).text().as_bytes())?;
        Ok(merge)
    }

    /// The rows at `path`, whose table is a shard of this map.
    fn opened(&self, path: &Path) -> Result<(BufReader<File>, Shard), MergeError> {
        let (rows, head, _, shard) = open(path)?;
        if !self.head.is_kin(&head) || shard.count != self.next.count {
            return Err(MergeError::Strangers(self.first.clone(), path.to_owned()));
        }
        Ok((rows, shard))
    }

    /// The map with the next shard, whose table is at `path`; `each` learns the outcomes of every cell, and `go_on` is polled
    /// now and then. A refused table ends the merge: some of it may be written.
    ///
    /// # Errors
    /// A table that is not the next shard, or not the whole of it; a place that cannot be written to; [`MergeError::Stopped`]
    /// if `go_on` returns false.
    pub fn add(
        mut self,
        path: &Path,
        go_on: &dyn Fn() -> bool,
        mut each: impl FnMut(&Grid, u64, &[Outcome]),
    ) -> Result<Self, MergeError> {
        let (rows, shard) = self.opened(path)?;
        match shard.index.cmp(&self.next.index) {
            Ordering::Less => return Err(MergeError::Twice(path.to_owned(), shard)),
            Ordering::Greater => return Err(MergeError::Missing(self.next)),
            Ordering::Equal => self.next.index += 1,
        }
        let grid = self.survey.grid().clone();
        let cells = shard.cells(grid.cells());
        let mut rows = Rows::new(rows, grid.clone(), cells.start);
        let wrong = |error| CheckpointError::Table(path.to_owned(), error);
        let mut cell = cells.start;
        while cell < cells.end {
            let read = rows.next_cells(cells.end - cell).map_err(wrong)?;
            if read.is_empty() {
                let (done, all) = (cell - cells.start, cells.end - cells.start);
                return Err(MergeError::Unfinished(path.to_owned(), done, all));
            }
            for outcomes in read {
                self.survey.add(cell, &outcomes);
                each(&grid, cell, &outcomes);
                cell += 1;
            }
            self.write(rows.text())?;
            if !go_on() {
                return Err(MergeError::Stopped);
            }
        }
        rows.end().map_err(wrong)?;
        Ok(self)
    }

    /// The survey of the map, once it is written.
    ///
    /// # Errors
    /// A shard that was not added; a place that cannot be written to.
    pub fn end(mut self) -> Result<Survey, MergeError> {
        if self.next.index < self.next.count {
            return Err(MergeError::Missing(self.next));
        }
        self.out.flush().map_err(|error| OutputError::new(&self.place, error))?;
        Ok(self.survey)
    }

    fn write(&mut self, text: &[u8]) -> Result<(), OutputError> {
        let written = self.out.write_all(text);
        written.map_err(|error| OutputError::new(&self.place, error))
    }
}

/// Writes the map of all shards at `paths`, in whatever order, to `out`, which is at `place`, and returns its survey; `go_on`
/// is polled now and then.
///
/// # Errors
/// Tables that do not make a whole map; a place that cannot be written to; [`MergeError::Stopped`] if `go_on` returns false.
pub fn merge(
    paths: &[PathBuf],
    out: &mut impl Write,
    place: &Path,
    go_on: &dyn Fn() -> bool,
) -> Result<Survey, MergeError> {
    let Some(first) = paths.first() else { return Err(MergeError::Missing(Shard::WHOLE)) };
    let mut merge = Merge::begin(first, out, place)?;
    let shard = |path| Ok((merge.opened(path)?.1.index, path));
    let mut shards =
        paths.iter().map(|path| shard(path)).collect::<Result<Vec<_>, MergeError>>()?;
    shards.sort_by_key(|(index, _)| *index);
    for (_, path) in shards {
        merge = merge.add(path, go_on, |_, _, _| ())?;
    }
    merge.end()
}

/// The rows of the table at `path`, its head, and of which grid and shard that is.
fn open(path: &Path) -> Result<(BufReader<File>, TableHeader, Grid, Shard), CheckpointError> {
    let wrong = |error| CheckpointError::Table(path.to_owned(), error);
    let file = File::open(path).map_err(|error| wrong(TableError::Unreadable(error)))?;
    let mut lines = BufReader::new(file);
    let head = TableHeader::read(&mut lines).map_err(wrong)?;
    let (grid, shard) = head.parse().map_err(wrong)?;
    Ok((lines, head, grid, shard))
}
