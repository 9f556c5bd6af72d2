//! The table of an unfinished map.

use std::fmt;
use std::fs::{File, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::grid::Grid;
use super::shard::Shard;
use super::survey::Survey;
use super::table::{self, Rows, TableHeader};
use super::table_error::TableError;
use crate::measure::runs::Outcome;
use crate::show::{OutputError, sync_folder};
use crate::text::Checksum;

/// The cells whose rows one thread writes at once.
const SHARE: usize = 1024;

/// A table that grows by whole cells, each row with its checksum, until the finished one is written from it.
///
/// The file is locked while it is open: another process that wants to go on with it is refused.
#[derive(Debug)]
pub struct Checkpoint {
    part: PathBuf,
    file: File,
    head: TableHeader,
    next: u64,
}

/// Reason why a table cannot be begun or resumed.
#[derive(Debug)]
pub enum CheckpointError {
    /// There is an unfinished table already.
    Unfinished(PathBuf),
    /// Another process works on the table.
    InUse(PathBuf),
    /// The file there is the table of another map.
    Another(PathBuf),
    /// The file there is no table, or one with a wrong row.
    Table(PathBuf, TableError),
    /// The place cannot be written to.
    Output(OutputError),
    /// The caller did not want to go on; the unfinished table is as it was.
    Stopped(PathBuf),
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
            Self::InUse(path) => write!(
                f,
                "{} is in use: another process computes this map\n  = wait for its end, or choose another folder",
                path.display()
            ),
            Self::Another(path) => write!(
                f,
                "{} is of another map: its scene, recorded motion, axes, stabilizers or shard differ\n  = \
                 resume with the files and the arguments that it was begun with, or choose another folder",
                path.display()
            ),
            Self::Table(path, error) => {
                let remedy = match error {
                    TableError::Columns(_) => "compute the map anew, in another folder",
                    TableError::Damaged { .. } => {
                        "remove it to compute the map anew, or its rows from that one on to keep those before"
                    }
                    _ => "give a table that lyapunov map wrote, as it wrote it",
                };
                write!(f, "{}: {error}\n  = {remedy}", path.display())
            }
            Self::Output(error) => error.fmt(f),
            Self::Stopped(path) => write!(
                f,
                "interrupted while {} was read, which is as it was\n  = go on with --resume",
                path.display()
            ),
        }
    }
}

impl std::error::Error for CheckpointError {}

/// File name of a shard's table.
pub fn table_name(shard: Shard) -> String {
    if shard == Shard::WHOLE {
        "map.csv".to_owned()
    } else {
        format!("map-{}-of-{}.csv", shard.index, shard.count)
    }
}

/// File name of a shard's table while it is unfinished.
fn part_name(shard: Shard) -> String {
    table_name(shard).replace(".csv", ".part.csv")
}

impl Checkpoint {
    /// Begins the table of `shard` of `grid` in `folder`, or resumes the one that is there if `resume` is set, and adds
    /// the cells that it has to `survey`; polls `go_on` now and then.
    ///
    /// # Errors
    /// An unfinished table without `resume`, one that another process works on, the table of another map, a row that was
    /// changed, a place that cannot be written to, and [`CheckpointError::Stopped`] if `go_on` returns false.
    pub fn open(
        folder: &Path,
        grid: &Grid,
        shard: Shard,
        resume: bool,
        survey: &mut Survey,
        go_on: &dyn Fn() -> bool,
    ) -> Result<Self, CheckpointError> {
        let part = folder.join(part_name(shard));
        let cells = shard.cells(grid.cells());
        let head = TableHeader::of(grid, shard);
        let refuse = |error| OutputError::new(&part, error);
        let is_there = part.exists();
        if is_there && !resume {
            return Err(CheckpointError::Unfinished(part));
        }
        if is_there && !part.is_file() {
            return Err(refuse(io::Error::other("it is no file")).into());
        }
        let mut options = File::options();
        let options = options.read(true).write(true).create_new(!is_there);
        let mut file = options.open(&part).map_err(refuse)?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(CheckpointError::InUse(part));
        }
        let begun =
            if is_there { read(&part, &file, grid, &head, &cells, survey, go_on)? } else { None };
        let text = head.unfinished_text();
        let (next, bytes) = begun.unwrap_or((cells.start, 0));
        // What was cut off is written anew.
        let begin = |file: &mut File| {
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            if begun.is_none() {
                file.write_all(text.as_bytes())?;
            }
            file.sync_all()?;
            sync_folder(folder)
        };
        begin(&mut file).map_err(refuse)?;
        Ok(Self { part, file, head, next })
    }

    /// The next cell to come.
    pub fn next(&self) -> u64 {
        self.next
    }

    /// The path of the unfinished table.
    pub fn part(&self) -> &Path {
        &self.part
    }

    /// Writes the next cells, and returns when they are on the disk; the threads of the current pool share in it.
    ///
    /// # Errors
    /// An error of the file system; rows written before stay.
    pub fn put(&mut self, grid: &Grid, outcomes: &[Vec<Outcome>]) -> Result<(), OutputError> {
        let refuse = |error| OutputError::new(&self.part, error);
        let seal = self.head.seal();
        let shares = outcomes.par_chunks(SHARE).enumerate().map(|(at, outcomes)| {
            sealed(&table::rows(grid, self.next + (at * SHARE) as u64, outcomes), seal)
        });
        let shares: Vec<Vec<u8>> = shares.collect();
        let write = |mut file: &File| {
            shares.iter().try_for_each(|rows| file.write_all(rows))?;
            file.sync_data()
        };
        write(&self.file).map_err(refuse)?;
        self.next += outcomes.len() as u64;
        Ok(())
    }

    /// Writes the finished table, which has no checksums, to `out`, which is at `place`; polls `go_on` now and then.
    ///
    /// # Errors
    /// A row that has changed since it was written, errors of the file system, and [`CheckpointError::Stopped`] if `go_on`
    /// returns false.
    pub fn write_table(
        &mut self,
        out: &mut impl Write,
        place: &Path,
        go_on: &dyn Fn() -> bool,
    ) -> Result<(), CheckpointError> {
        let wrong = |error: TableError| CheckpointError::Table(self.part.clone(), error);
        let unreadable = |error: io::Error| wrong(TableError::Unreadable(error));
        let refuse = |error| OutputError::new(place, error);
        (&self.file).seek(SeekFrom::Start(0)).map_err(unreadable)?;
        let mut lines = BufReader::new(&self.file);
        TableHeader::read_unfinished(&mut lines).map_err(wrong)?;
        out.write_all(self.head.text().as_bytes()).map_err(refuse)?;
        let (mut line, seal) = (Vec::new(), self.head.seal());
        for row in 1.. {
            if u64::is_multiple_of(row, SHARE as u64) && !go_on() {
                return Err(CheckpointError::Stopped(self.part.clone()));
            }
            line.clear();
            if !table::next_line(&mut lines, &mut line).map_err(unreadable)? {
                break;
            }
            let row =
                table::unsealed(&line, seal).ok_or(TableError::Damaged { row }).map_err(wrong)?;
            out.write_all(row).and_then(|()| out.write_all(b"\n")).map_err(refuse)?;
        }
        Ok(())
    }

    /// Removes the unfinished table, once the finished one has its name.
    ///
    /// # Errors
    /// An error of the file system; the unfinished table then stays beside the finished one.
    pub fn remove(self) -> Result<(), OutputError> {
        std::fs::remove_file(&self.part).map_err(|error| OutputError::new(&self.part, error))
    }
}

/// Rows with their checksums.
fn sealed(rows: &[u8], seal: Checksum) -> Vec<u8> {
    let mut sealed = Vec::with_capacity(rows.len() + rows.len() / 4);
    for row in rows.split(|byte| *byte == b'\n').filter(|row| !row.is_empty()) {
        sealed.extend_from_slice(row);
        // Writing to memory never fails.
        let _ = writeln!(sealed, ",{}", seal.and(row));
    }
    sealed
}

/// Adds the cells of the unfinished table at `path` to `survey`. Returns the cell after the last whole one, and the bytes
/// up to it; none if the table ends before its head does.
///
/// Rows at the end that do not have their checksums were being written when the machine stopped, and are left out. One that
/// others follow was changed, which is an error.
fn read(
    path: &Path,
    file: &File,
    grid: &Grid,
    head: &TableHeader,
    cells: &Range<u64>,
    survey: &mut Survey,
    go_on: &dyn Fn() -> bool,
) -> Result<Option<(u64, u64)>, CheckpointError> {
    let wrong = |error: TableError| CheckpointError::Table(path.to_owned(), error);
    let unreadable = |error: io::Error| wrong(TableError::Unreadable(error));
    let mut lines = BufReader::new(file);
    let expected = head.unfinished_text();
    if is_beginning(&mut lines, &expected).map_err(unreadable)? {
        return Ok(None);
    }
    lines.seek(SeekFrom::Start(0)).map_err(unreadable)?;
    if TableHeader::read_unfinished(&mut lines).map_err(wrong)? != *head {
        return Err(CheckpointError::Another(path.to_owned()));
    }
    let mut rows = Rows::unfinished(lines, grid.clone(), cells.start, head);
    let mut next = cells.start;
    while next < cells.end {
        if next.is_multiple_of(SHARE as u64) && !go_on() {
            return Err(CheckpointError::Stopped(path.to_owned()));
        }
        match rows.next_cell() {
            Ok(None) => break,
            Ok(Some((cell, outcomes))) => {
                survey.add(cell, &outcomes);
                next = cell + 1;
            }
            Err(error @ TableError::Damaged { .. }) => match rows.goes_on().map_err(wrong)? {
                true => return Err(wrong(error)),
                false => break,
            },
            Err(error) => return Err(wrong(error)),
        }
    }
    Ok(Some((next, expected.len() as u64 + rows.bytes())))
}

/// Whether all of `lines` is a beginning of `expected`, and shorter.
fn is_beginning(lines: &mut impl BufRead, expected: &str) -> io::Result<bool> {
    let mut found = Vec::new();
    lines.take(expected.len() as u64).read_to_end(&mut found)?;
    Ok(found.len() < expected.len() && expected.as_bytes().starts_with(&found))
}
