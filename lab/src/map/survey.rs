//! What a whole map comes to, cell by cell: little, however large it is.

use super::grid::Grid;
use super::outcome::{Measure, Outcome};

/// The most picture elements along an axis; a larger map is drawn by means.
const FINEST: u64 = 512;

/// What is kept of a map while its cells pass by.
#[derive(Clone, Debug)]
pub struct Survey {
    grid: Grid,
    columns: usize,
    rows: usize,
    layers: Vec<Layer>,
}

/// What one stabilizer came to.
#[derive(Clone, Debug)]
struct Layer {
    stable: u64,
    judged: u64,
    /// How many cells of each row, counted from its beginning, come before the first that is unstable; and of each column.
    along_x: Vec<u64>,
    along_y: Vec<u64>,
    /// For each element: how many cells, how many of them stable or not judged.
    cells: Vec<u32>,
    kept: Vec<u32>,
    /// For each measure and element, the sum and the number of the values.
    sums: Vec<Vec<(f64, u32)>>,
}

/// The share of a map that a stabilizer renders stably: its Z-width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Stable cells.
    pub stable: u64,
    /// Cells that were judged: all, but for those where no spring pulls the plant anywhere.
    pub judged: u64,
    /// The one of the other; none if none was judged.
    pub share: Option<f64>,
    /// The same share of the rectangle, in the units of both axes; of a logarithmic axis in decades.
    pub area: Option<f64>,
}

impl Survey {
    /// Nothing seen yet.
    pub fn of(grid: &Grid) -> Self {
        let [columns, rows] = [grid.x.count, grid.y.count].map(|count| count.min(FINEST) as usize);
        let layer = Layer {
            stable: 0,
            judged: 0,
            along_x: vec![0; grid.y.count as usize],
            along_y: vec![0; grid.x.count as usize],
            cells: vec![0; columns * rows],
            kept: vec![0; columns * rows],
            sums: vec![vec![(0.0, 0); columns * rows]; Measure::ALL.len()],
        };
        let layers = vec![layer; grid.members.len()];
        Self { grid: grid.clone(), columns, rows, layers }
    }

    /// One more cell; the cells of a map come in their order.
    pub fn add(&mut self, cell: u64, outcomes: &[Outcome]) {
        let (x, y) = (cell % self.grid.x.count, cell / self.grid.x.count);
        let at = |index: u64, count: u64, finest: usize| (index * finest as u64 / count) as usize;
        let column = at(x, self.grid.x.count, self.columns);
        let element = at(y, self.grid.y.count, self.rows) * self.columns + column;
        for (layer, outcome) in self.layers.iter_mut().zip(outcomes) {
            let is_kept = outcome.stable != Some(false);
            layer.judged += u64::from(outcome.stable.is_some());
            layer.stable += u64::from(outcome.stable == Some(true));
            layer.along_x[y as usize] += u64::from(is_kept && layer.along_x[y as usize] == x);
            layer.along_y[x as usize] += u64::from(is_kept && layer.along_y[x as usize] == y);
            layer.cells[element] += 1;
            layer.kept[element] += u32::from(is_kept);
            for (measure, sums) in Measure::ALL.iter().zip(&mut layer.sums) {
                if let Some(value) = measure.of(&outcome.measures) {
                    sums[element].0 += value;
                    sums[element].1 += 1;
                }
            }
        }
    }

    /// What is mapped.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// What stabilizer `index` renders stably.
    pub fn area(&self, index: usize) -> Area {
        let Layer { stable, judged, .. } = self.layers[index];
        let share = (judged > 0).then(|| stable as f64 / judged as f64);
        let area = share.map(|share| share * self.grid.x.width() * self.grid.y.width());
        Area { stable, judged, share, area }
    }

    /// The unit of areas.
    pub fn unit(&self) -> String {
        let units = [self.grid.x.unit(), self.grid.y.unit()].map(|unit| match unit {
            "" => "1",
            unit => unit,
        });
        units.join(" x ")
    }

    /// How many values of x come before the first that is unstable under stabilizer `index`, for each value of y.
    pub fn along_x(&self, index: usize) -> &[u64] {
        &self.layers[index].along_x
    }

    /// The same of y for each value of x.
    pub fn along_y(&self, index: usize) -> &[u64] {
        &self.layers[index].along_y
    }

    /// Columns and rows of the picture.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// The share of cells that did not turn out unstable under stabilizer `index`, row by row from the bottom.
    pub(super) fn bounded(&self, index: usize) -> Vec<f64> {
        let layer = &self.layers[index];
        let share = |(cells, kept): (&u32, &u32)| f64::from(*kept) / f64::from(*cells);
        layer.cells.iter().zip(&layer.kept).map(share).collect()
    }

    /// The mean of a measure over the cells of each element; NaN where there is none.
    pub(super) fn mean(&self, index: usize, measure: usize) -> Vec<f64> {
        let sums = &self.layers[index].sums[measure];
        sums.iter().map(|(sum, count)| sum / f64::from(*count)).collect()
    }
}
