//! Map of a scene over two of its numbers, or a sweep over one.

use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::map::{
    Axis, Bounds, Computation, Grid, Measure, Outcome, Run, RunError, Survey, SweepPlan, areas,
    document, figures,
};
use lyapunov_lab::scene as lab;
use pyo3::prelude::*;

use super::columns::{Column, Columns, MOST_ROWS, Words};
use super::compare::scored;
use super::work::{Fault, Watched, wait};
use super::{Scene, Told};
use crate::errors;
use crate::whole;

/// Where a run settles, swings or grows over the axes `x` and `y`, each as KEY=FROM..TO:N[:log].
#[pyfunction]
#[pyo3(signature = (scene, x, y=None, stabilizers="none,popc,lolc", threads=None, progress=None))]
pub(crate) fn map(
    py: Python<'_>,
    scene: &Bound<'_, Scene>,
    x: &str,
    y: Option<&str>,
    stabilizers: &str,
    #[pyo3(from_py_with = whole::threads_if_any)] threads: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    let x: Axis = x.parse().map_err(errors::input)?;
    let names: StabilizerNames = stabilizers.parse().map_err(errors::input)?;
    match y {
        None => {
            fits(("value", x.count, SWEPT), &names, "")?;
            let plan = SweepPlan::new(&name, scene.clone(), x, names.on(&scene));
            let plan = plan.map_err(|error| errors::input(format!("{name}: {error}")))?;
            wait(py, progress, plan.ticks(), move |watched| swept(plan, &name, threads, watched))
        }
        Some(y) => {
            let grid = grid_of(&name, scene, x, y.parse().map_err(errors::input)?, &names)?;
            fits(("cell", grid.cells(), MOST_ROWS), &grid.stabilizers, FILES)?;
            wait(py, progress, grid.cells(), move |watched| mapped(&grid, &name, threads, watched))
        }
    }
}

/// The most rows of a sweep, which holds the scene of each.
const SWEPT: u64 = 1_000_000;

/// Remedy for a map of more rows: where those go.
const FILES: &str = ", or let lyapunov.ray.map(…, folder=…) or `python -m lyapunov map --shard` write the rows into files";

/// Refuses more rows than a table holds: `places` are so many of a kind, of which each has a row under each of `names`.
fn fits(places: (&str, u64, u64), names: &StabilizerNames, elsewhere: &str) -> PyResult<()> {
    let ((kind, count, most), each) = (places, names.len() as u64);
    match count.checked_mul(each).filter(|rows| *rows <= most) {
        Some(_) => Ok(()),
        None => Err(errors::input(format!(
            "{count} {kind}s under {each} stabilizer(s) are more than the {most} rows that the table may have\n  = give coarser axes or \
             fewer stabilizers{elsewhere}"
        ))),
    }
}

/// The grid of a map.
pub(super) fn grid_of(
    name: &str,
    scene: lab::Scene,
    x: Axis,
    y: Axis,
    names: &StabilizerNames,
) -> PyResult<Grid> {
    let names = names.on(&scene);
    Grid::new(scene, x, y, names).map_err(|error| errors::input(format!("{name}: {error}")))
}

/// The fault that an error of a map's run is.
pub(super) fn fault(name: &str, error: RunError) -> Fault {
    match error {
        RunError::Stopped => Fault::Stopped,
        error @ RunError::Threads(_) => Fault::input(error),
        error => Fault::input(format_args!("{name}: {error}")),
    }
}

fn swept(
    plan: SweepPlan,
    name: &str,
    threads: Option<usize>,
    watched: &Watched,
) -> Result<Told, Fault> {
    let sweep =
        plan.run(threads, &|ticks| watched.add(ticks)).map_err(|error| fault(name, error))?;
    Ok(Told {
        json: sweep.to_json(),
        text: sweep.to_string(),
        figures: vec![sweep.verdicts().to_svg(), sweep.curves().to_svg()],
        columns: scored(&sweep.csv())?.into(),
        ..Told::default()
    })
}

fn mapped(
    grid: &Grid,
    name: &str,
    threads: Option<usize>,
    watched: &Watched,
) -> Result<Told, Fault> {
    let run = Run::of(grid, threads).map_err(|error| fault(name, error))?;
    let (mut survey, mut rows) = (Survey::of(grid), Rows::default());
    let go_on = || watched.go_on().is_continue();
    let effort = run.cells(0..grid.cells(), &go_on, &mut |first, outcomes| {
        for (cell, outcomes) in (first..).zip(outcomes) {
            survey.add(cell, outcomes);
            rows.add(grid, cell, outcomes);
        }
        // The next band asks whether to go on.
        let _ = watched.add(outcomes.len() as u64);
        Ok(())
    });
    let effort = effort.map_err(|error| fault(name, error))?;
    let computation = Computation::of(&run, effort);
    let told = told(&survey, Some(&computation))?;
    Ok(Told { columns: rows.columns(grid).into(), ..told })
}

/// All that a survey tells, but its rows.
pub(super) fn told(survey: &Survey, computation: Option<&Computation>) -> Result<Told, Fault> {
    let bounds = Bounds::of(survey.grid());
    let drawn = figures(survey, bounds.as_ref());
    Ok(Told {
        json: document(survey, bounds.as_ref(), computation),
        text: areas(survey),
        figures: drawn.iter().map(|drawn| drawn.figure.to_svg()).collect(),
        ..Told::default()
    })
}

/// The columns of words in map.csv.
const WORDS: [&str; 3] = ["stabilizer", "verdict", "verdict_by"];

/// The rows of map.csv; none of a map that has more than [`MOST_ROWS`].
#[derive(Debug, Default)]
pub(super) struct Rows {
    count: u64,
    places: [Vec<f64>; 2],
    words: [Words; 3],
    measures: Vec<Vec<f64>>,
}

impl Rows {
    pub(super) fn add(&mut self, grid: &Grid, cell: u64, outcomes: &[Outcome]) {
        self.count += outcomes.len() as u64;
        if self.count > MOST_ROWS {
            *self = Self { count: self.count, ..Self::default() };
            return;
        }
        self.measures.resize(Measure::ALL.len(), Vec::new());
        let values = grid.values(cell);
        for (member, outcome) in grid.stabilizers.iter().zip(outcomes) {
            for (place, value) in self.places.iter_mut().zip(values) {
                place.push(value);
            }
            let words = [member.name(), outcome.verdict.word(), outcome.verdict_by.word()];
            for (column, word) in self.words.iter_mut().zip(words) {
                column.push(word);
            }
            for (column, measure) in self.measures.iter_mut().zip(Measure::ALL) {
                column.push(measure.of(&outcome.measures).unwrap_or(f64::NAN));
            }
        }
    }

    pub(super) fn columns(self, grid: &Grid) -> Columns {
        if self.count > MOST_ROWS {
            return Columns::default();
        }
        let axes = [&grid.x.key, &grid.y.key].map(String::clone);
        let places = axes.into_iter().zip(self.places.map(Column::Numbers));
        let words = WORDS.map(str::to_owned).into_iter().zip(self.words.map(Column::Words));
        let keys = Measure::ALL.map(|measure| measure.key.to_owned());
        let measures = keys.into_iter().zip(self.measures.into_iter().map(Column::Numbers));
        Columns(places.chain(words).chain(measures).collect())
    }
}
