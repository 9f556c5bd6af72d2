//! The command `lyapunov explain`.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::explain::Explanation;
use lyapunov_lab::scene::{Scalar, Scene};

use super::{End, heed_interrupts, standard_output};

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
    /// Say it as JSON.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Say nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Explain {
    pub(crate) fn run(&self) -> Result<(), End> {
        heed_interrupts(false);
        let scene = Scene::load(&self.scene).map_err(End::input)?;
        let explanation = match scene.scalar {
            Scalar::F64 => Explanation::of::<f64>(&scene),
            Scalar::F32 => Explanation::of::<f32>(&scene),
        };
        let name = self.scene.display();
        let explanation =
            explanation.map_err(|error| End::input(format_args!("{name}: {error}")))?;
        let text = match (self.json, self.quiet) {
            (true, _) => explanation.to_json(&name.to_string()).map_err(End::internal)?,
            (_, true) => return Ok(()),
            _ => format!("{name}\n{explanation}"),
        };
        io::stdout().lock().write_all(text.as_bytes()).map_err(standard_output)
    }
}
