//! List of the own stabilizers of a program.

use super::maker::{Alone, Watching, make};
use super::{OwnCandidate, OwnStabilizer};
use crate::files::scene::own::{Declared, RosterError, enter};
use crate::simulate::family::StabilizerName;

/// Word that stands for all names.
const ALL: &str = "all";

/// The own stabilizers and candidates of a program, in the order in which lists name them.
#[derive(Debug, Default)]
pub struct Roster {
    declared: Vec<Declared>,
}

impl Roster {
    /// Nobody yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a stabilizer.
    #[must_use]
    pub fn stabilizer<S: OwnStabilizer>(self) -> Self {
        self.with(Declared::stabilizer(S::NAME, S::NUMBERS, S::PROMISE, make::<Alone<S>>))
    }

    /// Adds LOLC with a candidate, as `lolc-NAME`.
    #[must_use]
    pub fn candidate<C: OwnCandidate>(self) -> Self {
        self.with(Declared::candidate(C::NAME, C::NUMBERS, C::PROMISE, make::<Watching<C>>))
    }

    /// Enters them for the life of the program.
    ///
    /// # Errors
    /// A name that ships, that two have or that cannot be one; keys likewise; a second call, or one after a name or a scene
    /// was read.
    pub fn enter(self) -> Result<(), RosterError> {
        let shipped = StabilizerName::ALL.map(StabilizerName::name);
        enter(self.declared, &[&shipped[..], &[ALL]].concat())
    }

    /// The names in the order in which they were added.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.declared.iter().map(Declared::name)
    }

    fn with(mut self, declared: Declared) -> Self {
        self.declared.push(declared);
        self
    }
}
