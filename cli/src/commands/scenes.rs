//! The command `lyapunov scenes`.

use clap::Args;
use lyapunov_lab::scenes::{self, ShippedScene};

use super::{End, print};

/// List the scenes that ship with the command, or print one to save and change.
///
/// A scene that is saved finds what its first line names with `lyapunov schema > scene.schema.json` beside it.
///
/// Exit status: 0 done, 1 internal error, 2 bad input.
#[derive(Args, Debug)]
pub(crate) struct Scenes {
    /// The scene to print, as in `lyapunov scenes tour > tour.toml`; without one they are listed.
    name: Option<String>,
    /// List them as JSON: name, and the comment line by line.
    #[arg(long, conflicts_with_all = ["quiet", "name"])]
    json: bool,
    /// List the names only.
    #[arg(long, conflicts_with = "name")]
    quiet: bool,
}

impl Scenes {
    pub(crate) fn run(&self) -> Result<(), End> {
        let text = match &self.name {
            Some(name) => scenes::text_of(name).map_err(End::input)?.to_owned(),
            None if self.json => scenes::json(),
            None if self.quiet => listed(|scene| scene.name.to_owned()),
            None => listed(|scene| {
                let [what, look] = scene.comment();
                format!("{}\n  {what}\n  {look}", scene.name)
            }),
        };
        print(text)
    }
}

fn listed(line: impl Fn(&ShippedScene) -> String) -> String {
    scenes::SCENES.iter().map(|scene| line(scene) + "\n").collect()
}
