//! The command `lyapunov explain`.

use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::explain::Explanation;
use lyapunov_lab::in_space;
use lyapunov_lab::scene::Scene;

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{End, named, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "explain.json";

/// Say why the run of a scene settles, swings or grows, and what helps.
///
/// The energies of the first contact and of the whole run by cause, the limits that are broken, and changes of the scene
/// that were run and do not grow. docs/explain.md defines all, docs/verdicts.md the verdict.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Explain {
    /// The scene file, TOML.
    scene: PathBuf,
    /// Write report.html, explain.json and the energies by cause (SVG, PNG and CSV) into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Say it as JSON.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Explain {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let inputs = Inputs::scene(&self.scene, &scene);
        let files = names(RESULTS, ["explain"], ["explain.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let watch = |_| End::go_on();
        let explanation = in_space!(scene, Axes => Explanation::watched::<Axes>(&scene, &watch));
        let name = named(&self.scene);
        let explanation =
            explanation.map_err(|error| End::input(format_args!("{name}: {error}")))?;
        let explanation = explanation.ok_or(End::Interrupted)?;
        let json = explanation.to_json(&name);
        if let Some(folder) = folder {
            let results = Results::new(explanation.to_html(&name, &command_line()), RESULTS, &json);
            let results = results.with_figure("explain", &explanation.figure(&name))?;
            folder.fill(results.with_file("explain.csv", explanation.csv()))?;
        }
        tell(self.json, self.quiet, json, format_args!("{name}\n{explanation}"))
    }
}
