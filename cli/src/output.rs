//! Files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use lyapunov_lab::OutputError;
use tempfile::{NamedTempFile, TempPath};

/// A file in the making: it appears under its name when it is [kept](Output::keep), and not before.
///
/// What is there already and is no regular file (a device, a pipe) is written to directly.
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
    /// Whether what is at `path` is written to directly: it is there already and no regular file.
    pub(crate) fn is_direct(path: &Path) -> bool {
        fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
    }

    /// Opens `path` for writing; nothing is there under that name until [`Output::keep`].
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

    /// Puts the file in its place.
    ///
    /// # Errors
    /// What the system says; then nothing has changed under that name.
    pub(crate) fn keep(self) -> Result<(), OutputError> {
        self.written()?.keep()
    }

    /// Closes the file: a device that is full is noticed here.
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

    /// Says which file an error of the writer is about.
    pub(crate) fn blame(&self, source: io::Error) -> OutputError {
        OutputError::new(&self.path, source)
    }
}

/// Files of one folder, all of which are written before the first takes its name.
#[derive(Debug)]
pub(crate) struct Outputs<'a> {
    folder: &'a Path,
    written: Vec<Written>,
}

/// A file that is whole, closed, and not under its name yet.
#[derive(Debug)]
struct Written {
    path: PathBuf,
    /// What is to take which name; none if it went to where it is directly.
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
    /// Those of `folder`, none so far.
    pub(crate) fn of(folder: &'a Path) -> Self {
        Self { folder, written: Vec::new() }
    }

    /// Writes the file that will be called `name`.
    ///
    /// # Errors
    /// As [`Output::create`], and a device that is full.
    pub(crate) fn put(&mut self, name: &str, bytes: impl AsRef<[u8]>) -> Result<(), OutputError> {
        let mut output = Output::create(&self.folder.join(name))?;
        output.write_all(bytes.as_ref()).map_err(|error| output.blame(error))?;
        self.written.push(output.written()?);
        Ok(())
    }

    /// Writes these files, name and bytes.
    ///
    /// # Errors
    /// As [`Outputs::put`].
    pub(crate) fn put_all(
        &mut self,
        files: impl IntoIterator<Item = (String, Vec<u8>)>,
    ) -> Result<(), OutputError> {
        files.into_iter().try_for_each(|(name, bytes)| self.put(&name, bytes))
    }

    /// Puts all files in their places, one after the other.
    ///
    /// # Errors
    /// As [`Output::keep`]; the files before that one are in their places then.
    pub(crate) fn keep(self) -> Result<(), OutputError> {
        self.written.into_iter().try_for_each(Written::keep)
    }
}

/// Where the file is or will be: through a link, the file it points to is replaced, not the link.
fn resolved(path: &Path) -> io::Result<PathBuf> {
    // `new/` is a path without a file's name too, although its last part would pass for one.
    let last = path.as_os_str().as_encoded_bytes().last().copied().map(char::from);
    if path.is_dir() || last.is_some_and(std::path::is_separator) {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    match fs::canonicalize(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => match fs::read_link(path) {
            // The system has followed the chain of links to its end already, so there is one.
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

/// A file without a name of its own yet, in the folder of `place`, with the rights that a new file has.
fn beside(place: &Path) -> io::Result<NamedTempFile> {
    let folder = folder_of(place);
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lyapunov-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|error| match error.kind() {
        // Some folders of the system are there and take no files.
        io::ErrorKind::NotFound if folder.is_dir() => io::ErrorKind::PermissionDenied.into(),
        // The error names the file without a name, which means nothing to anybody.
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
