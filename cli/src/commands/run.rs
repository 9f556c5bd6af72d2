//! The command `lyapunov run`.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::ProgressBar;
use lyapunov::ParameterError;
use lyapunov_lab::explain::Hint;
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{
    Csv, OutputError, Rollout, Row, Space, Summary, further_columns, further_numbers, in_space,
};

use super::{BAR, End, heed_interrupts, say, shown, standard_output};
use crate::output::Output;

/// Ticks between two updates of the bar and checks for interrupts.
const BREATH: u64 = 1 << 16;

/// Simulate a scene and summarize the run.
///
/// The summary goes to standard output, or to standard error where `--csv -` sends the rows to standard output.
/// docs/contract.md defines the rows, docs/command.md the JSON.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Run {
    /// The scene file, TOML.
    scene: PathBuf,
    /// Write one row per servo tick to this file; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
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
        let further = further_columns(&scene);
        match &self.csv {
            Some(path) if path == Path::new("-") => {
                heed_interrupts(false);
                // Standard output by itself writes each line separately.
                let output = BufWriter::new(io::stdout().lock());
                let mut csv = Csv::new(output, &further).map_err(standard_output)?;
                let hidden = ProgressBar::hidden();
                let told = simulate(&scene, &hidden, |row, further| {
                    csv.write(row, further).map_err(standard_output)
                })?;
                csv.into_inner().map_err(standard_output)?;
                if !self.quiet {
                    say(self.words(&told)?.trim_end());
                }
            }
            Some(path) => {
                self.spare_scene(path)?;
                heed_interrupts(!Output::is_direct(path));
                let output = Output::create(path).map_err(End::input)?;
                let refused = |error| End::input(OutputError::new(path, error));
                let mut csv = Csv::new(output, &further).map_err(refused)?;
                let told = simulate(&scene, &self.progress(&scene), |row, further| {
                    csv.write(row, further).map_err(refused)
                })?;
                csv.into_inner().map_err(refused)?.keep().map_err(End::input)?;
                self.tell(&told)?;
            }
            None => {
                heed_interrupts(false);
                self.tell(&simulate(&scene, &self.progress(&scene), |_, _| Ok(()))?)?;
            }
        }
        Ok(())
    }

    /// Error if the rows would overwrite the scene.
    fn spare_scene(&self, csv: &Path) -> Result<(), End> {
        match (fs::canonicalize(&self.scene), fs::canonicalize(csv)) {
            (Ok(scene), Ok(place)) if scene == place && place.is_file() => {
                let csv = csv.display();
                Err(End::input(format_args!(
                    "--csv {csv}: this is the scene itself, and the rows would replace it\n  \
                     = give the rows a file of their own"
                )))
            }
            _ => Ok(()),
        }
    }

    fn tell(&self, told: &Told) -> Result<(), End> {
        if self.quiet {
            return Ok(());
        }
        io::stdout().write_all(self.words(told)?.as_bytes()).map_err(standard_output)
    }

    fn words(&self, (summary, hint): &Told) -> Result<String, End> {
        let scene = self.scene.display();
        if self.json {
            summary.to_json(&scene.to_string()).map_err(End::internal)
        } else {
            Ok(format!("{scene}\n{summary}\n{hint}"))
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

/// Summary of a run, and the reason why it diverged if it did.
type Told = (Summary, Hint);

/// Numbers of a row beyond the first axis.
type Further<'a> = &'a mut dyn Iterator<Item = f64>;

fn simulate(
    scene: &Scene,
    bar: &ProgressBar,
    write: impl FnMut(&Row, Further<'_>) -> Result<(), End>,
) -> Result<Told, End> {
    in_space!(scene, Axes => drain(scene, bar, Rollout::<Axes>::of(scene), write))
}

fn drain<V: Space>(
    scene: &Scene,
    bar: &ProgressBar,
    rollout: Result<Rollout<V>, ParameterError>,
    mut write: impl FnMut(&Row, Further<'_>) -> Result<(), End>,
) -> Result<Told, End> {
    let (mut summary, mut hint) = (Summary::new(scene), Hint::new(scene));
    for tick in rollout.map_err(End::input)? {
        if summary.rows.is_multiple_of(BREATH) {
            End::if_interrupted()?;
            bar.set_position(summary.rows);
        }
        write(&Row::of(&tick), &mut further_numbers(&tick))?;
        summary.add(&tick);
        hint.add(&tick);
    }
    bar.finish_and_clear();
    Ok((summary, hint))
}
