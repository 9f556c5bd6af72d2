//! The command `lyapunov paper`.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::paper::{Case, Draws, FIGURES, PaperError, Study, figures};
use lyapunov_lab::{Csv, OutputError, Rollout, Scene, shell_word};

use super::apart::apart;
use super::folder::Folder;
use super::results::{Results, names};
use super::{BAR, End, print, program, shown};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "claims.json";

/// Judge the paper's claims and draw its figures 6 to 9: a report, verdicts, figures and rows.
///
/// Prints a verdict for each claim over 1000 draws of what the paper does not state, for the controller as printed and
/// for ours, and writes report.html, claims.json, the figures (SVG and PNG) and the rows of the six scenes (CSV). The
/// report states the definitions; docs/paper.md says what they rest on.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Paper {
    /// The folder for the files; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "paper")]
    out: PathBuf,
    /// The number of draws, from 1 to 100000.
    #[arg(long, value_name = "N", default_value_t = Draws::default().count, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    draws: u64,
    /// The seed of the draws.
    #[arg(long, value_name = "SEED", default_value_t = Draws::default().seed)]
    seed: u64,
    /// Print claims.json instead of the tables.
    #[arg(long)]
    json: bool,
    /// Print nothing but errors.
    #[arg(long, conflicts_with = "json")]
    quiet: bool,
}

impl From<PaperError> for End {
    fn from(error: PaperError) -> Self {
        Self::internal(error)
    }
}

impl Paper {
    pub(crate) fn run(&self) -> Result<(), End> {
        let rows = Case::ALL.map(|case| format!("{}.csv", case.name()));
        let files = names(RESULTS, FIGURES, rows);
        let folder = Folder::claim(&self.out, files, &Inputs::default())?;
        let bar = shown(ProgressBar::new(Study::STAGES as u64), BAR, self.quiet);
        let draws = Draws { count: self.draws, seed: self.seed };
        let stages = bar.clone();
        let study = apart(move || Study::run(draws, || stages.inc(1)))??;
        bar.finish_and_clear();
        folder.fill(results(&study, folder.path(), &self.command())?)?;
        if self.quiet {
            return Ok(());
        }
        let files = self.out.display();
        let text = match self.json {
            true => study.to_json(),
            false => format!("{study}\nreport, figures and the rows behind them are in {files}\n"),
        };
        print(text)
    }

    /// The command that makes the same files, whatever it prints.
    fn command(&self) -> String {
        let Draws { count, seed } = Draws::default();
        let mut command = format!("{} paper", program());
        if self.draws != count {
            command += &format!(" --draws {}", self.draws);
        }
        if self.seed != seed {
            command += &format!(" --seed {}", self.seed);
        }
        format!("{command} --out {}", shell_word(&self.out.to_string_lossy()))
    }
}

/// Report, claims, figures and rows, for `folder`.
fn results(study: &Study, folder: &Path, command: &str) -> Result<Results, End> {
    let refused = |error| End::input(OutputError::new(folder, error));
    let figures = figures()?;
    let page = study.to_html(&figures, command);
    let mut results = Results::new(page, RESULTS, &study.to_json());
    for (name, figure, _) in &figures {
        results = results.with_figure(name, figure)?;
    }
    for case in Case::ALL {
        let scene = case.scene().map_err(End::internal)?;
        let rollout = Rollout::of(&scene).map_err(End::internal)?;
        let rows = csv(&scene, rollout).map_err(refused)?;
        results = results.with_file(format!("{}.csv", case.name()), rows);
    }
    Ok(results)
}

fn csv(scene: &Scene, rollout: Rollout) -> io::Result<Vec<u8>> {
    let mut csv = Csv::of(Vec::new(), scene)?;
    for tick in rollout {
        csv.write(&tick)?;
    }
    csv.into_inner()
}
