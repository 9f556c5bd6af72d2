//! The command `lyapunov accuracy`.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::accuracy::{AccuracyError, Study};
use lyapunov_lab::scene::Scene;

use super::folder::Folder;
use super::{BAR, End, heed_interrupts, shown, standard_output};
use crate::output::Outputs;
use crate::pictures::pictures;

/// The file that `--json` prints.
const RESULTS: &str = "accuracy.json";

/// Steps of the progress bar.
const PARTS: f64 = 1000.0;

/// Measure what accuracy costs in time on a scene: every propagator, step and scalar.
///
/// Prints the largest error of the position of each setting and its time per simulated second, the fastest first, and what
/// the precision of a ledger is worth. docs/accuracy.md says how to read it and which setting to take when.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Accuracy {
    /// The scene file, TOML.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Write report.html, accuracy.json and the plot (SVG and PNG) into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Say which setting is the fastest that is off by no more than this, as keys for the scene.
    #[arg(long, value_name = "METRES", value_parser = metres, allow_negative_numbers = true)]
    target: Option<f64>,
    /// Print accuracy.json instead of tables.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

fn metres(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(metres) if metres > 0.0 && metres.is_finite() => Ok(metres),
        _ => {
            Err("give a length in m that is greater than 0 and finite, for example 1e-9".to_owned())
        }
    }
}

impl Accuracy {
    pub(crate) fn run(&self) -> Result<(), End> {
        heed_interrupts(true);
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let folder = self.out.as_deref().map(|path| Folder::claim(path, RESULTS)).transpose()?;
        let study = self.study(&scene)?;
        let text = study.document(self.target).map_err(End::internal)?;
        if let Some(folder) = folder {
            self.fill(&folder, &study, &text)?;
        }
        let mut out = io::stdout().lock();
        if self.json {
            return out.write_all(text.as_bytes()).map_err(standard_output);
        }
        if self.quiet {
            return Ok(());
        }
        write!(out, "{study}").map_err(standard_output)?;
        match self.target {
            None => Ok(()),
            Some(metres) => write!(out, "\n{}", study.advice(metres)).map_err(standard_output),
        }
    }

    fn study(&self, scene: &Scene) -> Result<Study, End> {
        let bar = match self.quiet {
            true => ProgressBar::hidden(),
            false => shown(ProgressBar::new(PARTS as u64), BAR),
        };
        let watch = |share: f64| {
            bar.set_position((share * PARTS) as u64);
            match End::if_interrupted() {
                Ok(()) => ControlFlow::Continue(()),
                Err(_) => ControlFlow::Break(()),
            }
        };
        let name = self.scene.display().to_string();
        let study = Study::watched(&name, scene, &watch).map_err(|error| match error {
            AccuracyError::Stopped => End::Interrupted,
            error => End::input(error),
        })?;
        bar.finish_and_clear();
        Ok(study)
    }

    /// Writes all files before the first appears under its name.
    fn fill(&self, folder: &Folder<'_>, study: &Study, text: &str) -> Result<(), End> {
        let command = format!("lyapunov accuracy {}", self.scene.display());
        let command = match self.target {
            None => command,
            Some(metres) => format!("{command} --target {metres:e}"),
        };
        let drawn = pictures("accuracy", &study.figure()).map_err(End::internal)?;
        let mut outputs = Outputs::of(folder.path());
        outputs
            .put("report.html", study.to_html(&command, self.target))
            .and_then(|()| outputs.put_all(drawn))
            .and_then(|()| outputs.put(RESULTS, text))
            .map_err(End::input)?;
        End::if_interrupted()?;
        folder.keep();
        outputs.keep().map_err(End::input)
    }
}
