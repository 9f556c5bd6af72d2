//! Log as a file.

use std::fs::File;
use std::io::{Error, Result};
use std::path::Path;

use crate::files::unopened::unopened;

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
    match unopened(error.kind()) {
        Some([wrong, remedy]) => Error::other(format!("{wrong}\n  = {remedy}")),
        None => error,
    }
}
