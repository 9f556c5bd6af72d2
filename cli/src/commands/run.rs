//! The command `lyapunov run`.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use indicatif::ProgressBar;
use lyapunov::ParameterError;
use lyapunov_lab::explain::Hint;
use lyapunov_lab::observe::{Columns, Scale};
use lyapunov_lab::run::{Against, Curves, Laid, Start};
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{Csv, OutputError, Rollout, Row, RowFile, Space, Summary, Tick, in_space};

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::source::Source;
use super::{BAR, End, named, print, say, shown, standard_output};
use crate::files::{Inputs, Output, Sidecar};
#[cfg(feature = "parquet")]
use crate::parquet::Parquet;

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
    /// Write one row per servo tick to this file, and beside it, as NAME.json, what the columns are and what made them; `-` is
    /// standard output.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write the same rows as Parquet to this file, with scene, seeds, units and version in its metadata; in a build with
    /// the feature parquet.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["csv", "out"])]
    parquet: Option<PathBuf>,
    /// Write report.html, run.json, the rows (run.csv) and a plot of position, force, energy and velocity (SVG and PNG)
    /// into this folder; made if not there.
    #[arg(long, value_name = "DIR", conflicts_with = "csv")]
    out: Option<PathBuf>,
    /// Lay this log over the run and tell the difference; `-` is standard input. Both have one clock, and the scene goes on
    /// at least as long as the log; docs/command.md defines the numbers, docs/observe.md what a log is.
    #[arg(long, value_name = "LOG")]
    against: Option<PathBuf>,
    /// The start of the run: the scene's own, or the log's first row, whose time is then 0.
    #[arg(long, value_enum, default_value_t = Word::Scene, requires = "against")]
    start: Word,
    /// The log's columns of time, position, force and, if there is one, velocity, as in lyapunov observe.
    #[arg(long, value_name = "T,X,F[,V]", default_value = "t,x,f", requires = "against")]
    columns: Columns,
    /// A factor from the log's unit of t, x, f or v to SI, as in lyapunov observe.
    #[arg(
        long,
        value_name = "COLUMN=FACTOR",
        value_delimiter = ',',
        allow_hyphen_values = true,
        requires = "against"
    )]
    scale: Vec<Scale>,
    /// The rows by which the log's force acts late, as that of a command does; identify tells them.
    #[arg(long, value_name = "ROWS", default_value_t = 0, allow_negative_numbers = true, requires = "against",
        value_parser = clap::value_parser!(u32).range(..=1000))]
    late: u32,
    /// Say it as JSON.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

/// The starts in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Word {
    Scene,
    Log,
}

/// A run that ended, and the log that was laid over it.
#[derive(Debug)]
struct Ended {
    summary: Summary,
    laid: Option<Laid>,
}

/// A log that is laid over a run.
type Log = Against<Source>;

impl Run {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        if let Some(out) = &self.out {
            let (scene, log) = self.laid_over(scene)?;
            return self.fill(&scene, log, out);
        }
        if let Some(path) = &self.parquet {
            return self.to_parquet(scene, path);
        }
        match &self.csv {
            Some(path) if path == Path::new("-") => {
                let (scene, log) = self.laid_over(scene)?;
                // Standard output by itself writes each line separately.
                let output = BufWriter::new(io::stdout().lock());
                let mut csv = Csv::of(output, &scene).map_err(standard_output)?;
                let hidden = ProgressBar::hidden();
                let rows = Rows::Csv(&mut csv, &standard_output);
                let told = simulate(&scene, &hidden, rows, None, log)?;
                csv.into_inner().map_err(standard_output)?;
                if !self.quiet {
                    say(self.words(&told)?.trim_end());
                }
            }
            Some(path) => {
                let inputs = self.inputs(&scene);
                inputs.spare(path)?;
                let sidecar = Sidecar::beside(path, &inputs)?;
                let (scene, log) = self.laid_over(scene)?;
                let output = Output::create(path).map_err(End::input)?;
                let refused = |error| End::input(OutputError::new(path, error));
                let mut csv = Csv::of(output, &scene).map_err(refused)?;
                let bar = self.progress(&scene);
                let told = simulate(&scene, &bar, Rows::Csv(&mut csv, &refused), None, log)?;
                sidecar.keep(csv.into_inner().map_err(refused)?, &RowFile::of(&scene))?;
                self.tell(&told)?;
            }
            None => {
                let (scene, log) = self.laid_over(scene)?;
                self.tell(&simulate(&scene, &self.progress(&scene), NOWHERE, None, log)?)?;
            }
        }
        Ok(())
    }

    /// Simulates with the rows as Parquet in the file at `path`.
    #[cfg(feature = "parquet")]
    fn to_parquet(&self, scene: Scene, path: &Path) -> Result<(), End> {
        self.inputs(&scene).spare(path)?;
        let (scene, log) = self.laid_over(scene)?;
        let output = Output::create(path).map_err(End::input)?;
        let refused = |error| End::input(OutputError::new(path, io::Error::other(error)));
        let mut rows = Parquet::of(output, &RowFile::of(&scene)).map_err(refused)?;
        let sink: Rows<'_, io::Sink> = Rows::Parquet(&mut rows, &refused);
        let told = simulate(&scene, &self.progress(&scene), sink, None, log)?;
        rows.into_inner().map_err(refused)?.keep().map_err(End::input)?;
        self.tell(&told)
    }

    /// The answer of a program that was built without it.
    #[cfg(not(feature = "parquet"))]
    fn to_parquet(&self, _scene: Scene, _path: &Path) -> Result<(), End> {
        let remedy = "take --csv, or build with it: cargo install --path cli --features parquet";
        Err(End::input(format_args!("this program was built without Parquet\n  = {remedy}")))
    }

    /// Simulates with results in the folder `out`.
    fn fill(&self, scene: &Scene, log: Option<Log>, out: &Path) -> Result<(), End> {
        let (figures, rows) = match log {
            None => (&["run"][..], &["run.csv"][..]),
            Some(_) => (&["run", "against"][..], &["run.csv", "against.csv"][..]),
        };
        let folder = Folder::claim(out, names(RESULTS, figures, rows), &self.inputs(scene))?;
        let place = out.join("run.csv");
        let refused = |error| End::input(OutputError::new(&place, error));
        let output = Output::create(&place).map_err(End::input)?;
        let mut csv = Csv::of(output, scene).map_err(refused)?;
        let mut curves = Curves::new(scene);
        let rows = Rows::Csv(&mut csv, &refused);
        let told = simulate(scene, &self.progress(scene), rows, Some(&mut curves), log)?;
        let name = named(&self.scene);
        let page = curves.to_html(&name, &told.summary, told.laid.as_ref(), &command_line());
        let results = Results::new(page, RESULTS, &self.json(&told));
        let mut results = results.with_figure("run", &curves.figure(&name, &told.summary))?;
        if let Some(laid) = &told.laid {
            results = results.with_figure("against", &laid.figure())?;
            results = results.with_file("against.csv", laid.csv());
        }
        folder.fill(results.with_rows(csv.into_inner().map_err(refused)?))?;
        self.tell(&told)
    }

    /// The scene as it is run, and the log that is laid over it.
    fn laid_over(&self, scene: Scene) -> Result<(Scene, Option<Log>), End> {
        let Some(path) = &self.against else { return Ok((scene, None)) };
        let start = match self.start {
            Word::Scene => Start::Scene,
            Word::Log => Start::Log,
        };
        let log = Source::read_by(path, true, |log, name| {
            Against::open(log, name, &self.columns, &self.scale, start)
        })?;
        let log = log.late(self.late);
        Ok((log.started(&scene).map_err(End::input)?, Some(log)))
    }

    /// The files that are read.
    fn inputs(&self, scene: &Scene) -> Inputs {
        Inputs::scene(&self.scene, scene).and("the log", self.against.as_deref())
    }

    fn tell(&self, told: &Ended) -> Result<(), End> {
        if self.quiet {
            return Ok(());
        }
        print(self.words(told)?)
    }

    fn words(&self, told: &Ended) -> Result<String, End> {
        if self.json {
            return Ok(self.json(told));
        }
        let (scene, summary) = (named(&self.scene), &told.summary);
        let laid = told.laid.as_ref().map_or_else(String::new, |laid| laid.text() + "\n");
        Ok(format!("{scene}\n{summary}\n{}{laid}", Hint::of(summary)))
    }

    fn json(&self, told: &Ended) -> String {
        let scene = named(&self.scene);
        match &told.laid {
            None => told.summary.to_json(&scene),
            Some(laid) => laid.to_json(&scene, &told.summary),
        }
    }

    /// Progress bar, hidden for a short run.
    fn progress(&self, scene: &Scene) -> ProgressBar {
        let short = scene.ticks() < 50 * BREATH;
        shown(ProgressBar::new(scene.ticks()), BAR, self.quiet || short)
    }
}

/// Destination of the ticks of a run, and the meaning of an error there.
enum Rows<'a, W: Write> {
    Nowhere,
    Csv(&'a mut Csv<W>, &'a dyn Fn(io::Error) -> End),
    #[cfg(feature = "parquet")]
    Parquet(&'a mut Parquet, &'a dyn Fn(::parquet::errors::ParquetError) -> End),
}

const NOWHERE: Rows<'_, io::Sink> = Rows::Nowhere;

impl<W: Write> Rows<'_, W> {
    fn write<V: Space>(&mut self, tick: &Tick<V>) -> Result<(), End> {
        match self {
            Self::Nowhere => Ok(()),
            Self::Csv(csv, refused) => csv.write(tick).map_err(refused),
            #[cfg(feature = "parquet")]
            Self::Parquet(rows, refused) => {
                rows.write(lyapunov_lab::row_numbers(tick)).map_err(refused)
            }
        }
    }
}

fn simulate<W: Write>(
    scene: &Scene,
    bar: &ProgressBar,
    rows: Rows<'_, W>,
    curves: Option<&mut Curves>,
    log: Option<Log>,
) -> Result<Ended, End> {
    in_space!(scene, Axes => drain(scene, bar, Rollout::<Axes>::of(scene), rows, curves, log))
}

fn drain<V: Space, W: Write>(
    scene: &Scene,
    bar: &ProgressBar,
    rollout: Result<Rollout<V>, ParameterError>,
    mut rows: Rows<'_, W>,
    mut curves: Option<&mut Curves>,
    mut log: Option<Log>,
) -> Result<Ended, End> {
    let mut summary = Summary::new(scene);
    let broken = |error| End::if_interrupted().err().unwrap_or_else(|| End::input(error));
    for tick in rollout.map_err(End::input)? {
        if summary.rows.is_multiple_of(BREATH) {
            End::if_interrupted()?;
            bar.set_position(summary.rows);
        }
        rows.write(&tick)?;
        summary.add(&tick);
        if let Some(curves) = &mut curves {
            curves.add(&tick, &summary);
        }
        if let Some(log) = &mut log {
            log.add(&Row::of(&tick), scene.period()).map_err(broken)?;
        }
    }
    bar.finish_and_clear();
    let laid = log.map(|log| log.finish(scene)).transpose().map_err(broken)?;
    Ok(Ended { summary, laid })
}
