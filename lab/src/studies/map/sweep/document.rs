//! The rows of a sweep as JSON and as comma-separated values.

use serde::Serialize;

use super::Sweep;
use crate::show::csv::{self, Field};
use crate::show::json;
use crate::studies::compare::{Column, Score, field};
use crate::studies::map::document::{Along, along};

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    x: Along<'a>,
    rows: Vec<Line<'a>>,
}

#[derive(Serialize)]
struct Line<'a> {
    value: f64,
    #[serde(flatten)]
    score: &'a Score,
}

impl Sweep {
    /// The sweep as JSON; docs/map.md lists the keys.
    pub fn to_json(&self) -> String {
        let rows = self.rows().map(|(value, score)| Line { value, score }).collect();
        let document = Document { scene: &self.name, x: along(&self.x), rows };
        json::text(&document)
    }

    /// The same rows as comma-separated values, in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let columns = || Column::ALL.into_iter().filter(|column| *column != Column::StepTime);
        let rows = self.rows().map(|(value, score)| {
            let cells = columns().map(|column| field(column, score));
            std::iter::once(Field::Number(value)).chain(cells)
        });
        let mut names: Vec<&str> = vec!["value"];
        for column in columns() {
            names.push(column.key());
        }
        csv::text(names, rows)
    }

    /// Value and score of each run.
    pub(super) fn rows(&self) -> impl Iterator<Item = (f64, &Score)> {
        let points = self.points.iter();
        points.flat_map(|point| point.scores.iter().map(move |score| (point.value, score)))
    }
}
