//! Files that are written whole or not at all.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

/// A file in the making: it appears under its name when it is [kept](Output::keep), and not before.
///
/// What is there already and is no regular file (a device, a pipe) is written to directly.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    target: Target,
}

#[derive(Debug)]
enum Target {
    Replace(BufWriter<NamedTempFile>, PathBuf),
    Direct(BufWriter<File>),
}

/// Why a file could not be written.
#[derive(Debug)]
pub struct OutputError {
    path: PathBuf,
    source: io::Error,
}

impl OutputError {
    /// The error that `path` met.
    pub fn new(path: &Path, source: io::Error) -> Self {
        Self { path: path.to_owned(), source }
    }

    /// What the system said.
    pub fn source(&self) -> &io::Error {
        &self.source
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} cannot be written: {}", self.path.display(), self.source)?;
        let remedy = match self.source.kind() {
            io::ErrorKind::NotFound => "create the folder first, or name one that exists",
            io::ErrorKind::IsADirectory => "give the name of a file, not of a folder",
            io::ErrorKind::NotADirectory => "part of the path is a file; name a folder there",
            io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
                "choose a place that you may write to"
            }
            io::ErrorKind::StorageFull => "free some space there, or choose another place",
            _ => return Ok(()),
        };
        write!(f, "\n  = {remedy}")
    }
}

impl std::error::Error for OutputError {}

impl Output {
    /// Opens `path` for writing; nothing is there under that name until [`Output::keep`].
    ///
    /// # Errors
    /// A folder that is missing or not writable, or a folder under that name.
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let refuse = |source| OutputError::new(path, source);
        let target = match fs::metadata(path) {
            Ok(found) if found.is_dir() => {
                return Err(refuse(io::ErrorKind::IsADirectory.into()));
            }
            Ok(found) if !found.is_file() => {
                let file = File::options().write(true).open(path).map_err(refuse)?;
                Target::Direct(BufWriter::new(file))
            }
            found => {
                // Through a link, the file it points to is replaced, not the link.
                let place = match found {
                    Ok(_) => fs::canonicalize(path).map_err(refuse)?,
                    Err(_) => path.to_owned(),
                };
                Target::Replace(BufWriter::new(beside(&place).map_err(refuse)?), place)
            }
        };
        Ok(Self { path: path.to_owned(), target })
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// What the system says; then nothing has changed under that name.
    pub fn keep(self) -> Result<(), OutputError> {
        let Self { path, target } = self;
        let refuse = |source| OutputError { path, source };
        match target {
            Target::Replace(writer, place) => {
                let file = match writer.into_inner() {
                    Ok(file) => file,
                    Err(error) => return Err(refuse(error.into_error())),
                };
                file.persist(place).map(drop).map_err(|error| refuse(error.error))
            }
            Target::Direct(mut writer) => writer.flush().map_err(refuse),
        }
    }

    /// Says which file an error of the writer is about.
    pub fn blame(&self, source: io::Error) -> OutputError {
        OutputError::new(&self.path, source)
    }
}

/// A file without a name of its own yet, in the folder of `place`, with the rights that a new file has.
fn beside(place: &Path) -> io::Result<NamedTempFile> {
    let folder = match place.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lyapunov-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.target {
            Target::Replace(writer, _) => writer.write(bytes),
            Target::Direct(writer) => writer.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.target {
            Target::Replace(writer, _) => writer.flush(),
            Target::Direct(writer) => writer.flush(),
        }
    }
}
