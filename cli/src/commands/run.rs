//! The command `lyapunov run`.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::ProgressBar;
use lyapunov::ParameterError;
use lyapunov_lab::explain::Hint;
use lyapunov_lab::run::Curves;
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{Csv, OutputError, Rollout, Space, Summary, in_space};

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{BAR, End, say, shown, standard_output};
use crate::files::{Inputs, Output};

/// The file that `--json` prints.
const RESULTS: &str = "run.json";

/// Ticks between two updates of the bar and checks for interrupts.
const BREATH: u64 = 1 << 16;

/// Simulate a scene and summarize the run.
///
/// The summary says whether the run settles, swings or grows. It goes to standard output, or to standard error where
/// `--csv -` sends the rows to standard output. docs/contract.md defines the rows, docs/command.md the JSON,
/// docs/verdicts.md the verdict.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Run {
    /// The scene file, TOML.
    scene: PathBuf,
    /// Write one row per servo tick to this file; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write report.html, run.json, the rows (run.csv) and a plot of position, force, energy and velocity (SVG and PNG)
    /// into this folder; made if not there.
    #[arg(long, value_name = "DIR", conflicts_with = "csv")]
    out: Option<PathBuf>,
    /// Say it as JSON.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Say nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Run {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        if let Some(out) = &self.out {
            return self.fill(&scene, out);
        }
        match &self.csv {
            Some(path) if path == Path::new("-") => {
                // Standard output by itself writes each line separately.
                let output = BufWriter::new(io::stdout().lock());
                let mut csv = Csv::of(output, &scene).map_err(standard_output)?;
                let hidden = ProgressBar::hidden();
                let told = simulate(&scene, &hidden, Some((&mut csv, &standard_output)), None)?;
                csv.into_inner().map_err(standard_output)?;
                if !self.quiet {
                    say(self.words(&told)?.trim_end());
                }
            }
            Some(path) => {
                Inputs::scene(&self.scene, &scene).spare(path)?;
                let output = Output::create(path).map_err(End::input)?;
                let refused = |error| End::input(OutputError::new(path, error));
                let mut csv = Csv::of(output, &scene).map_err(refused)?;
                let bar = self.progress(&scene);
                let told = simulate(&scene, &bar, Some((&mut csv, &refused)), None)?;
                csv.into_inner().map_err(refused)?.keep().map_err(End::input)?;
                self.tell(&told)?;
            }
            None => {
                let nowhere: Option<Rows<'_, io::Sink>> = None;
                self.tell(&simulate(&scene, &self.progress(&scene), nowhere, None)?)?;
            }
        }
        Ok(())
    }

    /// Simulates with results in the folder `out`.
    fn fill(&self, scene: &Scene, out: &Path) -> Result<(), End> {
        let inputs = Inputs::scene(&self.scene, scene);
        let folder = Folder::claim(out, names(RESULTS, ["run"], ["run.csv"]), &inputs)?;
        let place = out.join("run.csv");
        let refused = |error| End::input(OutputError::new(&place, error));
        let output = Output::create(&place).map_err(End::input)?;
        let mut csv = Csv::of(output, scene).map_err(refused)?;
        let mut curves = Curves::new(scene);
        let rows = Some((&mut csv, &refused as &dyn Fn(io::Error) -> End));
        let told = simulate(scene, &self.progress(scene), rows, Some(&mut curves))?;
        let name = self.scene.display().to_string();
        let page = curves.to_html(&name, &told, &command_line());
        let json = told.to_json(&name).map_err(End::internal)?;
        let results = Results::new(page, RESULTS, &json);
        let results = results.with_figure("run", &curves.figure(&name, &told))?;
        folder.fill(results.with_rows(csv.into_inner().map_err(refused)?))?;
        self.tell(&told)
    }

    fn tell(&self, summary: &Summary) -> Result<(), End> {
        if self.quiet {
            return Ok(());
        }
        io::stdout().write_all(self.words(summary)?.as_bytes()).map_err(standard_output)
    }

    fn words(&self, summary: &Summary) -> Result<String, End> {
        let scene = self.scene.display();
        if self.json {
            summary.to_json(&scene.to_string()).map_err(End::internal)
        } else {
            Ok(format!("{scene}\n{summary}\n{}", Hint::of(summary)))
        }
    }

    /// Progress bar, hidden for a short run.
    fn progress(&self, scene: &Scene) -> ProgressBar {
        if self.quiet || scene.ticks() < 50 * BREATH {
            return ProgressBar::hidden();
        }
        shown(ProgressBar::new(scene.ticks()), BAR)
    }
}

/// Destination of the ticks of a run, and the meaning of an error there.
type Rows<'a, W> = (&'a mut Csv<W>, &'a dyn Fn(io::Error) -> End);

fn simulate<W: Write>(
    scene: &Scene,
    bar: &ProgressBar,
    rows: Option<Rows<'_, W>>,
    curves: Option<&mut Curves>,
) -> Result<Summary, End> {
    in_space!(scene, Axes => drain(scene, bar, Rollout::<Axes>::of(scene), rows, curves))
}

fn drain<V: Space, W: Write>(
    scene: &Scene,
    bar: &ProgressBar,
    rollout: Result<Rollout<V>, ParameterError>,
    mut rows: Option<Rows<'_, W>>,
    mut curves: Option<&mut Curves>,
) -> Result<Summary, End> {
    let mut summary = Summary::new(scene);
    for tick in rollout.map_err(End::input)? {
        if summary.rows.is_multiple_of(BREATH) {
            End::if_interrupted()?;
            bar.set_position(summary.rows);
        }
        if let Some((csv, refused)) = &mut rows {
            csv.write(&tick).map_err(refused)?;
        }
        summary.add(&tick);
        if let Some(curves) = &mut curves {
            curves.add(&tick, &summary);
        }
    }
    bar.finish_and_clear();
    Ok(summary)
}
