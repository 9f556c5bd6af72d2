//! A log laid over a run: lines, table, JSON.

use maud::{Markup, html};
use serde::Serialize;

use super::picture::Overlay;
use super::{Differences, Start};
use crate::files::log::{BadRows, Column, described};
use crate::measure::{Oddity, Summary};
use crate::show::csv;
use crate::show::html;
use crate::show::labelled::labelled;
use crate::show::table::{Cell, Heading, Table};
use crate::text::{folded, found, legible};

/// A log laid over the run of a scene.
#[derive(Clone, Debug, Serialize)]
pub struct Laid {
    /// The name of the log.
    pub log: String,
    /// Where the run starts.
    pub start: Start,
    /// The columns of the log as they were read.
    pub columns: Vec<Column>,
    /// Whether its numbers have decimal commas.
    pub decimal_commas: bool,
    /// The rows that were compared.
    pub rows: u64,
    /// Rows after the last tick of a run that left the range of its scalar; they were not compared.
    pub rows_after_the_run: u64,
    /// The rows that could not be read.
    pub bad_rows: BadRows,
    /// The time of the first row that was compared, s, on the scene's clock.
    pub from_s: f64,
    /// The time of the last one, s.
    pub to_s: f64,
    /// The time at which the scene ends, s.
    pub scene_s: f64,
    /// Whether the log has a column of velocities; else those of both are differences of positions over the log's steps.
    pub measured_velocity: bool,
    /// The differences, run − log.
    #[serde(flatten)]
    pub differences: Differences,
    /// The signs of a mistake.
    pub look_at: Vec<Oddity>,
    #[serde(skip)]
    pub(super) overlay: Overlay,
}

impl Laid {
    /// What was compared, in labelled lines.
    pub(crate) fn lines(&self) -> String {
        let name = legible(&self.log);
        let (from, to) = (found(self.from_s), found(self.to_s));
        let start = match self.start {
            Start::Scene => "on the scene's clock",
            Start::Log => "counted from its first row, where the run starts",
        };
        let goes_on = match self.to_s < self.scene_s {
            true => format!("; the scene goes on until {} s", found(self.scene_s)),
            false => String::new(),
        };
        let rows = self.rows;
        let text = format!("{name}, {rows} rows from {from} s to {to} s {start}{goes_on}");
        let mut lines = folded("  against      ", &text);
        let mut tell = |label: &str, text: &str| {
            lines += &format!("\n{}", folded(&format!("  {label:<13}"), text));
        };
        if let Some(text) = described(&self.columns, self.decimal_commas) {
            tell("columns", &text);
        }
        if self.rows_after_the_run > 0 {
            let left = self.rows_after_the_run;
            tell("left out", &format!("{left} rows that come after the run had left its range"));
        }
        if self.bad_rows.count > 0 {
            let first = self.bad_rows.first.first();
            let first =
                first.map_or_else(String::new, |it| format!(", line {}: {}", it.line, it.reason));
            tell("bad rows", &format!("{}, not compared{first}", self.bad_rows.count));
        }
        for it in &self.look_at {
            tell("look at", &it.text);
        }
        lines
    }

    /// The differences in a table.
    pub(crate) fn table(&self) -> Table {
        let headings = [
            Heading::word("run - log"),
            Heading::number("rms"),
            Heading::number("largest"),
            Heading::number("at\ns"),
            Heading::number("log's\nrange"),
            Heading::number("rms\n% of it"),
            Heading::number("largest\n% of it"),
        ];
        let rows = self.differences.named().map(|(name, it)| {
            let name = format!("{name}, {}", it.unit);
            let [rms, largest, at] = [it.rms, it.largest, it.largest_at_s].map(Cell::from);
            [
                name.into(),
                rms,
                largest,
                at,
                it.range.into(),
                it.rms_percent.into(),
                it.largest_percent.into(),
            ]
        });
        Table::new(headings).with_rows(rows)
    }

    /// Lines and table for the terminal.
    pub fn text(&self) -> String {
        let table = self.table().to_string();
        format!("{}\n\n{}", self.lines(), textwrap::indent(table.trim_end(), "  "))
    }

    /// The part of a page.
    pub(crate) fn markup(&self) -> Markup {
        let velocity = if self.measured_velocity {
            "The velocity is the log's own, against the one that the scene estimates."
        } else {
            "Velocities of both are differences of positions over the log's steps."
        };
        let caption = format!(
            "The log, dashed, over the run at the log's times. Between ticks the run's motion is a straight line, and its force is held. {velocity}"
        );
        html! {
            h2 { "Against the log" }
            (labelled(&self.lines()))
            (self.table().to_html(""))
            (html::figure(Some("against"), &self.figure(), &html! { (caption) }))
        }
    }

    /// The summary of the run of the scene called `name` as JSON, with this under `against`.
    pub fn to_json(&self, name: &str, summary: &Summary) -> String {
        summary.to_json_against(name, Some(self))
    }

    /// The differences as comma-separated values.
    pub fn csv(&self) -> String {
        csv::named_records("quantity", self.differences.named())
    }
}
