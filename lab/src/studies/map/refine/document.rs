//! Edges as JSON, and the judged cells as comma-separated values.

use serde::Serialize;

use super::{Edge, Refined, Side};
use crate::show::csv::{self, Field};
use crate::show::json;
use crate::studies::map::document::{Along, along};

#[derive(Serialize)]
struct Document<'a> {
    x: Along<'a>,
    y: Along<'a>,
    edges: Vec<Line>,
}

#[derive(Serialize)]
struct Line {
    stabilizer: &'static str,
    judged_cells: usize,
    judged_share: f64,
    bounded_share: f64,
    grows_share: f64,
    too_short_share: f64,
    /// Share of the area of the blocks that the edge passes.
    edge_share: f64,
    /// The cells along both sides of a block of the start.
    block_cells: [u64; 2],
    edge_blocks: usize,
    ragged_blocks: usize,
    /// The cells along both sides of the largest block that was not resolved; null if the edge is known to the cell.
    unresolved_cells: Option<[u64; 2]>,
}

impl Line {
    fn of(stabilizer: &'static str, edge: &Edge, cells: u64) -> Self {
        let (shares, judged_cells) = (edge.shares(), edge.judged().len());
        let [bounded_share, grows_share, too_short_share] = shares.sides;
        Self {
            stabilizer,
            judged_cells,
            judged_share: judged_cells as f64 / cells as f64,
            bounded_share,
            grows_share,
            too_short_share,
            edge_share: shares.passed,
            block_cells: edge.coarsest(),
            edge_blocks: edge.passed_blocks(),
            ragged_blocks: edge.ragged_blocks(),
            unresolved_cells: edge.unresolved(),
        }
    }
}

impl Refined {
    /// The edges as JSON; docs/map.md lists the keys.
    pub fn to_json(&self) -> String {
        let grid = self.grid();
        let lines = self.edges().map(|(member, edge)| Line::of(member.name(), edge, grid.cells()));
        let document = Document { x: along(&grid.x), y: along(&grid.y), edges: lines.collect() };
        json::text(&document)
    }

    /// The judged cells as comma-separated values, by stabilizer and in the order of the cells.
    pub fn csv(&self) -> String {
        let grid = self.grid();
        let of = |(cell, side): (u64, Side), name| {
            let [x, y] = grid.values(cell).map(Field::Number);
            [x, y, Field::Text(name), Field::Text(side.word())]
        };
        let rows = self.edges().flat_map(|(member, edge)| {
            edge.judged().into_iter().map(move |judged| of(judged, member.name()))
        });
        csv::text([&grid.x.key[..], &grid.y.key, "stabilizer", "side"], rows)
    }
}
