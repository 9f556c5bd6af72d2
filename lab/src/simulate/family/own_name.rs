//! Name of an own stabilizer.

use crate::files::scene::Stabilizer;
use crate::files::scene::own::{self, Declared, OwnTable};

/// Stabilizer of the program's own, which a [`Roster`](crate::own::Roster) has entered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OwnName(&'static Declared);

impl OwnName {
    /// All of them, in the order in which they were entered.
    pub fn all() -> impl Iterator<Item = Self> {
        own::declared().iter().map(Self)
    }

    /// The name as text.
    pub fn name(self) -> &'static str {
        self.0.name()
    }

    /// Its table without a written key.
    pub(super) fn table(self) -> Stabilizer {
        Stabilizer::Own(OwnTable::of(self.0))
    }
}
