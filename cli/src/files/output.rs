//! Output file that is written whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use lyapunov_lab::{OutputError, sync_folder};
use tempfile::{NamedTempFile, TempPath};

use super::beside::{beside, sweep};
use crate::interrupts::Untidy;

/// Output file that appears under its name when it is [kept](Output::keep), and not before.
///
/// Its bytes are on the disk before it takes its name, and the name is on the disk afterwards: a power failure leaves the old
/// file or the new one. A device, a pipe or anything else that exists and is no regular file is written to directly.
#[derive(Debug)]
pub(crate) struct Output {
    path: PathBuf,
    target: Target,
}

#[derive(Debug)]
enum Target {
    Replace(BufWriter<Unnamed>, PathBuf, Untidy),
    Direct(BufWriter<File>),
}

/// Temporary file whose errors do not tell its name, which means nothing to the user.
#[derive(Debug)]
struct Unnamed(NamedTempFile);

impl Write for Unnamed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.as_file_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.as_file_mut().flush()
    }
}

impl Output {
    /// Whether `path` is written to directly: it exists and is neither a regular file nor a folder.
    pub(crate) fn is_direct(path: &Path) -> bool {
        fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
    }

    /// Opens `path` for writing; no file appears under that name until [`Output::keep`].
    ///
    /// # Errors
    /// A folder that is missing or not writable, or a folder under that name.
    pub(crate) fn create(path: &Path) -> Result<Self, OutputError> {
        let refuse = |source| OutputError::new(path, source);
        let target = if Self::is_direct(path) {
            let file = File::options().write(true).open(path).map_err(refuse)?;
            Target::Direct(BufWriter::new(file))
        } else {
            let place = resolved(path).map_err(refuse)?;
            let folder = folder_of(&place);
            sweep(folder);
            let untidy = Untidy::new();
            let file = beside(folder).map_err(refuse)?;
            Target::Replace(BufWriter::new(Unnamed(file)), place, untidy)
        };
        Ok(Self { path: path.to_owned(), target })
    }

    /// Moves the file to its name.
    ///
    /// # Errors
    /// Any error of the system. Nothing has changed under that name then, unless it was the folder that could not be written
    /// to the disk: then the new file is there, and a power failure may bring the old one back.
    pub(crate) fn keep(self) -> Result<(), OutputError> {
        let written = self.written()?;
        let place = written.place();
        written.keep()?.map_or(Ok(()), |folder| {
            sync_folder(&folder).map_err(|error| OutputError::new(&place, error))
        })
    }

    /// Puts the bytes on the disk; a full device is noticed here.
    pub(super) fn written(self) -> Result<Written, OutputError> {
        let Self { path, target } = self;
        let refuse = |source| OutputError::new(&path, source);
        let file = match target {
            Target::Replace(writer, place, untidy) => {
                let Unnamed(file) =
                    writer.into_inner().map_err(|error| refuse(error.into_error()))?;
                file.as_file().sync_all().map_err(refuse)?;
                Some((file.into_temp_path(), place, untidy))
            }
            Target::Direct(mut writer) => {
                writer.flush().map_err(refuse)?;
                None
            }
        };
        Ok(Written { path, file })
    }

    /// Error of the writer with the name of the file.
    pub(crate) fn blame(&self, source: io::Error) -> OutputError {
        OutputError::new(&self.path, source)
    }
}

/// File whose bytes are on the disk, and that is not under its name yet.
#[derive(Debug)]
pub(super) struct Written {
    path: PathBuf,
    /// The temporary file and the name it will get; none if the output was written directly.
    file: Option<(TempPath, PathBuf, Untidy)>,
}

impl Written {
    /// The path as it was asked for.
    pub(super) fn place(&self) -> PathBuf {
        self.path.clone()
    }

    /// Gives the file its name, and returns the folder that has changed.
    pub(super) fn keep(self) -> Result<Option<PathBuf>, OutputError> {
        let Self { path, file } = self;
        let Some((file, place, _untidy)) = file else { return Ok(None) };
        let folder = folder_of(&place).to_owned();
        file.persist(place).map_err(|error| OutputError::new(&path, error.error))?;
        super::KEPT.store(true, Ordering::Relaxed);
        Ok(Some(folder))
    }
}

/// Path of the file to replace: of a symbolic link, its target and not the link.
fn resolved(path: &Path) -> io::Result<PathBuf> {
    // `new/` names no file, although its last component looks like a file name.
    let last = path.as_os_str().as_encoded_bytes().last().copied().map(char::from);
    if path.is_dir() || last.is_some_and(std::path::is_separator) {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    match fs::canonicalize(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => match fs::read_link(path) {
            // No endless recursion: canonicalize has followed the whole chain of links, so the chain ends.
            Ok(target) => resolved(&folder_of(path).join(target)),
            Err(_) => Ok(path.to_owned()),
        },
        found => found,
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.target {
            Target::Replace(writer, ..) => writer.write(bytes),
            Target::Direct(writer) => writer.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.target {
            Target::Replace(writer, ..) => writer.flush(),
            Target::Direct(writer) => writer.flush(),
        }
    }
}
