//! Names in a folder that outlast a power failure.

use std::fs::File;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Waits until the names in `folder` are on the disk: that of a new file, and that of one that was renamed, is written with
/// the folder and not with the file.
///
/// # Errors
/// Those of the disk. A folder that may not be opened, and a system that cannot say, are none.
pub fn sync_folder(folder: &Path) -> io::Result<()> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let Ok(opened) = File::open(folder) else { return Ok(()) };
    match opened.sync_all() {
        Err(error)
            if matches!(
                error.kind(),
                ErrorKind::InvalidInput | ErrorKind::Unsupported | ErrorKind::PermissionDenied
            ) =>
        {
            Ok(())
        }
        result => result,
    }
}
