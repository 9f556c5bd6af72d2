//! Folder for results.

use std::cell::RefCell;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use lyapunov_lab::OutputError;

use super::End;
use super::results::Results;
use crate::output::{Output, Outputs};

/// Folder for results. It and the folders above it that had to be made are removed again unless it is [kept](Folder::keep).
pub(crate) struct Folder<'a> {
    path: &'a Path,
    /// The folders that were made, the innermost first.
    made: RefCell<Vec<PathBuf>>,
}

impl<'a> Folder<'a> {
    /// Makes the folder and checks, before the work starts, that a file called `name` can be written into it.
    pub(crate) fn claim(path: &'a Path, name: &str) -> Result<Self, End> {
        let missing = |folder: &&Path| !folder.as_os_str().is_empty() && !folder.exists();
        let made = path.ancestors().take_while(missing).map(Path::to_owned).collect();
        let folder = Self { path, made: RefCell::new(made) };
        fs::create_dir_all(path).map_err(|error| {
            let error = match path.exists() && !path.is_dir() {
                true => io::ErrorKind::NotADirectory.into(),
                false => error,
            };
            End::input(OutputError::new(path, error))
        })?;
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
        self.made.borrow_mut().clear();
    }
}

impl Drop for Folder<'_> {
    fn drop(&mut self) {
        for folder in self.made.borrow().iter() {
            let _ = fs::remove_dir(folder);
        }
    }
}
