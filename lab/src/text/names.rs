//! Names of entrants on the command line: one, or a list.

use std::fmt;
use std::ops::Deref;
use std::str::FromStr;

use super::excerpt::shorten;
use super::suggest::nearest;

/// Entrant that is called by name on the command line.
pub trait Named: Copy + PartialEq + 'static {
    /// The kind of file whose entrants these are, such as `a model`.
    const KIND: &'static str;

    /// All entrants, in the order of the rows.
    const ALL: &'static [Self];

    /// The name on the command line and in tables.
    fn name(self) -> &'static str;
}

/// Entrants in the order given, each once: `none,wave-variables`, or `all`; the default is all.
///
/// ```
/// use lyapunov_lab::{compare::Names, teleoperation::Entrant};
/// let names: Names<Entrant> = "two-layer,none".parse()?;
/// assert_eq!(names[..], [Entrant::TwoLayer, Entrant::None]);
/// let error = "two-layers".parse::<Names<Entrant>>().unwrap_err();
/// assert!(error.to_string().contains("did you mean `two-layer`?"));
/// # Ok::<(), lyapunov_lab::compare::NamesError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Names<N>(Vec<N>);

impl<N: Named> Default for Names<N> {
    fn default() -> Self {
        Self(N::ALL.to_vec())
    }
}

impl<N> Deref for Names<N> {
    type Target = [N];

    fn deref(&self) -> &[N] {
        &self.0
    }
}

impl<N: Named> FromStr for Names<N> {
    type Err = NamesError;

    fn from_str(given: &str) -> Result<Self, NamesError> {
        if given == "all" {
            return Ok(Self::default());
        }
        let mut named: Vec<N> = Vec::new();
        for name in given.split(',').map(str::trim) {
            match N::ALL.iter().copied().find(|one| one.name() == name) {
                _ if name == "all" => return Err(NamesError::AllAndMore),
                None => return Err(NamesError::unknown::<N>(name)),
                Some(one) if named.contains(&one) => return Err(NamesError::Twice(one.name())),
                Some(one) => named.push(one),
            }
        }
        Ok(Self(named))
    }
}

/// Reason why a text is no list of names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NamesError {
    /// A name that nobody has.
    Unknown {
        /// The name.
        given: String,
        /// The kind of file.
        kind: &'static str,
        /// The names that there are.
        known: Vec<&'static str>,
    },
    /// `all` beside a name.
    AllAndMore,
    /// A name that appears twice.
    Twice(&'static str),
}

impl NamesError {
    fn unknown<N: Named>(given: &str) -> Self {
        let known = N::ALL.iter().map(|one| one.name()).collect();
        Self::Unknown { given: given.to_owned(), kind: N::KIND, known }
    }
}

impl fmt::Display for NamesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { given, kind, known } => {
                write!(f, "no stabilizer of {kind} is called `{}`\n  = ", shorten(given))?;
                if let Some(name) = nearest(given, known) {
                    write!(f, "did you mean `{name}`?\n  = ")?;
                }
                f.write_str("the names are:")?;
                known.chunks(4).try_for_each(|names| write!(f, "\n    {}", names.join(", ")))
            }
            Self::AllAndMore => f.write_str(
                "`all` stands by itself\n  = leave the other names out, or name who is meant",
            ),
            Self::Twice(name) => {
                write!(f, "`{name}` is named twice\n  = name each stabilizer once")
            }
        }
    }
}

impl std::error::Error for NamesError {}
