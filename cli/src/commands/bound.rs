//! The command `lyapunov bound`.

use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::bound::{self, Limits, RadiusCurve};
use lyapunov_lab::scene::Scene;

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::{End, named, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "bound.json";

/// Say how stiff the environment of a scene may be, by formula.
///
/// The linear part of the scene, contact assumed: passive for any operator (Colgate and Schenkel), Gil's rule, friction
/// and encoder (Abbott and Okamura), and the exact limit up to which the linear loop is stable. What a run does is
/// another question, and `lyapunov run` answers it. docs/bounds.md defines the limits.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Bound {
    /// The scene file, TOML.
    scene: PathBuf,
    /// Write report.html, bound.json and the spectral radius over the stiffness (SVG, PNG and CSV) into this folder; made
    /// if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Say it as JSON.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Bound {
    pub(crate) fn run(&self) -> Result<(), End> {
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let inputs = Inputs::scene(&self.scene, &scene);
        let files = names(RESULTS, ["bound"], ["bound.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let limits = Limits::of(&scene);
        let name = named(&self.scene);
        let json = limits.to_json(&name);
        if let Some(folder) = folder {
            let curve = RadiusCurve::of(&scene, &limits);
            let page = bound::page(&name, &scene, &limits, curve.as_ref(), &command_line());
            let mut results = Results::new(page, RESULTS, &json);
            if let Some(curve) = &curve {
                results = results.with_figure("bound", &curve.figure(&name))?;
                results = results.with_file("bound.csv", curve.csv());
            }
            folder.fill(results)?;
        }
        tell(self.json, self.quiet, json, format_args!("{name}\n{limits}"))
    }
}
