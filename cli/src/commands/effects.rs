//! The command `lyapunov effects`.

use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::effects::{Costs, CostsError};
use lyapunov_lab::scene::Scene;

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{BAR, End, advance, named, shown, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "effects.json";

/// Measure what each effect costs per step, on this machine.
///
/// Prints the nanoseconds that a step takes longer with an effect than without, alone and with all other effects, for one
/// rollout (f64) and for eight at once (f64x8). Environments and axes replace the wall, so their cost is the
/// difference to it. With a scene: the same for the effects that it names, in its own loop. docs/effects/costs.md says how
/// to read the table.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Effects {
    /// The scene file, TOML, whose effects are measured; by default all effects, on a hand that runs into a wall.
    scene: Option<PathBuf>,
    /// Write report.html, effects.json, effects.csv and a plot (SVG and PNG) into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON instead of tables.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Effects {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = self.scene.as_deref().map(Scene::load).transpose().map_err(End::input)?;
        let inputs = match (&self.scene, &scene) {
            (Some(path), Some(scene)) => Inputs::scene(path, scene),
            _ => Inputs::default(),
        };
        let files = names(RESULTS, ["effects"], ["effects.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let loops = scene.as_ref().map_or_else(Costs::loops, Costs::loops_of);
        let loops = loops.map_err(|error| self.blame(error))?;
        let bar = shown(ProgressBar::new(loops as u64), BAR, self.quiet);
        let watch = || advance(&bar, 1);
        let costs = match (&self.scene, &scene) {
            (Some(path), Some(scene)) => Costs::of(&named(path), scene, &watch),
            _ => Costs::measured(&watch),
        };
        let costs = costs.map_err(|error| self.blame(error))?;
        bar.finish_and_clear();
        let json = costs.to_json();
        if let Some(folder) = folder {
            let results = Results::new(costs.to_html(&command_line()), RESULTS, &json);
            let results = results.with_figure("effects", &costs.figure())?;
            folder.fill(results.with_file("effects.csv", costs.csv()))?;
        }
        tell(self.json, self.quiet, json, costs)
    }

    /// End for an error: of a scene that was given, bad input.
    fn blame(&self, error: CostsError) -> End {
        match (error, &self.scene) {
            (CostsError::Stopped, _) => End::Interrupted,
            (error, Some(path)) => End::input(format!("{}: {error}", named(path))),
            (error, None) => End::internal(error),
        }
    }
}
