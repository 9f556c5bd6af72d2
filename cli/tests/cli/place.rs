//! Folder to run the command in, and its contents.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

use crate::cli::said::Said;

/// The shipped scene that most tests start from.
pub(crate) const SCENE: &str = include_str!("../../../scenes/paper-8k-lolc.toml");

/// Bytes of a file that are compared; a sparse file may be larger than memory.
const MOST: u64 = 1 << 20;

/// Content at a path.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Content {
    Folder,
    Link(PathBuf),
    File { length: u64, start: Vec<u8> },
    Other,
}

/// Folder of one test, in which the command runs.
#[derive(Debug)]
pub(crate) struct Place(TempDir);

impl Place {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// A place with [`SCENE`] as `scene.toml`.
    pub(crate) fn with_scene() -> Self {
        let place = Self::new();
        place.put("scene.toml", SCENE);
        place
    }

    /// A place with a scene of hours of work: as many ticks as a run may have.
    pub(crate) fn long() -> Self {
        let place = Self::new();
        place.put_scene("scene.toml", "duration = 10.0", "duration = 1e7");
        place
    }

    pub(crate) fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn put(&self, name: impl AsRef<Path>, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    /// [`SCENE`] with one part replaced.
    pub(crate) fn put_scene(&self, name: &str, from: &str, to: &str) {
        assert!(SCENE.contains(from), "{from}");
        self.put(name, SCENE.replacen(from, to, 1));
    }

    pub(crate) fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub(crate) fn command<A: AsRef<OsStr>>(
        &self,
        arguments: impl IntoIterator<Item = A>,
    ) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
        command.args(arguments).current_dir(self.0.path());
        command
    }

    pub(crate) fn run<A: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = A>) -> Said {
        Said::by(&mut self.command(arguments))
    }

    /// Runs a command that must fail: it ends with status 2, prints `words` and changes nothing.
    #[track_caller]
    pub(crate) fn refuses<A: AsRef<OsStr>>(
        &self,
        arguments: impl IntoIterator<Item = A>,
        words: &[&str],
    ) -> Said {
        let before = self.contents();
        let said = self.run(arguments);
        said.ended(2, words);
        assert!(said.err.starts_with("error: "), "{said:?}");
        assert_eq!(said.out, "");
        assert_eq!(self.contents(), before);
        said
    }

    /// Everything in the folder and its subfolders.
    pub(crate) fn contents(&self) -> BTreeMap<PathBuf, Content> {
        let mut contents = BTreeMap::new();
        let mut folders = vec![self.0.path().to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                let content = content(&path);
                if content == Content::Folder {
                    folders.push(path.clone());
                }
                contents.insert(path, content);
            }
        }
        contents
    }

    /// Names of the direct entries of `folder`, in order.
    pub(crate) fn names(&self, folder: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(folder)).unwrap();
        let name = |entry: std::io::Result<fs::DirEntry>| {
            entry.unwrap().file_name().to_string_lossy().into_owned()
        };
        let mut names: Vec<String> = entries.map(name).collect();
        names.sort();
        names
    }
}

fn content(path: &Path) -> Content {
    let found = fs::symlink_metadata(path).unwrap();
    if found.is_dir() {
        Content::Folder
    } else if found.is_symlink() {
        Content::Link(fs::read_link(path).unwrap())
    } else if found.is_file() {
        let mut start = Vec::new();
        File::open(path).unwrap().take(MOST).read_to_end(&mut start).unwrap();
        Content::File { length: found.len(), start }
    } else {
        Content::Other
    }
}
