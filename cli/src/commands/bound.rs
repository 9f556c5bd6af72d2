//! The command `lyapunov bound`.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::bound::Limits;
use lyapunov_lab::scene::Scene;

use super::{End, heed_interrupts, standard_output};

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
    /// Say it as JSON.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Say nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Bound {
    pub(crate) fn run(&self) -> Result<(), End> {
        heed_interrupts(false);
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let limits = Limits::of(&scene);
        let name = self.scene.display();
        let text = match (self.json, self.quiet) {
            (true, _) => limits.to_json(&name.to_string()).map_err(End::internal)?,
            (_, true) => return Ok(()),
            _ => format!("{name}\n{limits}"),
        };
        io::stdout().lock().write_all(text.as_bytes()).map_err(standard_output)
    }
}
