//! Files that a command reads.

use std::fs;
use std::path::{Path, PathBuf};

use lyapunov_lab::Scene;

use crate::commands::End;

/// Files that a command reads, none of which it may overwrite.
#[derive(Debug, Default)]
pub(crate) struct Inputs(Vec<(&'static str, PathBuf)>);

impl Inputs {
    /// The files at `paths`, each of which is called `noun`.
    pub(crate) fn of<'a>(noun: &'static str, paths: impl IntoIterator<Item = &'a PathBuf>) -> Self {
        Self(paths.into_iter().map(|path| (noun, path.clone())).collect())
    }

    /// The file of a scene, and the one that it names.
    pub(crate) fn scene(path: &Path, scene: &Scene) -> Self {
        Self(vec![("the scene", path.to_owned())]).and_named_by(scene)
    }

    /// The same with the file at `path`, which is called `noun`, if there is one.
    pub(crate) fn and(mut self, noun: &'static str, path: Option<&Path>) -> Self {
        self.0.extend(path.map(|path| (noun, path.to_owned())));
        self
    }

    /// The same with the file that `scene` names.
    pub(crate) fn and_named_by(mut self, scene: &Scene) -> Self {
        self.0.extend(scene.named_file().map(|path| ("the motion of the scene", path.to_owned())));
        self
    }

    /// Checks that a result at `output` would replace none of them, whatever the paths, links included.
    ///
    /// # Errors
    /// An output that is one of these files.
    pub(crate) fn spare(&self, output: &Path) -> Result<(), End> {
        match self.0.iter().find(|(_, input)| is_same(input, output)) {
            None => Ok(()),
            Some((noun, _)) => Err(End::input(format_args!(
                "{}: this is {noun} itself, which the results would replace\n  \
                 = give the results a file or a folder of their own",
                output.display()
            ))),
        }
    }
}

#[cfg(unix)]
fn is_same(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (fs::metadata(one), fs::metadata(other)) {
        (Ok(one), Ok(other)) => {
            one.is_file() && (one.dev(), one.ino()) == (other.dev(), other.ino())
        }
        _ => false,
    }
}

#[cfg(not(unix))]
fn is_same(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other && one.is_file(),
        _ => false,
    }
}
