//! Error of a file that could not be written, with the remedy.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Reason why a file could not be written.
#[derive(Debug)]
pub struct OutputError {
    path: PathBuf,
    source: io::Error,
}

impl OutputError {
    /// The error of writing to `path`.
    pub fn new(path: &Path, source: io::Error) -> Self {
        Self { path: path.to_owned(), source }
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        let (problem, remedy) = match self.source.kind() {
            io::ErrorKind::NotFound => {
                ("its folder is not there", "create the folder first, or name one that exists")
            }
            io::ErrorKind::IsADirectory => {
                ("this is a folder", "give the name of a file, not of a folder")
            }
            io::ErrorKind::NotADirectory => {
                ("part of the path is a file", "name a folder there, or another path")
            }
            io::ErrorKind::PermissionDenied => {
                ("it may not be written", "choose a place that you may write to")
            }
            io::ErrorKind::ReadOnlyFilesystem => {
                ("its place is read-only", "choose a place that you may write to")
            }
            io::ErrorKind::StorageFull => {
                ("no space is left there", "free some space there, or choose another place")
            }
            io::ErrorKind::FileTooLarge => (
                "it grew beyond the limit of a file",
                "raise that limit (ulimit -f), or write less",
            ),
            _ => {
                let remedy = "choose another name or another place";
                return write!(f, "{path} cannot be written: {}\n  = {remedy}", self.source);
            }
        };
        write!(f, "{path} cannot be written: {problem}\n  = {remedy}")
    }
}

impl std::error::Error for OutputError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.source)
    }
}
