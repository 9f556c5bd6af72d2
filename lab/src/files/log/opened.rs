//! Log as a file.

use std::fs::File;
use std::io::{Error, ErrorKind, Result};
use std::path::Path;

/// The file at `path`; an error has its remedy in a second line.
///
/// # Errors
/// A path without a file that may be read.
pub fn opened(path: &Path) -> Result<File> {
    let file = File::open(path).map_err(remedied)?;
    if file.metadata()?.is_dir() {
        return Err(Error::other("this is a folder\n  = give the path of a file in it"));
    }
    Ok(file)
}

fn remedied(error: Error) -> Error {
    match error.kind() {
        ErrorKind::NotFound => Error::other(
            "there is no such file\n  = check the path; it is taken from the current folder",
        ),
        ErrorKind::PermissionDenied => Error::other(
            "this file may not be read\n  = check its permissions and those of its folder",
        ),
        _ => error,
    }
}
