//! `lyapunov run`.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use lyapunov::ParameterError;
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{
    Csv, Output, OutputError, Rollout, Row, Space, Summary, further_columns, in_space,
};

use super::{End, heed_interrupts, say, standard_output};

/// Ticks between two looks at the clock and at interrupts.
const BREATH: u64 = 1 << 16;

/// Simulate a scene and say what it came to.
#[derive(Args, Debug)]
pub(crate) struct Run {
    /// The scene file, TOML.
    scene: PathBuf,
    /// Write one row per servo tick to this file; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

impl Run {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let further = further_columns(&scene);
        match &self.csv {
            Some(path) if path == Path::new("-") => {
                heed_interrupts(false);
                // Standard output by itself hands on every line alone.
                let output = BufWriter::new(io::stdout().lock());
                let mut csv = Csv::new(output, &further).map_err(standard_output)?;
                let summary = simulate(&scene, |row, further| {
                    csv.write(row, further).map_err(standard_output)
                })?;
                csv.into_inner().flush().map_err(standard_output)?;
                say(format_args!("{}\n{summary}", self.scene.display()));
            }
            Some(path) => {
                self.spare_scene(path)?;
                heed_interrupts(!Output::is_direct(path));
                let output = Output::create(path).map_err(End::input)?;
                let refused = |error| End::input(OutputError::new(path, error));
                let mut csv = Csv::new(output, &further).map_err(refused)?;
                let summary =
                    simulate(&scene, |row, further| csv.write(row, further).map_err(refused))?;
                csv.into_inner().keep().map_err(End::input)?;
                self.tell(&summary)?;
            }
            None => {
                heed_interrupts(false);
                self.tell(&simulate(&scene, |_, _| Ok(()))?)?;
            }
        }
        Ok(())
    }

    /// Refuses to put the rows where the scene is.
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

    fn tell(&self, summary: &Summary) -> Result<(), End> {
        writeln!(io::stdout(), "{}\n{summary}", self.scene.display()).map_err(standard_output)
    }
}

fn simulate(
    scene: &Scene,
    write: impl FnMut(&Row, &[f64]) -> Result<(), End>,
) -> Result<Summary, End> {
    in_space!(scene, Axes => drain(scene, Rollout::<Axes>::of(scene), write))
}

fn drain<V: Space>(
    scene: &Scene,
    rollout: Result<Rollout<V>, ParameterError>,
    mut write: impl FnMut(&Row, &[f64]) -> Result<(), End>,
) -> Result<Summary, End> {
    let bar = progress(scene.ticks());
    let mut summary = Summary::new(scene);
    let mut rollout = rollout.map_err(End::input)?;
    while let Some(row) = rollout.next() {
        if summary.rows.is_multiple_of(BREATH) {
            End::if_interrupted()?;
            bar.set_position(summary.rows);
        }
        write(&row, rollout.further())?;
        summary.add(&row, rollout.further());
    }
    bar.finish_and_clear();
    Ok(summary)
}

/// A bar for runs that take long enough to look at it; hidden where nobody looks.
fn progress(ticks: u64) -> ProgressBar {
    if ticks < 50 * BREATH {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} %, {eta} left");
    ProgressBar::new(ticks).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
