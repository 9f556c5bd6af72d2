//! The command `lyapunov tune`.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::scene::Scene;
use lyapunov_lab::tune::{Objective, TuneError, Tuned, Tuning, csv, document, figure, page, table};

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{BAR, End, advance, named, shown, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "tune.json";

/// Find for each stabilizer the parameters that are best on a scene.
///
/// Each stabilizer gets the same number of runs. A setting is judged by its mean cost over an ensemble: scenes with the
/// clock's phase, masses, dampings and stiffnesses moved. One with which every run stays bounded is always preferred.
/// Default and tuned setting are then judged on members that the search never saw. Prints both, and the scene
/// with the best stabilizer, ready to run. docs/tune.md defines the terms.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Tune {
    /// The scene file, TOML.
    scene: PathBuf,
    /// Who is tuned, by the names of docs/family.md, or all.
    #[arg(long, default_value = "popc,lolc", value_name = "NAMES")]
    stabilizers: StabilizerNames,
    /// What to be best at: settling (s), force-error (N rms), stiffness (% lacking), or a weighted sum such as
    /// settling=1,force-error=0.5.
    #[arg(long, default_value_t = Objective::default(), value_name = "TERMS")]
    objective: Objective,
    /// Settings to try for each stabilizer, besides the one of the scene.
    #[arg(long, default_value_t = Tuning::default().trials, value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=100_000))]
    trials: u32,
    /// Runs of each setting; it is judged on twice as many others.
    #[arg(long, default_value_t = Tuning::default().runs, value_name = "N",
        value_parser = clap::value_parser!(u32).range(2..=100_000))]
    runs: u32,
    /// Seed of the ensemble.
    #[arg(long, default_value_t = Tuning::default().seed, value_name = "N")]
    seed: u64,
    /// Write report.html, tune.json, tune.csv, a plot (SVG and PNG) and a scene for each stabilizer into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print tune.json instead of the table.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Tune {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let inputs = Inputs::scene(&self.scene, &scene);
        let tuned =
            self.stabilizers.on(&scene).iter().map(|one| format!("{one}.toml")).collect::<Vec<_>>();
        let files = names(RESULTS, ["tune"], tuned.iter().map(String::as_str).chain(["tune.csv"]));
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let Self { objective, trials, runs, seed, .. } = *self;
        let tuning = Tuning { objective, trials, runs, seed, ..Tuning::default() };
        let name = named(&self.scene);
        Tuning::check(&self.stabilizers.on(&scene), &scene)
            .map_err(|error| End::input(format_args!("{name}: {error}")))?;
        let tuned = tune(&tuning, &name, &scene, &self.stabilizers, self.quiet)?;
        let text = document(&name, &tuning, &tuned);
        if let Some(folder) = folder {
            let page = page(&name, &tuning, &tuned, &command_line());
            let results = Results::new(page, RESULTS, &text).with_file("tune.csv", csv(&tuned));
            let mut results = results.with_figure("tune", &figure(&name, objective, &tuned))?;
            for one in &tuned {
                let scene = one.text().map_err(End::internal)?;
                results = results.with_file(format!("{}.toml", one.name), scene);
            }
            folder.fill(results)?;
        }
        let mut said = table(&name, &tuning, &tuned);
        if let Some(best) = Tuned::best(&tuned) {
            let scene = best.text().map_err(End::internal)?;
            let _ = write!(said, "\nThe scene with {}, tuned:\n\n{scene}", best.name);
        }
        tell(self.json, self.quiet, text, said)
    }
}

/// Tunes each of `names` on `scene`, which is called `name`, with a progress bar.
pub(super) fn tune(
    tuning: &Tuning,
    name: &str,
    scene: &Scene,
    names: &StabilizerNames,
    quiet: bool,
) -> Result<Vec<Tuned>, End> {
    let names = names.on(scene);
    let runs = names.iter().count() as u64 * tuning.rollouts();
    let bar = shown(ProgressBar::new(runs), BAR, quiet);
    let watch = |runs| advance(&bar, runs);
    let tuned = names.iter().map(|member| {
        tuning.of(scene, *member, &watch).map_err(|error| match error {
            TuneError::Stopped => End::Interrupted,
            error => End::input(format!("{name}: {error}")),
        })
    });
    let tuned = tuned.collect();
    bar.finish_and_clear();
    tuned
}
