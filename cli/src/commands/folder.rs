//! Folder for results.

use std::cell::RefCell;
use std::fs::{self, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use lyapunov_lab::OutputError;

use super::End;
use super::results::Results;
use crate::files::{FolderLock, Inputs, Output, Outputs, sweep_locked};
use crate::interrupts::Untidy;

/// Folder for results, which no other process writes to meanwhile. It and the folders above it that had to be made are
/// removed again unless it is [kept](Folder::keep).
pub(crate) struct Folder<'a> {
    path: &'a Path,
    /// The names of the files that may be written.
    names: Vec<String>,
    /// The folders that were made, the innermost first.
    made: RefCell<Vec<PathBuf>>,
    untidy: RefCell<Option<Untidy>>,
    _lock: Option<FolderLock>,
}

impl<'a> Folder<'a> {
    /// Makes the folder and checks, before the work starts, that the files called `names` can be written into it and are
    /// none of `inputs`.
    pub(crate) fn claim(
        path: &'a Path,
        names: impl IntoIterator<Item = impl Into<String>>,
        inputs: &Inputs,
    ) -> Result<Self, End> {
        let lock = |path: &Path| {
            let lock = FolderLock::alone(path)?;
            sweep_locked(path, &lock);
            Some(lock)
        };
        Self::locked(path, names, inputs, lock)
    }

    /// The same where a folder is asked for.
    pub(crate) fn asked(
        path: Option<&'a Path>,
        names: impl IntoIterator<Item = impl Into<String>>,
        inputs: &Inputs,
    ) -> Result<Option<Self>, End> {
        path.map(|path| Self::claim(path, names, inputs)).transpose()
    }

    /// The same for a process that shares the folder with others, which write files of other names.
    pub(crate) fn share(
        path: &'a Path,
        names: impl IntoIterator<Item = impl Into<String>>,
        inputs: &Inputs,
    ) -> Result<Self, End> {
        let lock = |path: &Path| {
            // Only while nobody else is there.
            if let Some(alone) = FolderLock::alone(path) {
                sweep_locked(path, &alone);
            }
            FolderLock::shared(path)
        };
        Self::locked(path, names, inputs, lock)
    }

    fn locked(
        path: &'a Path,
        names: impl IntoIterator<Item = impl Into<String>>,
        inputs: &Inputs,
        lock: impl Fn(&Path) -> Option<FolderLock>,
    ) -> Result<Self, End> {
        let missing = |folder: &&Path| !folder.as_os_str().is_empty() && !folder.exists();
        let made = RefCell::new(path.ancestors().take_while(missing).map(Path::to_owned).collect());
        let (names, untidy) = (names.into_iter().map(Into::into).collect(), Untidy::new().into());
        let mut folder = Self { path, names, made, untidy: RefCell::new(untidy), _lock: None };
        fs::create_dir_all(path).map_err(|error| {
            let error = match path.exists() && !path.is_dir() {
                true => io::ErrorKind::NotADirectory.into(),
                false => error,
            };
            End::input(OutputError::new(path, error))
        })?;
        let held = lock(path).ok_or_else(|| {
            // What another process has made and works in stays.
            folder.keep();
            End::input(format_args!(
                "{} is in use: another process writes into it\n  = wait for its end, or choose another folder",
                path.display()
            ))
        })?;
        folder._lock = Some(held);
        for name in &folder.names {
            let place = path.join(name);
            inputs.spare(&place)?;
            is_free(&place).map_err(|error| End::input(OutputError::new(&place, error)))?;
        }
        let first = folder.names.first().map_or("", String::as_str);
        Output::create(&path.join(first)).map_err(End::input)?;
        Ok(folder)
    }

    pub(crate) fn path(&self) -> &'a Path {
        self.path
    }

    /// Writes all results before the first appears under its name, and lets the folder stay; none after an interrupt.
    pub(crate) fn fill(&self, results: Results) -> Result<(), End> {
        self.put(results, End::if_interrupted)
    }

    /// The same after an interrupt too.
    pub(crate) fn keep_all(&self, results: Results) -> Result<(), End> {
        self.put(results, || Ok(()))
    }

    fn put(&self, results: Results, go_on: fn() -> Result<(), End>) -> Result<(), End> {
        for (name, _) in &results.files {
            debug_assert!(self.names.contains(name), "{name} was not claimed");
        }
        let mut outputs = Outputs::of(self.path);
        outputs.put_all(results.files).map_err(End::input)?;
        results.streamed.map_or(Ok(()), |rows| outputs.add(rows)).map_err(End::input)?;
        go_on()?;
        self.keep();
        outputs.keep().map_err(End::input)
    }

    /// Lets the folder stay.
    pub(crate) fn keep(&self) {
        self.made.borrow_mut().clear();
        self.untidy.borrow_mut().take();
    }
}

impl Drop for Folder<'_> {
    fn drop(&mut self) {
        for folder in self.made.borrow().iter() {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Whether a file can be put at `place`: nothing is there, a file that will be replaced, or a device that takes the bytes.
fn is_free(place: &Path) -> io::Result<()> {
    match fs::metadata(place) {
        Ok(found) if found.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if is_pipe(&found) => Err(io::Error::other("this is a pipe, and no file")),
        _ => Ok(()),
    }
}

#[cfg(unix)]
fn is_pipe(found: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    found.file_type().is_fifo() || found.file_type().is_socket()
}

#[cfg(not(unix))]
fn is_pipe(_: &Metadata) -> bool {
    false
}
