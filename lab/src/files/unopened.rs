//! Words for a file that cannot be opened.

use std::io::ErrorKind;

/// Fault and remedy; none where an error of this kind has words of its own.
pub(super) fn unopened(kind: ErrorKind) -> Option<[&'static str; 2]> {
    match kind {
        ErrorKind::NotFound => {
            Some(["there is no such file", "check the path; it is taken from the current folder"])
        }
        ErrorKind::PermissionDenied => {
            Some(["this file may not be read", "check its permissions and those of its folder"])
        }
        _ => None,
    }
}
