//! The table of an unfinished map.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufReader, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::grid::Grid;
use super::outcome::Outcome;
use super::shard::Shard;
use super::survey::Survey;
use super::table::{self, Rows, TableError, TableHeader};
use crate::show::OutputError;
use crate::show::csv::Records;

/// A table that grows by whole cells under a temporary name, and takes its final name when it is finished.
#[derive(Debug)]
pub struct Checkpoint {
    part: PathBuf,
    path: PathBuf,
    file: File,
    next: u64,
}

/// Reason why a table cannot be begun or resumed.
#[derive(Debug)]
pub enum CheckpointError {
    /// There is an unfinished table already.
    Unfinished(PathBuf),
    /// The file there is the table of another map.
    Another(PathBuf),
    /// The file there is no table, or one with a wrong row.
    Table(PathBuf, TableError),
    /// The place cannot be written to.
    Output(OutputError),
}

impl From<OutputError> for CheckpointError {
    fn from(error: OutputError) -> Self {
        Self::Output(error)
    }
}

impl fmt::Display for CheckpointError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unfinished(path) => write!(
                f,
                "{} is an unfinished map\n  = go on with --resume, or remove it, or choose another folder",
                path.display()
            ),
            Self::Another(path) => write!(
                f,
                "{} is of another map: its scene, axes, stabilizers or shard differ\n  = \
                 resume with the scene and the arguments that it was begun with, or choose another folder",
                path.display()
            ),
            Self::Table(path, error) => {
                let remedy = match error {
                    TableError::Columns(_) => "compute the map anew, in another folder",
                    _ => "give a table that lyapunov map wrote, as it wrote it",
                };
                write!(f, "{}: {error}\n  = {remedy}", path.display())
            }
            Self::Output(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for CheckpointError {}

/// File name of a shard's table.
pub(super) fn name(shard: Shard) -> String {
    if shard == Shard::WHOLE {
        "map.csv".to_owned()
    } else {
        format!("map-{}-of-{}.csv", shard.index, shard.count)
    }
}

impl Checkpoint {
    /// Begins the table of `shard` of `grid` in `folder`, or resumes the one that is there if `resume` is set, and adds
    /// the cells that it has to `survey`.
    ///
    /// # Errors
    /// An unfinished table without `resume`, the table of another map, and a place that cannot be written to.
    pub fn open(
        folder: &Path,
        grid: &Grid,
        shard: Shard,
        resume: bool,
        survey: &mut Survey,
    ) -> Result<Self, CheckpointError> {
        let path = folder.join(name(shard));
        let part = path.with_extension("part.csv");
        let cells = shard.cells(grid.cells());
        let head = TableHeader::of(grid, shard);
        let refuse = |error| OutputError::new(&part, error);
        if part.exists() {
            if !resume {
                return Err(CheckpointError::Unfinished(part));
            }
            let (next, bytes) = read(&part, grid, &head, &cells, survey)?;
            let mut file = File::options().write(true).open(&part).map_err(refuse)?;
            // A cell that was cut off is written anew.
            file.set_len(bytes).map_err(refuse)?;
            file.seek(SeekFrom::End(0)).map_err(refuse)?;
            return Ok(Self { part, path, file, next });
        }
        let mut file = File::options().write(true).create_new(true).open(&part).map_err(refuse)?;
        file.write_all(head.text().as_bytes()).map_err(refuse)?;
        Ok(Self { part, path, file, next: cells.start })
    }

    /// The next cell to come.
    pub fn next(&self) -> u64 {
        self.next
    }

    /// The path of the unfinished table.
    pub fn part(&self) -> &Path {
        &self.part
    }

    /// Writes the next cells.
    ///
    /// # Errors
    /// An error of the file system; rows written before stay.
    pub fn put(&mut self, grid: &Grid, outcomes: &[Vec<Outcome>]) -> Result<(), OutputError> {
        let refuse = |error| OutputError::new(&self.part, error);
        let mut rows = Records::new(Vec::new());
        for (cell, outcomes) in (self.next..).zip(outcomes) {
            table::write(&mut rows, grid, cell, outcomes).map_err(refuse)?;
        }
        self.file.write_all(&rows.into_inner().map_err(refuse)?).map_err(refuse)?;
        self.next += outcomes.len() as u64;
        Ok(())
    }

    /// Gives the table its final name.
    ///
    /// # Errors
    /// An error of the file system; the table then stays unfinished.
    pub fn finish(self) -> Result<PathBuf, OutputError> {
        let refuse = |error| OutputError::new(&self.path, error);
        self.file.sync_all().map_err(refuse)?;
        fs::rename(&self.part, &self.path).map_err(refuse)?;
        Ok(self.path)
    }
}

/// Adds the cells of the table at `path` to `survey`. Returns the cell after the last whole one, and the bytes up
/// to it.
pub(super) fn read(
    path: &Path,
    grid: &Grid,
    head: &TableHeader,
    cells: &Range<u64>,
    survey: &mut Survey,
) -> Result<(u64, u64), CheckpointError> {
    let wrong = |error: TableError| CheckpointError::Table(path.to_owned(), error);
    let unreadable = |error: io::Error| wrong(TableError::Unreadable(error));
    let mut lines = BufReader::new(File::open(path).map_err(unreadable)?);
    let found = TableHeader::read(&mut lines).map_err(wrong)?;
    if found != *head {
        return Err(CheckpointError::Another(path.to_owned()));
    }
    let mut rows = Rows::new(lines, grid.clone(), cells.start);
    let mut next = cells.start;
    while next < cells.end {
        let Some((cell, outcomes)) = rows.next_cell().map_err(wrong)? else { break };
        survey.add(cell, &outcomes);
        next = cell + 1;
    }
    Ok((next, head.text().len() as u64 + rows.bytes()))
}
