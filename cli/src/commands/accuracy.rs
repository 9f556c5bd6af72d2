//! The command `lyapunov accuracy`.

use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::accuracy::{AccuracyError, Study};
use lyapunov_lab::scene::Scene;

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{BAR, End, named, shown, tell};
use crate::files::Inputs;

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
    /// Write report.html, accuracy.json, accuracy.csv and the plot (SVG and PNG) into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Say which setting is the fastest that is off by no more than this, as keys for the scene.
    #[arg(long, value_name = "METRES", allow_hyphen_values = true)]
    target: Option<String>,
    /// Print accuracy.json instead of tables.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Accuracy {
    pub(crate) fn run(&self) -> Result<(), End> {
        let target = self.target()?;
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let inputs = Inputs::scene(&self.scene, &scene);
        let files = names(RESULTS, ["accuracy"], ["accuracy.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let study = self.study(&scene)?;
        let text = study.to_json(target);
        if let Some(folder) = folder {
            self.fill(&folder, &study, target, &text)?;
        }
        let advice = target.map(|metres| format!("\n{}", study.advice(metres)));
        tell(self.json, self.quiet, text, format_args!("{study}{}", advice.unwrap_or_default()))
    }

    /// The error that a setting is asked for, m.
    fn target(&self) -> Result<Option<f64>, End> {
        let Some(text) = &self.target else { return Ok(None) };
        match text.parse::<f64>() {
            Ok(metres) if metres > 0.0 && metres.is_finite() => Ok(Some(metres)),
            _ => Err(End::input(format!(
                "--target {text}: an error is a length in m that is greater than 0 and finite\n  \
                 = give one, for example --target 1e-9"
            ))),
        }
    }

    fn study(&self, scene: &Scene) -> Result<Study, End> {
        let bar = shown(ProgressBar::new(PARTS as u64), BAR, self.quiet);
        let watch = |share: f64| {
            bar.set_position((share * PARTS) as u64);
            End::go_on()
        };
        let name = named(&self.scene);
        let study = Study::watched(&name, scene, &watch).map_err(|error| match error {
            AccuracyError::Stopped => End::Interrupted,
            error @ AccuracyError::Space { .. } => End::input(error),
            error => End::input(format!("{name}: {error}")),
        })?;
        bar.finish_and_clear();
        Ok(study)
    }

    fn fill(
        &self,
        folder: &Folder<'_>,
        study: &Study,
        target: Option<f64>,
        text: &str,
    ) -> Result<(), End> {
        let page = study.to_html(&command_line(), target);
        let results = Results::new(page, RESULTS, text).with_file("accuracy.csv", study.csv());
        folder.fill(results.with_figure("accuracy", &study.figure())?)
    }
}
