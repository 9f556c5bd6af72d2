//! The table of a map: CSV with the scene in its head and a row for each cell and stabilizer, in the order of the
//! cells.
//!
//! It is the map's only file of numbers: cells in it need not be computed again.

use std::fmt;
use std::io::{self, BufRead, Write};

use super::axis::Axis;
use super::grid::Grid;
use super::outcome::{Measure, Measures, Outcome};
use super::shard::Shard;
use crate::files::Scene;
use crate::measure::{Verdict, Yardstick};
use crate::show::csv::{self, Field, Records};
use crate::simulate::family::StabilizerNames;

/// The columns after those of the axes.
fn columns<'a>() -> impl Iterator<Item = &'a str> {
    let names = ["stabilizer", "verdict", "verdict_by"];
    names.into_iter().chain(Measure::ALL.map(|measure| measure.key))
}

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
        let axes = [&grid.x.key[..], &grid.y.key];
        text += &csv::text(axes.into_iter().chain(columns()), None::<[Field<'_>; 0]>);
        Self { text }
    }

    /// The head at the beginning of `lines`.
    ///
    /// # Errors
    /// A reader that fails, and text that is not the head of a map with the columns of this version.
    pub fn read(lines: &mut impl BufRead) -> Result<Self, TableError> {
        let mut text = String::new();
        loop {
            let before = text.len();
            lines.read_line(&mut text)?;
            let line = &text[before..];
            if before == 0 && line.trim_end() != TITLE {
                return Err(TableError::TableHeader(
                    "it does not begin like one of this version".into(),
                ));
            }
            if !line.ends_with('\n') {
                return Err(TableError::TableHeader("its head is cut off".into()));
            }
            if !line.starts_with('#') {
                let expected: Vec<&str> = columns().collect();
                let is_known = line.trim_end().ends_with(&format!(",{}", expected.join(",")));
                let (_, found) = line.trim_end().split_once(",stabilizer,").unwrap_or(("", line));
                let found = found.trim_end().to_owned();
                return if is_known { Ok(Self { text }) } else { Err(TableError::Columns(found)) };
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
        let grid = Grid::new(scene, axis("x")?, axis("y")?, members)
            .map_err(|error| TableError::TableHeader(error.to_string()))?;
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
}

/// Fault of a table.
#[derive(Debug)]
pub enum TableError {
    /// The head is not that of a map of this version.
    TableHeader(String),
    /// The columns after the stabilizer's are not those of this version.
    Columns(String),
    /// A row that no map has.
    Row {
        /// The number of the row, from 1.
        row: u64,
        /// The text that is there instead.
        text: String,
    },
    /// The table cannot be read.
    Unreadable(io::Error),
}

impl From<io::Error> for TableError {
    fn from(error: io::Error) -> Self {
        Self::Unreadable(error)
    }
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TableHeader(problem) => write!(f, "this is not the table of a map: {problem}"),
            Self::Columns(found) => {
                let found = crate::text::excerpt::shorten(found);
                write!(f, "its columns are `{found}`, and this version has others")
            }
            Self::Row { row, text } => {
                write!(
                    f,
                    "row {row} is `{}`, which no map has there",
                    crate::text::excerpt::shorten(text)
                )
            }
            Self::Unreadable(error) => write!(f, "it cannot be read: {error}"),
        }
    }
}

impl std::error::Error for TableError {}

/// Writes the rows of a cell.
///
/// # Errors
/// A writer that fails.
pub(super) fn write(
    out: &mut Records<impl Write>,
    grid: &Grid,
    cell: u64,
    outcomes: &[Outcome],
) -> io::Result<()> {
    let [x, y] = grid.values(cell);
    for (member, outcome) in grid.stabilizers.iter().zip(outcomes) {
        let words = [member.name(), outcome.verdict.word(), outcome.verdict_by.word()];
        let names = [x, y].map(Field::Number).into_iter().chain(words.map(Field::Text));
        let measures = Measure::ALL.map(|measure| measure.of(&outcome.measures).into());
        out.put(names.chain(measures))?;
    }
    Ok(())
}

/// The rows of a table, cell by cell.
#[derive(Debug)]
pub struct Rows<R> {
    lines: R,
    grid: Grid,
    cell: u64,
    line: String,
    read: u64,
}

impl<R: BufRead> Rows<R> {
    /// The rows that follow in `lines` from cell `first` on.
    pub fn new(lines: R, grid: Grid, first: u64) -> Self {
        Self { lines, grid, cell: first, line: String::new(), read: 0 }
    }

    /// The number of bytes of the cells returned so far.
    pub fn bytes(&self) -> u64 {
        self.read
    }

    /// The next cell and its outcome under each stabilizer; none where the table ends, even in the middle of a row.
    ///
    /// # Errors
    /// A row of another cell, and a reader that fails.
    pub fn next_cell(&mut self) -> Result<Option<(u64, Vec<Outcome>)>, TableError> {
        let (mut outcomes, mut bytes) = (Vec::new(), 0);
        let [x, y] = self.grid.values(self.cell).map(|value| format!("{value:?}"));
        for index in 0..self.grid.stabilizers.len() {
            self.line.clear();
            self.lines.read_line(&mut self.line)?;
            let Some(line) = self.line.strip_suffix('\n') else { return Ok(None) };
            let start = format!("{x},{y},{},", self.grid.stabilizers[index]);
            let outcome = line.strip_prefix(&start).and_then(outcome).ok_or_else(|| {
                let cells = self.cell * self.grid.stabilizers.len() as u64;
                TableError::Row { row: cells + index as u64 + 1, text: line.to_owned() }
            })?;
            outcomes.push(outcome);
            bytes += self.line.len() as u64;
        }
        self.read += bytes;
        self.cell += 1;
        Ok(Some((self.cell - 1, outcomes)))
    }
}

/// The outcome in the part of a row after the stabilizer's name.
fn outcome(text: &str) -> Option<Outcome> {
    let mut fields = text.split(',');
    let verdict = Verdict::of_word(fields.next()?)?;
    let verdict_by = Yardstick::of_word(fields.next()?)?;
    let mut numbers = [None; Measure::ALL.len()];
    for number in &mut numbers {
        let field = fields.next()?;
        if !field.is_empty() {
            *number = Some(field.parse().ok()?);
        }
    }
    let measures = Measures::from_numbers(numbers);
    fields.next().is_none().then_some(Outcome { verdict, verdict_by, measures })
}
