//! Folder for results.

use std::cell::Cell;
use std::fs;
use std::io;
use std::path::Path;

use lyapunov_lab::OutputError;

use super::End;
use super::results::Results;
use crate::output::{Output, Outputs};

/// Folder for results. A folder that had to be made is removed again unless it is [kept](Folder::keep).
pub(crate) struct Folder<'a> {
    path: &'a Path,
    is_new: Cell<bool>,
}

impl<'a> Folder<'a> {
    /// Makes the folder and checks, before the work starts, that a file called `name` can be written into it.
    pub(crate) fn claim(path: &'a Path, name: &str) -> Result<Self, End> {
        let is_new = Cell::new(!path.exists());
        fs::create_dir_all(path).map_err(|error| {
            let error = match path.exists() && !path.is_dir() {
                true => io::ErrorKind::NotADirectory.into(),
                false => error,
            };
            End::input(OutputError::new(path, error))
        })?;
        let folder = Self { path, is_new };
        Output::create(&path.join(name)).map_err(End::input)?;
        Ok(folder)
    }

    pub(crate) fn path(&self) -> &'a Path {
        self.path
    }

    /// Writes all results before the first appears under its name, and lets the folder stay.
    pub(crate) fn fill(&self, results: Results) -> Result<(), End> {
        let mut outputs = Outputs::of(self.path);
        outputs.put_all(results.files).map_err(End::input)?;
        results.streamed.map_or(Ok(()), |rows| outputs.add(rows)).map_err(End::input)?;
        End::if_interrupted()?;
        self.keep();
        outputs.keep().map_err(End::input)
    }

    /// Lets the folder stay.
    pub(crate) fn keep(&self) {
        self.is_new.set(false);
    }
}

impl Drop for Folder<'_> {
    fn drop(&mut self) {
        if self.is_new.get() {
            let _ = fs::remove_dir(self.path);
        }
    }
}
