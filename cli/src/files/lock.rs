//! Lock of a folder.

use std::fs::{File, TryLockError};
use std::path::Path;

/// Lock of a folder, until it is dropped or the process ends, however it ends.
///
/// The folder itself is locked, so that no file stays behind. Where the system has no locks, and on a file system without
/// them, nothing is locked and nobody is kept out.
#[derive(Debug)]
pub(crate) struct FolderLock(
    #[expect(dead_code, reason = "the lock lasts as long as the file is open")] Option<File>,
);

impl FolderLock {
    /// The lock of `folder` for one process alone; none if another has it.
    pub(crate) fn alone(folder: &Path) -> Option<Self> {
        Self::by(folder, File::try_lock)
    }

    /// The lock of `folder` for processes that each have files of their own in it; none if one has it alone.
    pub(crate) fn shared(folder: &Path) -> Option<Self> {
        Self::by(folder, File::try_lock_shared)
    }

    fn by(folder: &Path, lock: impl Fn(&File) -> Result<(), TryLockError>) -> Option<Self> {
        let opened = File::open(folder).ok();
        match opened.as_ref().map(lock) {
            Some(Err(TryLockError::WouldBlock)) => None,
            _ => Some(Self(opened)),
        }
    }
}
