//! The command `lyapunov paper`.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::paper::{Case, Draws, FIGURES, PaperError, Study, figures};
use lyapunov_lab::{Csv, OutputError, Rollout, Scene};

use super::folder::Folder;
use super::results::names;
use super::{BAR, End, print, program, shown};
use crate::files::{Inputs, Outputs};
use crate::pictures::pictures;

/// Time between two checks for interrupts.
const BREATH: Duration = Duration::from_millis(50);

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
        let files = names("claims.json", FIGURES, rows);
        let folder = Folder::claim(&self.out, files, &Inputs::default())?;
        let bar = shown(ProgressBar::new(Study::STAGES as u64), BAR, self.quiet);
        let draws = Draws { count: self.draws, seed: self.seed };
        let study = studied(draws, bar.clone())?;
        bar.finish_and_clear();
        folder.keep();
        let command =
            format!("{} paper{} --out {}", program(), self.ensemble(), self.out.display());
        fill(folder.path(), &study, &command)?;
        if self.quiet {
            return Ok(());
        }
        let files = self.out.display();
        let text = match self.json {
            true => study.to_json()?,
            false => format!("{study}\nreport, figures and the rows behind them are in {files}\n"),
        };
        print(text)
    }

    /// The arguments that choose the ensemble, where they are not the usual ones.
    fn ensemble(&self) -> String {
        let Draws { count, seed } = Draws::default();
        let mut words = String::new();
        if self.draws != count {
            words += &format!(" --draws {}", self.draws);
        }
        if self.seed != seed {
            words += &format!(" --seed {}", self.seed);
        }
        words
    }
}

/// Runs the study on a thread of its own, so that an interrupt need not wait for a stage to end.
fn studied(draws: Draws, bar: ProgressBar) -> Result<Study, End> {
    let (sender, studies) = sync_channel(1);
    thread::spawn(move || {
        let study = Study::run(draws, || -> Result<(), PaperError> {
            bar.inc(1);
            Ok(())
        });
        // After an interrupt the receiver is gone.
        let _ = sender.send(study);
    });
    loop {
        match studies.recv_timeout(BREATH) {
            Ok(study) => return Ok(study?),
            Err(RecvTimeoutError::Timeout) => End::if_interrupted()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(End::internal("the study broke off"));
            }
        }
    }
}

/// Writes report, claims, figures and rows before the first appears under its name.
fn fill(folder: &Path, study: &Study, command: &str) -> Result<(), End> {
    let refused = |error| End::input(OutputError::new(folder, error));
    let figures = figures()?;
    let mut files = vec![
        ("report.html".to_owned(), study.to_html(&figures, command).into_bytes()),
        ("claims.json".to_owned(), study.to_json()?.into_bytes()),
    ];
    for (name, figure, _) in &figures {
        files.extend(pictures(name, figure).map_err(End::internal)?);
    }
    for case in Case::ALL {
        let scene = case.scene().map_err(End::internal)?;
        let rollout = Rollout::of(&scene).map_err(End::internal)?;
        let text = csv(&scene, rollout).map_err(refused)?;
        files.push((format!("{}.csv", case.name()), text));
    }
    let mut outputs = Outputs::of(folder);
    outputs.put_all(files).map_err(End::input)?;
    outputs.keep().map_err(End::input)
}

fn csv(scene: &Scene, rollout: Rollout) -> io::Result<Vec<u8>> {
    let mut csv = Csv::of(Vec::new(), scene)?;
    for tick in rollout {
        csv.write(&tick)?;
    }
    csv.into_inner()
}
