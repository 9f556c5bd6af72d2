//! Output files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use lyapunov_lab::OutputError;
use tempfile::{NamedTempFile, TempPath};

/// Output file that appears under its name when it is [kept](Output::keep), and not before.
///
/// A device, a pipe or anything else that exists and is no regular file is written to directly.
#[derive(Debug)]
pub(crate) struct Output {
    path: PathBuf,
    target: Target,
}

#[derive(Debug)]
enum Target {
    Replace(BufWriter<NamedTempFile>, PathBuf),
    Direct(BufWriter<File>),
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
            Target::Replace(BufWriter::new(beside(&place).map_err(refuse)?), place)
        };
        Ok(Self { path: path.to_owned(), target })
    }

    /// Moves the file to its name.
    ///
    /// # Errors
    /// Any error of the system; nothing has changed under that name then.
    pub(crate) fn keep(self) -> Result<(), OutputError> {
        self.written()?.keep()
    }

    /// Closes the file; a full device is noticed here.
    fn written(self) -> Result<Written, OutputError> {
        let Self { path, target } = self;
        let refuse = |source| OutputError::new(&path, source);
        let file = match target {
            Target::Replace(writer, place) => {
                let file = writer.into_inner().map_err(|error| refuse(error.into_error()))?;
                Some((file.into_temp_path(), place))
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

/// Output files of one folder, all of which are written before the first takes its name.
#[derive(Debug)]
pub(crate) struct Outputs<'a> {
    folder: &'a Path,
    written: Vec<Written>,
}

/// File that is written and closed, and not under its name yet.
#[derive(Debug)]
struct Written {
    path: PathBuf,
    /// The temporary file and the name it will get; none if the output was written directly.
    file: Option<(TempPath, PathBuf)>,
}

impl Written {
    fn keep(self) -> Result<(), OutputError> {
        let Self { path, file } = self;
        let Some((file, place)) = file else { return Ok(()) };
        file.persist(place).map_err(|error| OutputError::new(&path, error.error))
    }
}

impl<'a> Outputs<'a> {
    /// No files yet, for `folder`.
    pub(crate) fn of(folder: &'a Path) -> Self {
        Self { folder, written: Vec::new() }
    }

    /// Writes the file that will be called `name`.
    ///
    /// # Errors
    /// As [`Output::create`], and a full device.
    pub(crate) fn put(&mut self, name: &str, bytes: impl AsRef<[u8]>) -> Result<(), OutputError> {
        let mut output = Output::create(&self.folder.join(name))?;
        output.write_all(bytes.as_ref()).map_err(|error| output.blame(error))?;
        self.written.push(output.written()?);
        Ok(())
    }

    /// Adds a file that has been written already.
    ///
    /// # Errors
    /// A full device.
    pub(crate) fn add(&mut self, output: Output) -> Result<(), OutputError> {
        self.written.push(output.written()?);
        Ok(())
    }

    /// Writes several files, each given by name and bytes.
    ///
    /// # Errors
    /// As [`Outputs::put`].
    pub(crate) fn put_all(
        &mut self,
        files: impl IntoIterator<Item = (String, Vec<u8>)>,
    ) -> Result<(), OutputError> {
        files.into_iter().try_for_each(|(name, bytes)| self.put(&name, bytes))
    }

    /// Moves all files to their names, one after the other.
    ///
    /// # Errors
    /// As [`Output::keep`]; the files before the failed one have their names then.
    pub(crate) fn keep(self) -> Result<(), OutputError> {
        self.written.into_iter().try_for_each(Written::keep)
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

/// Temporary file in the folder of `place`, with the permissions of a new file.
fn beside(place: &Path) -> io::Result<NamedTempFile> {
    let folder = folder_of(place);
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lyapunov-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|error| match error.kind() {
        // Some system folders exist but take no files.
        io::ErrorKind::NotFound if folder.is_dir() => io::ErrorKind::PermissionDenied.into(),
        // The error would name the temporary file, which means nothing to the user.
        kind => kind.into(),
    })
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
