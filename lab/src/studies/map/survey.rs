//! Survey of a map in little memory, however large the map is.

use super::grid::Grid;
use super::picture::FINEST;
use super::rendered::{Rendered, Tally};
use crate::measure::runs::{Measure, Outcome};
use crate::measure::sanity::Sign;
use crate::measure::{Oddity, Verdict, Yardstick};
use crate::simulate::family::{BasicName, StabilizerName};

/// Survey of a map, filled cell by cell.
#[derive(Clone, Debug)]
pub struct Survey {
    grid: Grid,
    columns: usize,
    rows: usize,
    /// The index of the loop without a stabilizer.
    alone: Option<usize>,
    /// Cells that are judged by speed.
    by_speed: u64,
    /// Cells of which no run ever leaves its band.
    undisturbed: u64,
    /// Whether a force acts in any cell, as far as is known.
    acts: bool,
    layers: Vec<Layer>,
}

/// The number of cells of each verdict, in the order of [`Verdict::ALL`].
type Counts = [u32; Verdict::ALL.len()];

/// The part of a survey for one stabilizer.
#[derive(Clone, Debug)]
struct Layer {
    tally: Tally,
    /// Cells of each verdict.
    cells: [u64; Verdict::ALL.len()],
    /// Reach of each row, and of each column, that the bounds are compared with.
    along_x: Vec<Reach>,
    along_y: Vec<Reach>,
    /// Cells of each verdict in each picture element.
    elements: Vec<Counts>,
    /// For each measure and picture element, the sum and the number of the values.
    sums: Vec<Vec<(f64, u32)>>,
}

/// Length over which a row or a column of a map stays bounded, from its beginning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reach {
    /// The index of the cell after the last bounded one before any that grows; 0 without a bounded one.
    pub end: u64,
    /// Whether a cell that grows follows.
    pub is_broken: bool,
}

impl Reach {
    /// Adds the next cell, at `index`.
    fn pass(&mut self, index: u64, verdict: Verdict) {
        self.is_broken |= verdict == Verdict::Grows;
        if verdict.is_bounded() && !self.is_broken {
            self.end = index + 1;
        }
    }
}

/// The part of a map over which the runs under a stabilizer have one of some verdicts. Where the axes are those of a
/// wall, the bounded one is the stabilizer's Z-width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// The cells.
    pub cells: u64,
    /// The cells over the judged cells; none if no cell was judged.
    pub share: Option<f64>,
    /// The cells over all cells, times the rectangle in the units of both axes; a logarithmic axis counts in decades.
    pub area: Option<f64>,
}

impl Survey {
    /// Empty survey of `grid`.
    pub fn of(grid: &Grid) -> Self {
        let [columns, rows] = [grid.x.count, grid.y.count].map(|count| count.min(FINEST) as usize);
        let layer = Layer {
            tally: Tally::default(),
            cells: Default::default(),
            along_x: vec![Reach::default(); grid.y.samples().len()],
            along_y: vec![Reach::default(); grid.x.samples().len()],
            elements: vec![Counts::default(); columns * rows],
            sums: vec![vec![(0.0, 0); columns * rows]; Measure::ALL.len()],
        };
        let layers = vec![layer; grid.stabilizers.len()];
        let nobody = StabilizerName::Basic(BasicName::NoStabilizer);
        let alone = grid.stabilizers.iter().position(|member| *member == nobody);
        Self {
            grid: grid.clone(),
            columns,
            rows,
            alone,
            by_speed: 0,
            undisturbed: 0,
            acts: false,
            layers,
        }
    }

    /// Adds the next cell; cells come in their order.
    pub fn add(&mut self, cell: u64, outcomes: &[Outcome]) {
        let (x, y) = (cell % self.grid.x.count, cell / self.grid.x.count);
        let at = |index: u64, count: u64, finest: usize| (index * finest as u64 / count) as usize;
        let element = at(y, self.grid.y.count, self.rows) * self.columns
            + at(x, self.grid.x.count, self.columns);
        let (column, row) = (self.grid.x.sample_at(x), self.grid.y.sample_at(y));
        let is_by_speed = outcomes.iter().any(|outcome| outcome.verdict_by == Yardstick::Speed);
        self.by_speed += u64::from(is_by_speed);
        let stays = outcomes.iter().all(|outcome| outcome.measures.settling_time == Some(0.0));
        self.undisturbed += u64::from(stays);
        let alone = self.alone.map(|index| outcomes[index].verdict);
        self.acts |= outcomes.iter().any(|outcome| outcome.measures.peak_force != Some(0.0));
        for (layer, outcome) in self.layers.iter_mut().zip(outcomes) {
            let verdict = outcome.verdict;
            layer.tally.add(outcome, alone);
            layer.cells[verdict as usize] += 1;
            if let Some(row) = row {
                layer.along_x[row].pass(x, verdict);
            }
            if let Some(column) = column {
                layer.along_y[column].pass(y, verdict);
            }
            layer.elements[element][verdict as usize] += 1;
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

    /// The cells under stabilizer `index` with this verdict.
    pub fn cells(&self, index: usize, verdict: Verdict) -> u64 {
        self.layers[index].cells[verdict as usize]
    }

    /// The judged cells under stabilizer `index`: all but those whose run is too short.
    pub fn judged(&self, index: usize) -> u64 {
        self.layers[index].cells.iter().sum::<u64>() - self.cells(index, Verdict::TooShort)
    }

    /// The area over which the runs under stabilizer `index` settle.
    pub fn settling(&self, index: usize) -> Area {
        self.area(index, self.cells(index, Verdict::Settles))
    }

    /// The area over which the runs under stabilizer `index` settle or swing.
    pub fn bounded(&self, index: usize) -> Area {
        let bounded = [Verdict::Settles, Verdict::Swinging].map(|it| self.cells(index, it));
        self.area(index, bounded.iter().sum())
    }

    fn area(&self, index: usize, cells: u64) -> Area {
        let judged = self.judged(index);
        let share = (judged > 0).then(|| cells as f64 / judged as f64);
        let whole = self.grid.x.width() * self.grid.y.width();
        let area = share.map(|_| cells as f64 / self.grid.cells() as f64 * whole);
        Area { cells, share, area }
    }

    /// The cells that are judged by speed.
    pub fn by_speed(&self) -> u64 {
        self.by_speed
    }

    /// The cells in which the plant starts in balance and no run takes it out of its band.
    pub(super) fn undisturbed(&self) -> u64 {
        self.undisturbed
    }

    /// The sign that no force acts in any cell.
    pub(super) fn look_at(&self) -> Option<Oddity> {
        let text = format!("no force acts in any of the {} cells", self.grid.cells());
        (!self.acts).then(|| Oddity::new(Sign::Untouched, text))
    }

    /// What stabilizer `index` renders.
    pub fn rendered(&self, index: usize) -> Rendered {
        let has_force = self.layers.iter().any(|layer| layer.tally.has_force());
        self.layers[index].tally.rendered(has_force, self.alone.is_some())
    }

    /// The stabilizers by what they render, the most first: by the bounded share where no force is known.
    pub fn ranking(&self) -> Vec<usize> {
        let merit = |index: usize| self.rendered(index).percent.or(self.bounded(index).share);
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

    /// Reach along x of stabilizer `index` for each value of y, of a long axis for some that stand for it.
    pub fn along_x(&self, index: usize) -> &[Reach] {
        &self.layers[index].along_x
    }

    /// Reach along y of stabilizer `index` for each value of x, of a long axis for some that stand for it.
    pub fn along_y(&self, index: usize) -> &[Reach] {
        &self.layers[index].along_y
    }

    /// Numbers of columns and rows of the picture.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// The verdict on most cells of each element under stabilizer `index`, as its place in [`Verdict::ALL`], row by row
    /// from the bottom; of equally many the worse one, and NaN where no cell was judged.
    pub(super) fn verdicts(&self, index: usize) -> Vec<f64> {
        let most = |counts: &Counts| {
            let judged = Verdict::ALL.into_iter().filter(|it| *it != Verdict::TooShort);
            let found = judged.filter(|it| counts[*it as usize] > 0);
            let found = found.max_by_key(|it| counts[*it as usize]);
            found.map_or(f64::NAN, |verdict| verdict as usize as f64)
        };
        self.layers[index].elements.iter().map(most).collect()
    }

    /// Mean of a measure over the cells of each element; NaN where there is no value.
    pub(super) fn mean(&self, index: usize, measure: usize) -> Vec<f64> {
        let sums = &self.layers[index].sums[measure];
        sums.iter().map(|(sum, count)| sum / f64::from(*count)).collect()
    }
}
