//! The command `lyapunov paper`.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::paper::claims::{Claim, Verdict};
use lyapunov_lab::paper::{Case, PaperError, Stage, Study, figures};
use lyapunov_lab::{Csv, OutputError, Rollout, Scene};

use super::folder::Folder;
use super::{End, heed_interrupts, shown, standard_output};
use crate::output::Outputs;
use crate::pictures::pictures;

/// Time between two checks for interrupts.
const BREATH: Duration = Duration::from_millis(50);

/// Judge the paper's claims and draw its figures 6 to 9: a report, verdicts, figures and rows.
///
/// Prints a verdict for each claim over 101 starts and writes report.html, claims.json, the figures (SVG and PNG)
/// and the rows of the six scenes (CSV). The report states the definitions; docs/paper.md says what they rest on.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Paper {
    /// The folder for the files; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "paper")]
    out: PathBuf,
    /// Print claims.json instead of the table.
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
        heed_interrupts(true);
        let folder = Folder::claim(&self.out, "claims.json")?;
        let bar = self.progress();
        let study = studied(bar.clone())?;
        bar.inc(1);
        bar.set_message(Stage::Files.words());
        folder.keep();
        let command = format!("lyapunov paper --out {}", self.out.display());
        fill(folder.path(), &study, &command)?;
        bar.finish_and_clear();
        if self.quiet {
            return Ok(());
        }
        let text = if self.json { study.to_json()? } else { self.table(&study) };
        io::stdout().write_all(text.as_bytes()).map_err(standard_output)
    }

    fn progress(&self) -> ProgressBar {
        if self.quiet {
            return ProgressBar::hidden();
        }
        shown(ProgressBar::new(Stage::ALL.len() as u64), "{bar:20} {pos} of {len}: {msg}")
    }

    fn table(&self, study: &Study) -> String {
        let mut text = String::from("The paper's section IV over 101 starts, 30 s each\n\n");
        for claim in &study.claims {
            text += &row(claim);
        }
        text + &format!(
            "\nreport, figures and the rows behind them are in {}\n",
            self.out.display()
        )
    }
}

/// Runs the study on a thread of its own, so that an interrupt need not wait for a stage to end.
fn studied(bar: ProgressBar) -> Result<Study, End> {
    let (sender, studies) = sync_channel(1);
    thread::spawn(move || {
        let study = Study::run(|stage| -> Result<(), PaperError> {
            bar.inc(1);
            bar.set_message(stage.words());
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
    fs::create_dir_all(folder).map_err(refused)?;
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

fn row(claim: &Claim) -> String {
    let verdict = match claim.verdict {
        Verdict::Reproduced => "reproduced",
        Verdict::NotReproduced => "not reproduced",
        Verdict::Undecided => "undecided",
    };
    let measured = claim.measured();
    format!("  {verdict:15} {:3} of {:3}  {measured:>12}   {}\n", claim.held, claim.of, claim.paper)
}
