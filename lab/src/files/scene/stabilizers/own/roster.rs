//! The own stabilizers of this program.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::OnceLock;

use super::own_table::MOST;
use super::{Declared, OwnNumber};
use crate::files::scene::book::Key;

static ROSTER: OnceLock<Roster> = OnceLock::new();

struct Roster {
    declared: Vec<Declared>,
    names: Vec<&'static str>,
    keys: Vec<Key>,
}

impl Roster {
    fn of(declared: Vec<Declared>) -> Self {
        let shipped = super::super::SHIPPED.iter().copied();
        let names = shipped.chain(declared.iter().map(|own| own.name)).collect();
        let keys = declared.iter().flat_map(|own| own.keys.iter().copied()).collect();
        Self { declared, names, keys }
    }
}

fn roster() -> &'static Roster {
    // The first look closes the roster, so that a name is known from the start or never.
    ROSTER.get_or_init(|| Roster::of(Vec::new()))
}

/// The own stabilizers, in the order in which they were entered.
pub(crate) fn declared() -> &'static [Declared] {
    &roster().declared
}

/// The own stabilizer of that name.
pub(crate) fn named(name: &str) -> Option<&'static Declared> {
    declared().iter().find(|own| own.name == name)
}

/// The names of all tables of stabilizers.
pub(in super::super) fn tables() -> &'static [&'static str] {
    &roster().names
}

/// The keys of all own stabilizers, for messages.
pub(crate) fn keys() -> &'static [Key] {
    &roster().keys
}

/// Enters the own stabilizers of this program, once and before any name or scene is read; `taken` are the names of others.
///
/// # Errors
/// Names or keys that cannot be, or are taken; a second call, or one that comes too late.
pub(crate) fn enter(all: Vec<Declared>, taken: &[&str]) -> Result<(), RosterError> {
    let mut names: BTreeSet<&str> = taken.iter().copied().collect();
    for own in &all {
        let name = own.name;
        if !is_word(name, '-') {
            return Err(RosterError::Name(name));
        }
        if !names.insert(name) {
            return Err(match taken.contains(&name) {
                true => RosterError::Shipped(name),
                false => RosterError::Twice(name),
            });
        }
        check_numbers(name, &own.numbers)?;
    }
    ROSTER.set(Roster::of(all)).map_err(|_| RosterError::Late)
}

fn check_numbers(name: &'static str, numbers: &[OwnNumber]) -> Result<(), RosterError> {
    let mut keys = BTreeSet::new();
    for key in numbers.iter().map(|number| number.key) {
        if !is_word(key, '_') {
            return Err(RosterError::Key(name, key));
        }
        if !keys.insert(key) {
            return Err(RosterError::KeyTwice(name, key));
        }
    }
    if numbers.len() > MOST { Err(RosterError::Many(name, numbers.len())) } else { Ok(()) }
}

/// Whether `text` is small letters and digits, joined by `joint`, from a letter to a letter or digit.
fn is_word(text: &str, joint: char) -> bool {
    let plain = |it: char| it.is_ascii_lowercase() || it.is_ascii_digit();
    text.starts_with(|it: char| it.is_ascii_lowercase())
        && text.ends_with(plain)
        && text.chars().all(|it| plain(it) || it == joint)
}

/// Reason why own stabilizers cannot be entered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RosterError {
    /// A name that cannot stand in a file or on a command line.
    Name(&'static str),
    /// A name that ships.
    Shipped(&'static str),
    /// A name that two have.
    Twice(&'static str),
    /// A key that cannot stand in a table: the stabilizer, and the key.
    Key(&'static str, &'static str),
    /// A key that two numbers of a stabilizer have.
    KeyTwice(&'static str, &'static str),
    /// More numbers than a stabilizer may have: the stabilizer, and how many.
    Many(&'static str, usize),
    /// Own stabilizers are there already, or a name or scene was read before them.
    Late,
}

impl fmt::Display for RosterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => write!(
                f,
                "`{name}` cannot be the name of a stabilizer\n  = small letters and digits, joined by dashes, as in `my-popc`"
            ),
            Self::Shipped(name) => write!(
                f,
                "`{name}` is a name that ships\n  = give your own another, such as `my-{name}`"
            ),
            Self::Twice(name) => {
                write!(f, "two own stabilizers are called `{name}`\n  = give one another name")
            }
            Self::Key(name, key) => write!(
                f,
                "`{key}` of `{name}` cannot be a key\n  = small letters and digits, joined by underscores, as in `damping_cap`"
            ),
            Self::KeyTwice(name, key) => write!(
                f,
                "two numbers of `{name}` are called `{key}`\n  = give one another key; a candidate has `damping_cap` already"
            ),
            Self::Many(name, count) => write!(
                f,
                "`{name}` has {count} numbers, and a stabilizer has {MOST} at most\n  = compute the others from these, or fix them"
            ),
            Self::Late => f.write_str(
                "own stabilizers are entered once, before any name or scene is read\n  = enter all of them first in `main`",
            ),
        }
    }
}

impl std::error::Error for RosterError {}
