//! Entry of a program with own stabilizers.

use std::env;
use std::ffi::OsString;
use std::process::ExitCode;

use lyapunov_lab::own::{OwnCandidate, OwnStabilizer, Roster};

use crate::commands::{self, End};

/// All commands, for the stabilizers and candidates of a program among those that ship.
#[derive(Debug, Default)]
pub struct Bench {
    roster: Roster,
}

impl Bench {
    /// What the binary `lyapunov` has, and nothing else.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a stabilizer.
    #[must_use]
    pub fn stabilizer<S: OwnStabilizer>(self) -> Self {
        Self { roster: self.roster.stabilizer::<S>() }
    }

    /// Adds LOLC with a candidate, as `lolc-NAME`.
    #[must_use]
    pub fn candidate<C: OwnCandidate>(self) -> Self {
        Self { roster: self.roster.candidate::<C>() }
    }

    /// Runs the command that the arguments of the program ask for, and returns its exit status; prints
    /// help where they ask for it, or what is wrong with them.
    pub fn main(self) -> ExitCode {
        ExitCode::from(self.told(env::args_os()))
    }

    /// The same for `words`, the first of them the program's name, in place of the arguments of the process: those of an
    /// interpreter are not the program's own. It may be called once in a process, before it reads a scene.
    pub fn told(self, words: impl IntoIterator<Item = OsString>) -> u8 {
        let words: Vec<OsString> = words.into_iter().collect();
        let names: Vec<&str> = self.roster.names().collect();
        match self.roster.enter() {
            Ok(()) => commands::run(&names, words),
            Err(error) => End::input(error).report(),
        }
    }

    /// Whether `words`, the first of them the program's name, ask for a command, without running it.
    ///
    /// # Errors
    /// The text that the command would print: what is wrong with them, or the help that they ask for.
    pub fn understands(&self, words: impl IntoIterator<Item = OsString>) -> Result<(), String> {
        commands::understand(words)
    }
}
