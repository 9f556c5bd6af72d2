//! The command `lyapunov schema`.

use clap::{Args, ValueEnum};
use lyapunov_lab::{models, scene, teleoperation};

use super::{End, print};

/// Print the JSON Schema of scene files, or of another kind of file, by which editors complete and check keys.
///
/// Editors that know Taplo's directive take it from a scene's first line: `#:schema ./scene.schema.json` with
/// `lyapunov schema > scene.schema.json` beside the scene. It holds every key, its type and its range; rules between
/// values are checked when a file is read.
///
/// Exit status: 0 done, 1 internal error, 2 bad input.
#[derive(Args, Debug)]
pub(crate) struct Schema {
    /// The kind of file.
    #[arg(value_enum, default_value = "scene", value_name = "KIND")]
    kind: Kind,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    /// Scenes.
    Scene,
    /// Models of control-affine plants, for `lyapunov compare`.
    Model,
    /// A master and a slave over a channel, for `lyapunov compare`.
    Teleoperation,
}

impl Schema {
    pub(crate) fn run(&self) -> Result<(), End> {
        let text = match self.kind {
            Kind::Scene => scene::schema_text(),
            Kind::Model => models::schema_text(),
            Kind::Teleoperation => teleoperation::schema_text(),
        };
        print(text)
    }
}
