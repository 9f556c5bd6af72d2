//! Temporary files beside those that they will replace.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::Path;

use tempfile::NamedTempFile;

use super::lock::FolderLock;

/// The beginning of the name of a temporary file.
const PREFIX: &str = ".lyapunov-";

/// The number of random characters after it.
const RANDOM: usize = 6;

/// Attempts to make a file: until it is locked, another process may take it for a leftover and remove it.
const ATTEMPTS: usize = 16;

/// Temporary file in `folder`, with the permissions of a new file. It is locked, so that it is no leftover as long as it is
/// open.
pub(super) fn beside(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).rand_bytes(RANDOM);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    for _ in 0..ATTEMPTS {
        let file = builder.tempfile_in(folder).map_err(|error| match error.kind() {
            // Some system folders exist but take no files.
            io::ErrorKind::NotFound if folder.is_dir() => {
                io::Error::from(io::ErrorKind::PermissionDenied)
            }
            // The error would name the temporary file, which means nothing to the user.
            kind => io::Error::from(kind),
        })?;
        let is_taken = matches!(file.as_file().try_lock(), Err(TryLockError::WouldBlock));
        if !is_taken && file.path().exists() {
            return Ok(file);
        }
    }
    Err(io::Error::other("its folder is being tidied up without end"))
}

/// Removes the temporary files of killed processes from `folder`, unless another process works in it.
pub(super) fn sweep(folder: &Path) {
    if let Some(lock) = FolderLock::alone(folder) {
        sweep_locked(folder, &lock);
    }
}

/// Removes the temporary files of killed processes from `folder`, which is locked for this process alone.
pub(crate) fn sweep_locked(folder: &Path, _: &FolderLock) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| is_temporary(&entry.file_name().to_string_lossy())) {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        // A file that is locked belongs to a process that lives. What cannot be removed is in nobody's way.
        if let Ok(file) = if is_file { File::open(entry.path()) } else { continue }
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_temporary(name: &str) -> bool {
    let rest = name.strip_prefix(PREFIX);
    rest.is_some_and(|rest| {
        rest.len() == RANDOM && rest.bytes().all(|it| it.is_ascii_alphanumeric())
    })
}
