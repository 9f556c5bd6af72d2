//! Picture of the edges.

use super::{Edge, Refined, Side};
use crate::studies::map::axis::Axis;
use crate::studies::map::bounds::Bounds;
use crate::studies::map::picture::{FINEST, Shown, panels};
use lyapunov_figures::{Figure, HeatMap, Series};

/// Colour of the marks of ragged blocks.
const RAGGED: usize = 1;

impl Refined {
    /// The sides of the edge under each stabilizer, with a mark on each block of the start in which the edge is ragged.
    pub fn figure(&self, bounds: Option<&Bounds>) -> Figure {
        let grid = self.grid();
        let curves = bounds.map_or_else(Vec::new, Bounds::curves);
        let words = Side::ALL.map(Side::word);
        let elements = [&grid.x, &grid.y].map(|axis| axis.count.min(FINEST));
        panels(grid, "edge of stability", &curves, |index| {
            let edge = &self.edges[index];
            let heat = HeatMap::of_classes(
                elements[0] as usize,
                sides(edge, [&grid.x, &grid.y], elements),
                &words[..Side::TooShort as usize],
            );
            let marks = marks(edge, [&grid.x, &grid.y]);
            let marks = (!marks.is_empty()).then(|| Series::dots("ragged", RAGGED, marks));
            (heat, marks.into_iter().collect())
        })
    }
}

/// The side of the middle cell of each picture element, row by row from the bottom; NaN where it is too short to judge.
fn sides(edge: &Edge, [x, y]: [&Axis; 2], [columns, rows]: [u64; 2]) -> Vec<f64> {
    let middle =
        |element: u64, elements: u64, count: u64| (2 * element + 1) * count / (2 * elements);
    let along = |row: u64| {
        (0..columns).map(move |column| {
            middle(column, columns, x.count) + middle(row, rows, y.count) * x.count
        })
    };
    let number = |side| if side == Side::TooShort { f64::NAN } else { f64::from(side as u8) };
    (0..rows).flat_map(along).map(|cell| number(edge.side(cell))).collect()
}

/// The middles of the blocks of the start in which the edge is ragged, as drawn.
fn marks(edge: &Edge, axes: [&Axis; 2]) -> Vec<(f64, f64)> {
    let half = edge.coarsest().map(|cells| cells / 2);
    let place = |at: [u64; 2], axis: usize| {
        Shown::of(axes[axis]).place(axes[axis].value(at[axis] + half[axis]))
    };
    let ragged = edge.ragged().into_iter();
    ragged.map(|at| (place(at, 0), place(at, 1))).collect()
}
