//! The command `lyapunov map`.

mod merge;
mod refine;

use std::fmt::Write as _;
use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use indicatif::ProgressBar;
use lyapunov_lab::family::{StabilizerName, StabilizerNames};
use lyapunov_lab::map::{
    Axis, Bounds, Checkpoint, CheckpointError, Computation, Grid, Run, RunError, Shard, Survey,
    SweepPlan, areas, document, figure_names, figures, page, table_name,
};
use lyapunov_lab::scene::{Scalar, Scene};
use lyapunov_lab::shell_word;
use rayon::prelude::*;

use self::merge::Merge;
use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{BAR, End, advance, named, program, shown, tell};
use crate::files::{Inputs, Output};
use crate::interrupts::Untidy;
use crate::pictures::pictures;

/// The file that `--json` prints.
const RESULTS: &str = "map.json";

/// The file that `--json` prints of a sweep.
const SWEEP: &str = "sweep.json";

/// The file of the scene that the page of merged shards shows, as its commands name it.
const MERGED: &str = "scene.toml";

/// Map in which cells of a grid of two numbers of a scene the run settles, swings or grows, and how it behaves.
///
/// Prints which share of the runs settles under each stabilizer, and which stays bounded. With --out it writes map.csv (a
/// row for each cell and stabilizer, the scene in its head), heat maps (SVG and PNG), map.json and report.html.
///
/// Without --y it sweeps the number --x alone and draws curves, with the rows in sweep.csv and sweep.json. An axis
/// stabilizer.NAME.KEY applies to that stabilizer only, whether or not the scene has its table. With --refine it finds only where
/// the runs begin to grow, from few of the grid's runs. docs/map.md defines them, docs/verdicts.md the verdicts.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct Map {
    #[command(subcommand)]
    merge: Option<Shards>,
    /// The scene file, TOML.
    #[arg(required = true, value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// The axis to the right: a number of the scene, or of a stabilizer that takes part, by its dotted key.
    #[arg(long, required = true, value_name = "KEY=FROM..TO:N[:log]")]
    x: Option<Axis>,
    /// The axis upwards; without it the number of --x is swept.
    #[arg(long, value_name = "KEY=FROM..TO:N[:log]")]
    y: Option<Axis>,
    /// Who runs in each cell, by the names of docs/family.md, or all.
    #[arg(long, default_value = "none,popc,lolc", value_name = "NAMES")]
    stabilizers: StabilizerNames,
    /// Write the map into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Go on with the unfinished map in the folder; not for a sweep, which is a map without --y.
    #[arg(long, requires_all = ["out", "y"])]
    resume: bool,
    /// Compute share i of n only, i from 0; `lyapunov map merge` puts the shares together; not for
    /// a sweep.
    #[arg(long, value_name = "i/n", requires_all = ["out", "y"])]
    shard: Option<Shard>,
    /// Find the edge of bounded runs at the resolution of the grid, from few of its runs.
    #[arg(long, requires = "y", conflicts_with_all = ["resume", "shard"])]
    refine: bool,
    /// Threads; by default one for each core.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Print map.json instead of the table.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Shards {
    Merge(Merge),
}

impl From<CheckpointError> for End {
    fn from(error: CheckpointError) -> Self {
        match error {
            error @ CheckpointError::Stopped(_) => Self::Kept(error.to_string()),
            error => Self::input(error),
        }
    }
}

impl Map {
    pub(crate) fn run(&self) -> Result<(), End> {
        if let Some(Shards::Merge(merge)) = &self.merge {
            return merge.run();
        }
        let (Some(scene), Some(x)) = (&self.scene, &self.x) else {
            return Err(End::internal("an argument is missing"));
        };
        let scene = Scene::load(scene).map_err(End::input)?;
        let Some(y) = &self.y else { return self.sweep(scene, x) };
        let stabilizers = self.stabilizers.on(&scene);
        let grid = Grid::new(scene, x.clone(), y.clone(), stabilizers);
        let grid = grid.map_err(|error| self.blame(error))?;
        let shard = self.shard.unwrap_or(Shard::WHOLE);
        let threads = self.threads.map(usize::from);
        let run = Run::of(&grid, threads).map_err(|error| self.ended(error))?;
        if self.refine {
            return self.refine(&grid, &run);
        }
        let mut survey = Survey::of(&grid);
        let go_on = || End::if_interrupted().is_ok();
        let folder = self.out.as_deref().map(|path| self.claim(path, &grid, shard)).transpose()?;
        // The unfinished table stays, and where it is has to be said.
        let untidy = folder.as_ref().map(|_| Untidy::new());
        let mut checkpoint = match &folder {
            None => None,
            Some(folder) => {
                let checkpoint = Checkpoint::open(
                    folder.path(),
                    &grid,
                    shard,
                    self.resume,
                    &mut survey,
                    &go_on,
                )?;
                folder.keep();
                Some(checkpoint)
            }
        };
        let effort = self.compute(&run, &grid, shard, &mut checkpoint, &mut survey)?;
        let computation = Computation::of(&run, effort);
        // A shard does not know the cells along a whole axis.
        let bounds = if shard == Shard::WHOLE { run.install(|| Bounds::of(&grid)) } else { None };
        let text = document(&survey, bounds.as_ref(), Some(&computation));
        if let (Some(folder), Some(checkpoint)) = (&folder, checkpoint) {
            let beside = || self.beside(shard, &survey, bounds.as_ref(), &text);
            let cells = shard.cells(grid.cells());
            finish(folder, checkpoint, shard, cells, run.install(beside)?)?;
        }
        drop((folder, untidy));
        self.say(&survey, shard, &computation, &text)
    }

    /// The files beside the table of `shard`: none but of the whole map.
    fn beside(
        &self,
        shard: Shard,
        survey: &Survey,
        bounds: Option<&Bounds>,
        text: &str,
    ) -> Result<Results, End> {
        if shard != Shard::WHOLE {
            return Ok(Results::of(Vec::new()));
        }
        let file = named(self.scene.as_deref().unwrap_or(Path::new(MERGED)));
        results(survey, bounds, text, [&self.command(), &file])
    }

    /// The folder at `path` for the files of `shard`; shards share theirs.
    fn claim<'a>(&self, path: &'a Path, grid: &Grid, shard: Shard) -> Result<Folder<'a>, End> {
        let scene = self.scene.as_deref().unwrap_or(Path::new(MERGED));
        let (inputs, table) = (Inputs::scene(scene, &grid.scene), table_name(shard));
        match shard == Shard::WHOLE {
            true => Folder::claim(path, names(RESULTS, figure_names(), [table]), &inputs),
            false => Folder::share(path, [table], &inputs),
        }
    }

    /// Sweeps the number `x` of `scene`.
    fn sweep(&self, scene: Scene, x: &Axis) -> Result<(), End> {
        let path = self.scene.as_deref().unwrap_or(Path::new(""));
        let name = named(path);
        let stabilizers = self.stabilizers.on(&scene);
        let inputs = Inputs::scene(path, &scene);
        let plan = SweepPlan::new(&name, scene, x.clone(), stabilizers);
        let plan = plan.map_err(|error| self.blame(error))?;
        let files = names(SWEEP, ["verdicts", "sweep"], ["sweep.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let bar = shown(ProgressBar::new(plan.ticks()), BAR, self.quiet);
        let watch = |ticks| advance(&bar, ticks);
        let sweep =
            plan.run(self.threads.map(usize::from), &watch).map_err(|error| self.ended(error))?;
        bar.finish_and_clear();
        let text = sweep.to_json();
        if let Some(folder) = folder {
            let results = Results::new(sweep.to_html(&command_line()), SWEEP, &text);
            let results = results.with_file("sweep.csv", sweep.csv());
            let results = results.with_figure("verdicts", &sweep.verdicts())?;
            folder.fill(results.with_figure("sweep", &sweep.curves())?)?;
        }
        tell(self.json, self.quiet, text, sweep)
    }

    fn compute(
        &self,
        run: &Run<'_>,
        grid: &Grid,
        shard: Shard,
        checkpoint: &mut Option<Checkpoint>,
        survey: &mut Survey,
    ) -> Result<lyapunov_lab::map::Workload, End> {
        let cells = shard.cells(grid.cells());
        let first = checkpoint.as_ref().map_or(cells.start, Checkpoint::next);
        let bar = shown(ProgressBar::new(cells.end - cells.start), BAR, self.quiet);
        bar.set_position(first - cells.start);
        bar.reset_eta();
        let go_on = || End::if_interrupted().is_ok();
        let done = run.cells(first..cells.end, &go_on, &mut |first, outcomes| {
            if let Some(checkpoint) = checkpoint {
                checkpoint.put(grid, outcomes)?;
            }
            for (cell, outcomes) in (first..).zip(outcomes) {
                survey.add(cell, outcomes);
            }
            bar.inc(outcomes.len() as u64);
            Ok(())
        });
        bar.finish_and_clear();
        done.map_err(|error| match (error, checkpoint.as_ref()) {
            (RunError::Stopped, Some(checkpoint)) => kept(checkpoint, cells),
            (RunError::Output(error), Some(_)) => {
                End::input(format!("{error}\n  = then go on with --resume"))
            }
            (error, _) => self.ended(error),
        })
    }

    /// End of a map that this error ends.
    fn ended(&self, error: RunError) -> End {
        match error {
            RunError::Stopped => End::Interrupted,
            RunError::Threads(_) => End::input(error),
            RunError::Output(error) => End::input(error),
            RunError::Cell(error) => self.blame(error),
        }
    }

    /// Input error about the map in this file.
    fn blame(&self, error: impl std::fmt::Display) -> End {
        let file = self.scene.as_deref().map_or_else(String::new, named);
        End::input(format!("{file}: {error}"))
    }

    /// Command line that makes the same map.
    fn command(&self) -> String {
        let mut text = format!("{} map", program());
        if let (Some(scene), Some(x), Some(y)) = (&self.scene, &self.x, &self.y) {
            let _ = write!(text, " {} --x {x} --y {y}", shell_word(&scene.to_string_lossy()));
        }
        format!("{text} --stabilizers {}", self.stabilizers)
    }

    fn say(
        &self,
        survey: &Survey,
        shard: Shard,
        computation: &Computation,
        text: &str,
    ) -> Result<(), End> {
        let mut said = String::new();
        if shard != Shard::WHOLE {
            let _ = writeln!(said, "shard {shard} of the map");
        }
        said += &areas(survey);
        let is_own = |it: &StabilizerName| matches!(it, StabilizerName::Own(_));
        let how = match computation.instructions {
            Some(set) if survey.grid().stabilizers.iter().any(is_own) => format!(
                "{} cells at once ({set}), one at a time under stabilizers of your own",
                computation.lanes
            ),
            Some(set) => format!("{} cells at once ({set})", computation.lanes),
            None => format!("one cell at a time, as {}", alone(&survey.grid().scene)),
        };
        let _ = writeln!(said, "\n{how}, {} thread(s)", computation.threads);
        tell(self.json, self.quiet, text, said)
    }
}

/// The reason why the cells of `scene` have no lanes.
fn alone(scene: &Scene) -> &'static str {
    if scene.scalar == Scalar::F32 {
        "the scene is in f32"
    } else if scene.dimensions() > 1 {
        "the scene is in a space"
    } else {
        "the integrator is adaptive"
    }
}

/// Writes all files of the map, or the table of the shard, of which `cells` were asked for, and removes the unfinished table.
fn finish(
    folder: &Folder<'_>,
    mut checkpoint: Checkpoint,
    shard: Shard,
    cells: Range<u64>,
    beside: Results,
) -> Result<(), End> {
    let place = folder.path().join(table_name(shard));
    let mut table = Output::create(&place).map_err(End::input)?;
    let go_on = || End::if_interrupted().is_ok();
    let written = checkpoint.write_table(&mut table, &place, &go_on).map_err(End::from);
    written.and_then(|()| folder.fill(beside.with_rows(table))).map_err(|end| match end {
        End::Interrupted => kept(&checkpoint, cells),
        end => end,
    })?;
    checkpoint.remove().map_err(End::input)
}

/// End of an interrupted map, of which `cells` were asked for.
fn kept(checkpoint: &Checkpoint, cells: Range<u64>) -> End {
    End::Kept(format!(
        "interrupted: {} of {} cells are in {}\n  = go on with --resume",
        checkpoint.next() - cells.start,
        cells.end - cells.start,
        checkpoint.part().display()
    ))
}

/// The files beside the table; `command` made them of the file `scene`.
fn results(
    survey: &Survey,
    bounds: Option<&Bounds>,
    text: &str,
    [command, scene]: [&str; 2],
) -> Result<Results, End> {
    let figures = figures(survey, bounds);
    let drawn: Result<Vec<_>, _> =
        figures.par_iter().map(|drawn| pictures(drawn.name, &drawn.figure)).collect();
    let drawn = drawn.map_err(End::internal)?.into_iter().flatten();
    let page = page(survey, &figures, command, scene);
    Ok(drawn.fold(Results::new(page, RESULTS, text), |results, (name, bytes)| {
        results.with_file(name, bytes)
    }))
}
