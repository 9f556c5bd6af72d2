//! The command `lyapunov hard`.

mod soak;

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::family::{BasicName, StabilizerName};
use lyapunov_lab::hard::{Catalogue, HardError};

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{BAR, End, advance, shown, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "hard.json";

/// Run the catalogue of hard cases: what a naive implementation does there, and what this one does.
///
/// With a scene, or with `--minutes`, the promises that hold in every loop are held on that scene, or on random ones.
///
/// Prints for each case what makes it hard, the bound that is promised, what was measured with our stabilizer (the worst
/// over f64, f32 and lanes) and with the paper's steps as printed, and pass or FAIL. docs/hard.md says what passing
/// takes.
///
/// Exit status: 0 every case passed or every promise is kept, 1 one failed or is not, or an internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Hard {
    /// Hold every promise on this scene, TOML, also after any fault of any tick, instead of running the catalogue.
    #[arg(conflicts_with_all = ["minutes", "out", "json"])]
    scene: Option<PathBuf>,
    /// Hold every promise on random scenes for so many minutes, or until one is broken, instead of running the
    /// catalogue.
    ///
    /// The first scene that breaks one is made as small as it can be and written as soak.toml into the folder of `--out`
    /// or else this one.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = soak::minutes)]
    minutes: Option<Duration>,
    /// The seed of random scenes: case k of a seed is always the same.
    #[arg(long, value_name = "N", default_value_t = 1, requires = "minutes")]
    seed: u64,
    /// Run the cases with this stabilizer instead of ours, by its name in docs/family.md, in f64 and f32; a scene
    /// and random scenes with this one only.
    ///
    /// A bound that it does not promise may be passed: the case is then reported as over, and is no failure.
    #[arg(long, value_name = "NAME")]
    stabilizer: Option<StabilizerName>,
    /// Write report.html, hard.json and hard.csv into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print hard.json, or what random scenes came to as JSON, instead of the table.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Hard {
    pub(crate) fn run(&self) -> Result<(), End> {
        if self.stabilizer == Some(StabilizerName::Basic(BasicName::NoStabilizer)) {
            return Err(End::input(
                "`none` is no stabilizer to be tried\n  = --out writes a page that tells of every loop without one",
            ));
        }
        match (&self.scene, self.minutes) {
            (Some(scene), _) => self.hold(scene),
            (None, Some(span)) => self.soak(span),
            (None, None) => self.catalogue(),
        }
    }

    fn catalogue(&self) -> Result<(), End> {
        let files = names(RESULTS, [""; 0], ["hard.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &Inputs::default())?;
        let bar = shown(ProgressBar::new(Catalogue::cases().len() as u64), BAR, self.quiet);
        let watch = || advance(&bar, 1);
        let catalogue = Catalogue::of(self.stabilizer, &watch).map_err(|error| match error {
            HardError::Stopped => End::Interrupted,
            error => End::internal(error),
        })?;
        bar.finish_and_clear();
        let text = catalogue.to_json();
        if let Some(folder) = folder {
            let page = catalogue.report(&command_line());
            let results = Results::new(page, RESULTS, &text);
            folder.fill(results.with_file("hard.csv", catalogue.csv()))?;
        }
        tell(self.json, self.quiet, text, &catalogue)?;
        let failed = catalogue.rows.iter().filter(|row| !row.passed).count();
        if failed == 0 { Ok(()) } else { Err(End::Failed(format!("{failed} hard cases failed"))) }
    }
}
