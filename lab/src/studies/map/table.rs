//! The table of a map: CSV with the scene in its head and a row for each cell and stabilizer, in the order of the
//! cells.
//!
//! It is the map's only file of numbers: cells in it need not be computed again. While it is unfinished its rows have one
//! column more, their checksum.

use std::fmt::Write as _;
use std::io::{self, BufRead, Read};

use rayon::prelude::*;

use super::axis::Axis;
use super::grid::Grid;
use super::shard::Shard;
use super::table_error::TableError;
use crate::files::Scene;
use crate::measure::runs::{Measure, Measures, Outcome};
use crate::measure::{Verdict, Yardstick};
use crate::show::csv::{self, Field, Records};
use crate::simulate::family::StabilizerNames;
use crate::text::Checksum;

/// The columns after those of the axes.
fn columns<'a>() -> impl Iterator<Item = &'a str> {
    let names = ["stabilizer", "verdict", "verdict_by"];
    names.into_iter().chain(Measure::ALL.map(|measure| measure.key))
}

/// The last column of an unfinished table.
const CHECKSUM: &str = "checksum";

/// The longest line in bytes: a damaged table may be one long line.
const LONGEST: usize = 1 << 16;

/// The text of the rows that are read together, in bytes.
const BLOCK: usize = 1 << 20;

/// The line of the head with the checksum of the recorded motion that the scene names.
const MOTION: &str = "# motion ";

const TITLE: &str = concat!("# lyapunov map ", env!("CARGO_PKG_VERSION"));

/// The head of a table, in front of its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct TableHeader {
    /// The text, up to the names of the columns.
    text: String,
}

impl TableHeader {
    /// The head of the table of `shard` of `grid`.
    pub fn of(grid: &Grid, shard: Shard) -> Self {
        let mut text = format!("{TITLE}\n# x {}\n# y {}\n", grid.x, grid.y);
        text += &format!("# stabilizers {}\n# shard {shard}\n", grid.stabilizers);
        // Every scene that was read can be written.
        let scene = toml::to_string(&grid.scene).unwrap_or_default();
        scene.lines().for_each(|line| text += &format!("#| {line}\n"));
        if let Some(rows) = grid.scene.motion_checksum() {
            text += &format!("{MOTION}{rows}\n");
        }
        let axes = [&grid.x.key[..], &grid.y.key];
        text += &csv::text(axes.into_iter().chain(columns()), None::<[Field<'_>; 0]>);
        Self { text }
    }

    /// The head at the beginning of `lines`.
    ///
    /// # Errors
    /// A reader that fails, and text that is not the head of a map with the columns of this version.
    pub fn read(lines: &mut impl BufRead) -> Result<Self, TableError> {
        Self::read_with(lines, "")
    }

    /// The head at the beginning of the unfinished table in `lines`.
    ///
    /// # Errors
    /// Those of [`TableHeader::read`].
    pub(super) fn read_unfinished(lines: &mut impl BufRead) -> Result<Self, TableError> {
        Self::read_with(lines, &format!(",{CHECKSUM}"))
    }

    fn read_with(lines: &mut impl BufRead, more: &str) -> Result<Self, TableError> {
        let wrong = |problem: &str| Err(TableError::TableHeader(problem.to_owned()));
        let mut text = String::new();
        loop {
            let before = text.len();
            lines.by_ref().take(LONGEST as u64).read_line(&mut text)?;
            let line = &text[before..];
            if before == 0 && line.trim_end() != TITLE {
                return wrong("it does not begin like one of this version");
            }
            if !line.ends_with('\n') {
                return wrong("its head is cut off");
            }
            if !line.starts_with('#') {
                let expected: Vec<&str> = columns().collect();
                let is_known = line.trim_end().ends_with(&format!(",{}{more}", expected.join(",")));
                let (_, found) = line.trim_end().split_once(",stabilizer,").unwrap_or(("", line));
                if !is_known {
                    return Err(TableError::Columns(found.trim_end().to_owned()));
                }
                text.truncate(text.trim_end().len() - more.len());
                text.push('\n');
                return Ok(Self { text });
            }
        }
    }

    /// The grid and the shard of the table.
    ///
    /// # Errors
    /// A head that this program did not write.
    pub fn parse(&self) -> Result<(Grid, Shard), TableError> {
        let wrong = |what: &str| TableError::TableHeader(format!("its head has no right `{what}`"));
        let after = |key: &str| {
            let start = format!("# {key} ");
            let found = self.text.lines().find_map(|line| line.strip_prefix(&start));
            found.ok_or_else(|| wrong(key))
        };
        let axis = |key: &str| after(key)?.parse::<Axis>().map_err(|_| wrong(key));
        let shard = after("shard")?.parse::<Shard>().map_err(|_| wrong("shard"))?;
        let members =
            after("stabilizers")?.parse::<StabilizerNames>().map_err(|_| wrong("stabilizers"))?;
        let scene: String = self
            .text
            .lines()
            .filter_map(|line| line.strip_prefix("#| "))
            .map(|line| format!("{line}\n"))
            .collect();
        let scene = Scene::parse(&scene, "the scene of the table")
            .map_err(|error| TableError::TableHeader(error.to_string()))?;
        let motion = |text: &str| text.lines().find(|it| it.starts_with(MOTION)).map(str::to_owned);
        let grid = Grid::new(scene, axis("x")?, axis("y")?, members)
            .map_err(|error| TableError::TableHeader(error.to_string()))?;
        if motion(&self.text) != motion(&Self::of(&grid, shard).text) {
            let problem = "the motion file that its scene names has other rows now";
            return Err(TableError::TableHeader(problem.to_owned()));
        }
        Ok((grid, shard))
    }

    /// Whether `other` is the head of a shard of the same map.
    pub fn is_kin(&self, other: &Self) -> bool {
        let rest = |text: &str| -> Vec<String> {
            let lines = text.lines().filter(|line| !line.starts_with("# shard "));
            lines.map(str::to_owned).collect()
        };
        rest(&self.text) == rest(&other.text)
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The text at the head of the unfinished table.
    pub(super) fn unfinished_text(&self) -> String {
        format!("{},{CHECKSUM}\n", self.text.trim_end())
    }

    /// The checksum that those of the rows begin with, so that no row of another map has a right one.
    pub(super) fn seal(&self) -> Checksum {
        Checksum::EMPTY.and(self.text.as_bytes())
    }
}

/// `line` of an unfinished table without its checksum and its break; none if that is not right.
pub(super) fn unsealed(line: &[u8], seal: Checksum) -> Option<&[u8]> {
    let line = line.strip_suffix(b"\n")?;
    let comma = line.iter().rposition(|byte| *byte == b',')?;
    let (row, sum) = (&line[..comma], &line[comma + 1..]);
    (sum == seal.and(row).to_string().as_bytes()).then_some(row)
}

/// Adds the next line to `text`, with its break; tells whether there was a whole one before the text ends. A line that is too
/// long is cut.
pub(super) fn next_line(lines: &mut impl BufRead, text: &mut Vec<u8>) -> io::Result<bool> {
    let read = lines.by_ref().take(LONGEST as u64).read_until(b'\n', text)?;
    let is_whole = read > 0 && text.ends_with(b"\n");
    if read == LONGEST && !is_whole {
        text.push(b'\n');
    }
    Ok(is_whole || read == LONGEST)
}

/// The rows of consecutive cells from cell `first` on, under each stabilizer of `grid`.
pub fn rows(grid: &Grid, first: u64, outcomes: &[Vec<Outcome>]) -> Vec<u8> {
    let mut rows = Records::new(Vec::new());
    for (cell, outcomes) in (first..).zip(outcomes) {
        let [x, y] = grid.values(cell);
        for (member, outcome) in grid.stabilizers.iter().zip(outcomes) {
            let words = [member.name(), outcome.verdict.word(), outcome.verdict_by.word()];
            let names = [x, y].map(Field::Number).into_iter().chain(words.map(Field::Text));
            let measures = Measure::ALL.map(|measure| measure.of(&outcome.measures).into());
            // Writing to memory never fails.
            let _ = rows.put(names.chain(measures));
        }
    }
    rows.into_inner().unwrap_or_default()
}

/// The rows of a table, cell by cell.
#[derive(Debug)]
pub struct Rows<R> {
    lines: R,
    grid: Grid,
    cell: u64,
    /// What the checksums of an unfinished table begin with.
    seal: Option<Checksum>,
    /// The rows of the last cells, as [`rows`] writes them.
    text: Vec<u8>,
    read: u64,
}

impl<R: BufRead> Rows<R> {
    /// The rows that follow in `lines` from cell `first` on.
    pub fn new(lines: R, grid: Grid, first: u64) -> Self {
        Self { lines, grid, cell: first, seal: None, text: Vec::new(), read: 0 }
    }

    /// The same of an unfinished table with this head, whose rows have checksums.
    pub(super) fn unfinished(lines: R, grid: Grid, first: u64, head: &TableHeader) -> Self {
        Self { seal: Some(head.seal()), ..Self::new(lines, grid, first) }
    }

    /// The number of bytes of the cells returned so far.
    pub fn bytes(&self) -> u64 {
        self.read
    }

    /// The rows of the cells that were returned last.
    pub(super) fn text(&self) -> &[u8] {
        &self.text
    }

    /// The next cell and its outcome under each stabilizer; none where the table ends, even in the middle of a row.
    ///
    /// # Errors
    /// A row of another cell, one that no map has or that was changed, and a reader that fails.
    pub fn next_cell(&mut self) -> Result<Option<(u64, Vec<Outcome>)>, TableError> {
        self.text.clear();
        let Some(bytes) = self.read_cell()? else { return Ok(None) };
        let outcomes = outcomes(&self.grid, self.cell, &self.text)?;
        self.read += bytes;
        self.cell += 1;
        Ok(Some((self.cell - 1, outcomes)))
    }

    /// The outcomes of the next cells, a block of at most `most` of them, which all cores read; none where the table ends.
    ///
    /// # Errors
    /// Those of [`next_cell`](Self::next_cell), the first of the block.
    pub(super) fn next_cells(&mut self, most: u64) -> Result<Vec<Vec<Outcome>>, TableError> {
        self.text.clear();
        let (mut cells, mut failed) = (Vec::new(), None);
        while (cells.len() as u64) < most && self.text.len() < BLOCK {
            let start = self.text.len();
            match self.read_cell() {
                Ok(Some(bytes)) => self.read += bytes,
                rest => {
                    // The text of a cell that is not whole.
                    self.text.truncate(start);
                    failed = rest.err();
                    break;
                }
            }
            cells.push((self.cell, start..self.text.len()));
            self.cell += 1;
        }
        let (grid, text) = (&self.grid, &self.text);
        let read = cells.into_par_iter().map(|(cell, rows)| outcomes(grid, cell, &text[rows]));
        let read = read.collect::<Vec<_>>().into_iter().collect::<Result<_, _>>()?;
        failed.map_or(Ok(read), Err)
    }

    /// Adds the rows of the next cell to the text, and returns how many bytes they have in the table.
    fn read_cell(&mut self) -> Result<Option<u64>, TableError> {
        let (mut bytes, members) = (0, self.grid.stabilizers.len() as u64);
        for row in 0..members {
            let start = self.text.len();
            if !next_line(&mut self.lines, &mut self.text)? {
                return Ok(None);
            }
            bytes += (self.text.len() - start) as u64;
            if let Some(seal) = self.seal {
                let row = unsealed(&self.text[start..], seal)
                    .ok_or(TableError::Damaged { row: self.cell * members + row + 1 })?;
                let end = start + row.len();
                self.text.truncate(end);
                self.text.push(b'\n');
            }
        }
        Ok(Some(bytes))
    }

    /// Whether a row with a right checksum is among the rest of an unfinished table.
    pub(super) fn goes_on(&mut self) -> Result<bool, TableError> {
        let mut line = Vec::new();
        while next_line(&mut self.lines, &mut line)? {
            if self.seal.is_some_and(|seal| unsealed(&line, seal).is_some()) {
                return Ok(true);
            }
            line.clear();
        }
        Ok(false)
    }

    /// Checks that nothing follows.
    ///
    /// # Errors
    /// A text that goes on.
    pub(super) fn end(mut self) -> Result<(), TableError> {
        if self.lines.fill_buf()?.is_empty() { Ok(()) } else { Err(TableError::Excess) }
    }
}

/// The outcomes in the rows of a cell.
fn outcomes(grid: &Grid, cell: u64, rows: &[u8]) -> Result<Vec<Outcome>, TableError> {
    let [x, y] = grid.values(cell).map(|value| format!("{value:?}"));
    let first = cell * grid.stabilizers.len() as u64 + 1;
    (first..)
        .zip(rows.split_inclusive(|byte| *byte == b'\n').zip(grid.stabilizers.iter()))
        .map(|(row, (text, member))| {
            let start = format!("{x},{y},{member},");
            let text = text.strip_suffix(b"\n").unwrap_or(text);
            let read = str::from_utf8(text).ok();
            let outcome = read.and_then(|text| text.strip_prefix(&start)).and_then(outcome);
            outcome.ok_or_else(|| TableError::Row {
                row,
                text: String::from_utf8_lossy(text).into_owned(),
            })
        })
        .collect()
}

/// The outcome in the part of a row after the stabilizer's name; none of a text that [`rows`] never writes.
fn outcome(text: &str) -> Option<Outcome> {
    let mut fields = text.split(',');
    let verdict = Verdict::of_word(fields.next()?)?;
    let verdict_by = Yardstick::of_word(fields.next()?)?;
    let mut numbers = [None; Measure::ALL.len()];
    let mut written = String::new();
    for number in &mut numbers {
        let field = fields.next()?;
        if !field.is_empty() {
            let read = field.parse::<f64>().ok()?;
            // As it was written: without a sign at 0.
            written.clear();
            write!(written, "{:?}", read + 0.0).ok()?;
            if written != field {
                return None;
            }
            *number = Some(read);
        }
    }
    let measures = Measures::from_numbers(numbers);
    let is_possible = measures.are_possible(verdict)
        && Measure::ALL.iter().zip(numbers).all(|(measure, it)| measure.of(&measures) == it);
    (fields.next().is_none() && is_possible).then_some(Outcome { verdict, verdict_by, measures })
}
