//! `lyapunov schema`.

use std::io::{self, Write};

use clap::Args;
use lyapunov_lab::scene;

use super::{End, standard_output};

/// Print the JSON Schema of scene files, by which editors complete and check keys.
///
/// Editors that know Taplo's directive take it from a scene's first line: `#:schema ./scene.schema.json` with
/// `lyapunov schema > scene.schema.json` beside the scene. It holds every key, its type and its range; rules between
/// values are checked by `lyapunov run`.
///
/// Exit status: 0 done, 1 internal error, 2 bad input.
#[derive(Args, Debug)]
pub(crate) struct Schema {}

impl Schema {
    pub(crate) fn run(&self) -> Result<(), End> {
        io::stdout().write_all(scene::schema_text().as_bytes()).map_err(standard_output)
    }
}
