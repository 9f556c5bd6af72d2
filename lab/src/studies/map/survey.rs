//! Survey of a map in little memory, however large the map is.

use super::grid::Grid;
use super::outcome::{Measure, Outcome};
use super::rendered::{Rendered, Tally};
use crate::simulate::family::{BasicName, StabilizerName};

/// The most picture elements along an axis; a larger map is drawn by the means of its cells.
const FINEST: u64 = 512;

/// Survey of a map, filled cell by cell.
#[derive(Clone, Debug)]
pub struct Survey {
    grid: Grid,
    columns: usize,
    rows: usize,
    /// The index of the loop without a stabilizer.
    alone: Option<usize>,
    layers: Vec<Layer>,
}

/// The part of a survey for one stabilizer.
#[derive(Clone, Debug)]
struct Layer {
    stable: u64,
    judged: u64,
    tally: Tally,
    /// Reach of each row, and of each column.
    along_x: Vec<Reach>,
    along_y: Vec<Reach>,
    /// The judged cells of each picture element, and the stable ones among them.
    cells: Vec<u32>,
    held: Vec<u32>,
    /// For each measure and picture element, the sum and the number of the values.
    sums: Vec<Vec<(f64, u32)>>,
}

/// Length over which a row or a column of a map is stable, from its beginning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reach {
    /// The index of the cell after the last stable one before any unstable one; 0 without a stable one.
    pub end: u64,
    /// Whether an unstable cell follows.
    pub is_broken: bool,
}

impl Reach {
    /// Adds the next cell, at `index`.
    fn pass(&mut self, index: u64, stable: Option<bool>) {
        self.is_broken |= stable == Some(false);
        if stable == Some(true) && !self.is_broken {
            self.end = index + 1;
        }
    }
}

/// The share of a map that a stabilizer renders stably: its Z-width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Stable cells.
    pub stable: u64,
    /// Judged cells: all but those where no spring pulls the plant.
    pub judged: u64,
    /// Stable cells over judged cells; none if no cell was judged.
    pub share: Option<f64>,
    /// The stable share of all cells, times the rectangle in the units of both axes; a logarithmic axis counts in
    /// decades.
    pub area: Option<f64>,
}

impl Survey {
    /// Empty survey of `grid`.
    pub fn of(grid: &Grid) -> Self {
        let [columns, rows] = [grid.x.count, grid.y.count].map(|count| count.min(FINEST) as usize);
        let layer = Layer {
            stable: 0,
            judged: 0,
            tally: Tally::default(),
            along_x: vec![Reach::default(); grid.y.count as usize],
            along_y: vec![Reach::default(); grid.x.count as usize],
            cells: vec![0; columns * rows],
            held: vec![0; columns * rows],
            sums: vec![vec![(0.0, 0); columns * rows]; Measure::ALL.len()],
        };
        let layers = vec![layer; grid.stabilizers.len()];
        let nobody = StabilizerName::Basic(BasicName::NoStabilizer);
        let alone = grid.stabilizers.iter().position(|member| *member == nobody);
        Self { grid: grid.clone(), columns, rows, alone, layers }
    }

    /// Adds the next cell; cells come in their order.
    pub fn add(&mut self, cell: u64, outcomes: &[Outcome]) {
        let (x, y) = (cell % self.grid.x.count, cell / self.grid.x.count);
        let at = |index: u64, count: u64, finest: usize| (index * finest as u64 / count) as usize;
        let column = at(x, self.grid.x.count, self.columns);
        let element = at(y, self.grid.y.count, self.rows) * self.columns + column;
        let alone = self.alone.and_then(|index| outcomes[index].stable);
        for (layer, outcome) in self.layers.iter_mut().zip(outcomes) {
            layer.tally.add(outcome, alone);
            layer.judged += u64::from(outcome.stable.is_some());
            layer.stable += u64::from(outcome.stable == Some(true));
            layer.along_x[y as usize].pass(x, outcome.stable);
            layer.along_y[x as usize].pass(y, outcome.stable);
            layer.cells[element] += u32::from(outcome.stable.is_some());
            layer.held[element] += u32::from(outcome.stable == Some(true));
            for (measure, sums) in Measure::ALL.iter().zip(&mut layer.sums) {
                if let Some(value) = measure.of(&outcome.measures) {
                    sums[element].0 += value;
                    sums[element].1 += 1;
                }
            }
        }
    }

    /// The grid of the map.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The area that stabilizer `index` renders stably.
    pub fn area(&self, index: usize) -> Area {
        let Layer { stable, judged, .. } = self.layers[index];
        let share = (judged > 0).then(|| stable as f64 / judged as f64);
        let whole = self.grid.x.width() * self.grid.y.width();
        let area = share.map(|_| stable as f64 / self.grid.cells() as f64 * whole);
        Area { stable, judged, share, area }
    }

    /// What stabilizer `index` renders.
    pub fn rendered(&self, index: usize) -> Rendered {
        let has_force = self.layers.iter().any(|layer| layer.tally.has_force());
        self.layers[index].tally.rendered(has_force, self.alone.is_some())
    }

    /// The stabilizers by what they render, the most first: by the stable share where no force is known.
    pub fn ranking(&self) -> Vec<usize> {
        let merit = |index: usize| self.rendered(index).percent.or(self.area(index).share);
        let mut ranked: Vec<(usize, f64)> =
            (0..self.layers.len()).map(|index| (index, merit(index).unwrap_or(0.0))).collect();
        ranked.sort_by(|one, other| other.1.total_cmp(&one.1));
        ranked.into_iter().map(|(index, _)| index).collect()
    }

    /// The unit of areas.
    pub fn unit(&self) -> String {
        let units = [self.grid.x.unit(), self.grid.y.unit()].map(|unit| match unit {
            "" => "1",
            unit => unit,
        });
        units.join(" x ")
    }

    /// Reach along x of stabilizer `index` for each value of y.
    pub fn along_x(&self, index: usize) -> &[Reach] {
        &self.layers[index].along_x
    }

    /// Reach along y of stabilizer `index` for each value of x.
    pub fn along_y(&self, index: usize) -> &[Reach] {
        &self.layers[index].along_y
    }

    /// Numbers of columns and rows of the picture.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// Share of the judged cells of each element that are stable under stabilizer `index`, row by row from the bottom;
    /// NaN where none was judged.
    pub(super) fn stable(&self, index: usize) -> Vec<f64> {
        let layer = &self.layers[index];
        let share = |(cells, held): (&u32, &u32)| f64::from(*held) / f64::from(*cells);
        layer.cells.iter().zip(&layer.held).map(share).collect()
    }

    /// Mean of a measure over the cells of each element; NaN where there is no value.
    pub(super) fn mean(&self, index: usize, measure: usize) -> Vec<f64> {
        let sums = &self.layers[index].sums[measure];
        sums.iter().map(|(sum, count)| sum / f64::from(*count)).collect()
    }
}
