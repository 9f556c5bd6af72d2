//! Picture of the edges.

use super::{Edge, Refined, Side};
use crate::measure::Verdict;
use crate::studies::map::axis::Axis;
use crate::studies::map::bounds::Bounds;
use crate::studies::map::picture::{FINEST, Shown, middle, panels};
use lyapunov_figures::{Figure, HeatMap, Series};

/// Colour of the marks of ragged blocks.
const RAGGED: usize = 1;

/// Number of colours that the verdicts have in a map.
const COLOURS: usize = Verdict::TooShort as usize;

/// The colour of a side among those of the verdicts; none where it is too short to judge.
fn colour(side: Side) -> Option<usize> {
    match side {
        Side::Bounded => Some(Verdict::Settles as usize),
        Side::Grows => Some(Verdict::Grows as usize),
        Side::TooShort => None,
    }
}

impl Refined {
    /// The sides of the edge under each stabilizer, with a mark on each block of the start in which the edge is ragged.
    pub fn figure(&self, bounds: Option<&Bounds>) -> Figure {
        let grid = self.grid();
        let curves = bounds.map_or_else(Vec::new, Bounds::curves);
        let words: [&str; COLOURS] = std::array::from_fn(|at| {
            Side::ALL.into_iter().find(|side| colour(*side) == Some(at)).map_or("", Side::word)
        });
        let elements = [&grid.x, &grid.y].map(|axis| axis.count.min(FINEST));
        panels(grid, "edge of bounded runs", &curves, |index| {
            let edge = &self.edges[index];
            let heat = HeatMap::of_classes(
                elements[0] as usize,
                sides(edge, [&grid.x, &grid.y], elements),
                &words,
            );
            let marks = marks(edge, [&grid.x, &grid.y]);
            let marks = (!marks.is_empty()).then(|| Series::dots("ragged", RAGGED, marks));
            (heat, marks.into_iter().collect())
        })
    }
}

/// The side of the middle cell of each picture element, row by row from the bottom; NaN where it is too short to judge.
fn sides(edge: &Edge, [x, y]: [&Axis; 2], [columns, rows]: [u64; 2]) -> Vec<f64> {
    let along = |row: u64| {
        (0..columns).map(move |column| middle(x, column, columns) + middle(y, row, rows) * x.count)
    };
    let number = |side| colour(side).map_or(f64::NAN, |it| it as f64);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_side_has_the_colour_that_its_verdict_has_in_a_map() {
        for verdict in [Verdict::Settles, Verdict::Grows] {
            assert_eq!(colour(verdict.into()), Some(verdict as usize));
        }
        assert_eq!(colour(Side::TooShort), None);
    }
}
