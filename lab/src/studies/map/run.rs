//! The computation of a map's cells on all cores, with results in the order of the cells.

use std::time::{Duration, Instant};

use rayon::ThreadPool;
use rayon::prelude::*;

use super::grid::{Grid, GridError, Tile};
use super::kernel::Placed;
use super::method::Method;
use super::run_error::RunError;
use super::threads;
use super::workload::Workload;
use crate::files::Scene;
use crate::measure::runs::{AllMeasures, Judged, Measures, Outcome, Runs};
use crate::measure::{GoOn, Verdict, Yardstick};
use crate::show::OutputError;
use crate::simulate::Instructions;
use crate::simulate::family::{BasicName, StabilizerName};

/// Time that a band of cells may take: no more than this is lost when a machine stops.
const BAND: Duration = Duration::from_millis(500);

/// Cells that one thread takes at once: the most, and the least while there are as many.
const SHARE: usize = 1024;
const LEAST: usize = 64;

/// The most cells of a band.
const MOST: usize = 1 << 16;

/// Receiver of a band: its first cell, and the outcome of each of its cells under each stabilizer.
pub type TakeOutcomes<'a> = dyn FnMut(u64, &[Vec<Outcome>]) -> Result<(), OutputError> + Send + 'a;

/// The computation of a map.
#[derive(Debug)]
pub struct Run<'a> {
    grid: &'a Grid,
    method: Method,
    pool: ThreadPool,
}

impl<'a> Run<'a> {
    /// Computation of `grid` on `threads` threads, or as many as there are cores.
    ///
    /// # Errors
    /// A value of an axis that the scene does not allow; threads that cannot be started.
    pub fn of(grid: &'a Grid, threads: Option<usize>) -> Result<Self, RunError> {
        Self::by(grid, || Method::of(grid, &grid.tile(0)), threads)
    }

    /// The same with each cell run by itself, whatever parts the scene has.
    ///
    /// # Errors
    /// The errors of [`Run::of`].
    pub fn one_by_one(grid: &'a Grid, threads: Option<usize>) -> Result<Self, RunError> {
        Self::by(grid, || Ok(Method::Single), threads)
    }

    /// The same with lanes of boxes on `instructions`, whatever parts the scene has; cells that nothing is like run one by
    /// one.
    ///
    /// # Errors
    /// The errors of [`Run::of`].
    pub fn on_boxes(
        grid: &'a Grid,
        instructions: Instructions,
        threads: Option<usize>,
    ) -> Result<Self, RunError> {
        Self::by(grid, || Ok(Method::Lanes(instructions)), threads)
    }

    fn by(
        grid: &'a Grid,
        method: impl FnOnce() -> Result<Method, RunError>,
        threads: Option<usize>,
    ) -> Result<Self, RunError> {
        let pool = threads::pool(threads, grid.cells())?;
        pool.install(|| grid.check()).map_err(GridError::from)?;
        Ok(Self { grid, method: method()?, pool })
    }

    /// The grid of the map.
    pub fn grid(&self) -> &'a Grid {
        self.grid
    }

    /// Method by which the cells are computed.
    pub fn method(&self) -> &Method {
        &self.method
    }

    /// The number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Does other work for the map on the same threads.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// Computes `cells` and passes them to `put` in their order, a band at a time, in the pool of its threads; polls `go_on`
    /// now and then.
    ///
    /// # Errors
    /// [`RunError::Stopped`] if `go_on` returns false, and the errors of `put` and of cells. The bands passed on before
    /// are valid.
    pub fn cells(
        &self,
        cells: std::ops::Range<u64>,
        go_on: &GoOn<'_>,
        put: &mut TakeOutcomes<'_>,
    ) -> Result<Workload, RunError> {
        let mut effort = Workload::default();
        let mut size = self.first_band();
        let mut first = cells.start;
        // The method as it was begun is that of the first tile.
        let (mut tile, mut own) = (self.grid.tile(0), None);
        while first < cells.end {
            let began = Instant::now();
            if !tile.cells.contains(&first) {
                tile = self.grid.tile(first);
                own = self.method_on(&tile)?;
            }
            let last = cells.end.min(tile.cells.end).min(first + size as u64);
            let band: Vec<u64> = (first..last).collect();
            let outcomes = match own.as_ref().unwrap_or(&self.method) {
                Method::Kernel(kernel) => {
                    let kernel = Placed { kernel, first: tile.cells.start };
                    self.by_lanes(Some(kernel), &band, go_on, &mut effort)?
                }
                Method::Lanes(_) => self.by_lanes(None, &band, go_on, &mut effort)?,
                Method::Single => self.by_itself(&band, go_on, &mut effort)?,
            };
            let done = &band[..outcomes.len()];
            let steps: u64 = done.iter().map(|cell| self.grid.rows(*cell)).sum();
            effort.cells += done.len() as u64;
            effort.rollout_steps += steps * self.grid.stabilizers.len() as u64;
            self.pool.install(|| put(first, &outcomes))?;
            if done.len() < band.len() || !go_on() {
                return Err(RunError::Stopped);
            }
            first = last;
            let share = BAND.as_secs_f64() / began.elapsed().as_secs_f64().max(1e-6);
            size = ((size as f64 * share.clamp(0.25, 4.0)) as usize).clamp(self.threads(), MOST);
        }
        Ok(effort)
    }

    /// The method for the cells of `tile`, where it is not that of all.
    fn method_on(&self, tile: &Tile) -> Result<Option<Method>, RunError> {
        match self.method {
            Method::Kernel(_) => Method::of(self.grid, tile).map(Some),
            Method::Lanes(_) | Method::Single => Ok(None),
        }
    }

    /// The verdicts on `cells`, in their order, under `member`; polls `go_on` now and then.
    ///
    /// # Errors
    /// [`RunError::Stopped`] if `go_on` returns false, and a cell whose values make no scene.
    pub(super) fn verdicts(
        &self,
        member: StabilizerName,
        cells: &[u64],
        go_on: &GoOn<'_>,
    ) -> Result<Vec<Verdict>, RunError> {
        let (mut all, mut left) = (Vec::with_capacity(cells.len()), cells);
        while let Some(&first) = left.first() {
            let tile = self.grid.tile(first);
            let here = left.partition_point(|cell| tile.cells.contains(cell));
            let (band, rest) = left.split_at(here);
            left = rest;
            match (self.method_on(&tile)?, member.basic_name()) {
                (Some(Method::Kernel(kernel)), Some(name)) => {
                    let placed = Placed { kernel: &kernel, first: tile.cells.start };
                    let judged = self.judged(placed, name, band, go_on)?;
                    all.extend(judged.into_iter().map(|(verdict, _)| verdict));
                }
                _ => {
                    let outcomes = self.of_boxes(&[member], band, go_on)?;
                    all.extend(outcomes.into_iter().flatten().map(|outcome| outcome.verdict));
                }
            }
        }
        Ok(all)
    }

    /// Verdicts of the kernel of a tile.
    fn judged(
        &self,
        placed: Placed<'_>,
        basic_name: BasicName,
        band: &[u64],
        go_on: &GoOn<'_>,
    ) -> Result<Vec<(Verdict, Yardstick)>, RunError> {
        self.shared(band, |cells| {
            let verdicts = placed.kernel.verdicts(basic_name, &placed.cells(cells), go_on);
            verdicts.map_err(|error| self.blamed(cells, error))
        })
    }

    /// Size of the first band, so small that it is short whatever a cell takes.
    fn first_band(&self) -> usize {
        let rows = self.grid.rows(0).max(self.grid.rows(self.grid.cells() - 1));
        let fast = matches!(self.method, Method::Kernel(_))
            && self.grid.stabilizers.iter().all(|member| member.basic_name().is_some());
        let steps: u64 = if fast { 20_000_000 } else { 64_000 };
        ((steps / rows) as usize * self.threads()).clamp(self.threads(), MOST / 4)
    }

    fn by_lanes(
        &self,
        kernel: Option<Placed<'_>>,
        band: &[u64],
        go_on: &GoOn<'_>,
        effort: &mut Workload,
    ) -> Result<Vec<Vec<Outcome>>, RunError> {
        let basic = |member: &StabilizerName| {
            kernel.and_then(|kernel| Some((kernel, member.basic_name()?)))
        };
        let members = &self.grid.stabilizers;
        let others: Vec<_> = members.iter().copied().filter(|it| basic(it).is_none()).collect();
        let began = Instant::now();
        let boxed = self.of_boxes(&others, band, go_on)?;
        let mut boxed: Vec<_> = boxed.into_iter().map(Vec::into_iter).collect();
        effort.kernel_seconds += began.elapsed().as_secs_f64();
        let mut outcomes = vec![Vec::with_capacity(members.len()); band.len()];
        for member in members.iter() {
            let found = match basic(member) {
                Some((kernel, name)) => self.on_lanes(kernel, name, band, go_on, effort)?,
                None => boxed.iter_mut().filter_map(Iterator::next).collect(),
            };
            outcomes.iter_mut().zip(found).for_each(|(outcomes, found)| outcomes.push(found));
        }
        Ok(outcomes)
    }

    fn on_lanes(
        &self,
        placed: Placed<'_>,
        basic_name: BasicName,
        band: &[u64],
        go_on: &GoOn<'_>,
        effort: &mut Workload,
    ) -> Result<Vec<Outcome>, RunError> {
        let began = Instant::now();
        let verdicts = self.judged(placed, basic_name, band, go_on)?;
        effort.kernel_seconds += began.elapsed().as_secs_f64();
        let began = Instant::now();
        let measured: Vec<usize> =
            (0..band.len()).filter(|at| verdicts[*at].0 != Verdict::Grows).collect();
        let cells: Vec<u64> = measured.iter().map(|at| band[*at]).collect();
        let measures = self.shared(&cells, |cells| {
            let measures = placed.kernel.measures(basic_name, &placed.cells(cells), go_on);
            measures.map_err(|error| self.blamed(cells, error))
        })?;
        let unmeasured =
            |(verdict, verdict_by)| Outcome::of(verdict, verdict_by, Measures::default());
        let mut outcomes: Vec<Outcome> = verdicts.into_iter().map(unmeasured).collect();
        for (at, measures) in measured.into_iter().zip(measures) {
            let Outcome { verdict, verdict_by, .. } = outcomes[at];
            outcomes[at] = Outcome::of(verdict, verdict_by, measures);
        }
        effort.measures_seconds += began.elapsed().as_secs_f64();
        Ok(outcomes)
    }

    /// Outcomes of loops of boxes, for each cell under each of the `members`.
    fn of_boxes(
        &self,
        members: &[StabilizerName],
        band: &[u64],
        go_on: &GoOn<'_>,
    ) -> Result<Vec<Vec<Outcome>>, RunError> {
        match members {
            [] => Ok(vec![Vec::new(); band.len()]),
            _ => self.shared(band, |cells| self.outcomes(cells, members, go_on)),
        }
    }

    fn outcomes(
        &self,
        cells: &[u64],
        members: &[StabilizerName],
        go_on: &GoOn<'_>,
    ) -> Result<Option<Vec<Vec<Outcome>>>, RunError> {
        let scenes = cells.iter().map(|cell| self.grid.scene_of(*cell));
        let scenes = scenes.collect::<Result<Vec<_>, _>>()?;
        let mut all = vec![Vec::with_capacity(members.len()); cells.len()];
        for member in members {
            let Some(found) = self.outcomes_under(*member, cells, &scenes, go_on)? else {
                return Ok(None);
            };
            all.iter_mut().zip(found).for_each(|(outcomes, found)| outcomes.push(found));
        }
        Ok(Some(all))
    }

    /// Outcomes of cells of `scenes` under `member`, into whose table an axis may write.
    fn outcomes_under(
        &self,
        member: StabilizerName,
        cells: &[u64],
        scenes: &[Scene],
        go_on: &GoOn<'_>,
    ) -> Result<Option<Vec<Outcome>>, RunError> {
        let written = self.grid.written(cells, scenes, member)?;
        let scenes = written.as_deref().unwrap_or(scenes);
        let instructions = self.method.instructions();
        let tables: Vec<_> = scenes.iter().map(|it| member.table(it)).collect();
        let runs = Runs { scenes, told: scenes, tables: &tables, instructions };
        let judged = runs.measured::<AllMeasures>(go_on).map_err(|(place, error)| {
            RunError::Cell(self.grid.refused(cells[place], member, error))
        })?;
        let outcome = |judged: Judged<Measures>| {
            let measures = judged.reading.unwrap_or_default();
            let active = measures.active.filter(|_| member.reports_damping());
            Outcome::of(judged.verdict, judged.verdict_by, Measures { active, ..measures })
        };
        Ok(judged.map(|judged| judged.into_iter().map(outcome).collect()))
    }

    /// Results of `of` for all cells, on all threads: in shares that become smaller, so that threads finish together.
    fn shared<R: Send>(
        &self,
        cells: &[u64],
        of: impl Fn(&[u64]) -> Result<Option<Vec<R>>, RunError> + Sync,
    ) -> Result<Vec<R>, RunError> {
        let mut left = cells;
        // A band of few cells is one that takes long.
        let least = LEAST.min(cells.len().div_ceil(self.threads()));
        let shares = std::iter::from_fn(|| {
            let share = (left.len() / (4 * self.threads())).clamp(least, SHARE).min(left.len());
            left.split_off(..share).filter(|share| !share.is_empty())
        });
        let one = |cells: &[u64]| of(cells)?.ok_or(RunError::Stopped);
        let mut shares: Vec<(usize, Result<Vec<R>, RunError>)> = self.pool.install(|| {
            // `par_bridge` hands the shares out in their order, as threads ask for them.
            shares.enumerate().par_bridge().map(|(at, cells)| (at, one(cells))).collect()
        });
        shares.sort_unstable_by_key(|(at, _)| *at);
        let mut all = Vec::with_capacity(cells.len());
        for (_, share) in shares {
            all.extend(share?);
        }
        Ok(all)
    }

    /// The error of a share, with the cell that causes it.
    fn blamed(&self, cells: &[u64], error: lyapunov::ParameterError) -> RunError {
        let fault = cells.iter().find_map(|cell| self.grid.scene_of(*cell).err());
        RunError::Cell(fault.unwrap_or_else(|| self.grid.at(cells[0], error.to_string())))
    }

    /// Outcomes of cells run one by one, up to the first that was stopped.
    fn by_itself(
        &self,
        band: &[u64],
        go_on: &GoOn<'_>,
        effort: &mut Workload,
    ) -> Result<Vec<Vec<Outcome>>, RunError> {
        let began = Instant::now();
        let members: Vec<_> = self.grid.stabilizers.iter().copied().collect();
        let one = |cell: &u64| -> Result<Option<Vec<Outcome>>, RunError> {
            let outcomes = self.outcomes(&[*cell], &members, go_on)?;
            Ok(outcomes.map(|outcomes| outcomes.into_iter().flatten().collect()))
        };
        let cells: Vec<_> = self.pool.install(|| band.par_iter().map(one).collect());
        effort.kernel_seconds += began.elapsed().as_secs_f64();
        let mut outcomes = Vec::with_capacity(band.len());
        for cell in cells {
            match cell? {
                Some(cell) => outcomes.push(cell),
                None => break,
            }
        }
        Ok(outcomes)
    }
}
