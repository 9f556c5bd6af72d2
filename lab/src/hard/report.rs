//! The report page.

use super::Catalogue;

pub(super) fn page(_catalogue: &Catalogue, command: &str) -> String {
    command.to_owned()
}
