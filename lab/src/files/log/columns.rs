//! The requested columns of a log and their roles.

use std::str::FromStr;

use serde::Serialize;

use super::error::LogError;
use crate::text::shorten;

/// The columns of time, position, force and, optionally, velocity, in this order: by name, or by number from 1.
///
/// A name is that of a heading, with its unit or without. The letters t, x, f and v, which are the default, stand for the
/// words of [`Role::words`] as well, where no heading is called so.
///
/// ```
/// use lyapunov_lab::observe::Columns;
/// assert!("time,position,force".parse::<Columns>().is_ok());
/// assert!("1,4,2,5".parse::<Columns>().is_ok());
/// assert!("time,position".parse::<Columns>().is_err());
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Columns(Vec<String>);

impl Columns {
    /// Each role with its requested column.
    pub(super) fn roles(&self) -> impl Iterator<Item = (Role, &str)> {
        Role::ALL.into_iter().zip(self.0.iter().map(String::as_str))
    }

    /// Whether there is a column of this role.
    pub(crate) fn has(&self, role: Role) -> bool {
        role.index() < self.0.len()
    }

    /// Whether every column is given by its number.
    pub(super) fn numbered(&self) -> bool {
        self.0.iter().all(|name| position(name).is_some())
    }
}

/// Index, from 0, of a column that is given by its number, from 1.
pub(super) fn position(name: &str) -> Option<usize> {
    name.parse::<usize>().ok()?.checked_sub(1)
}

impl Default for Columns {
    fn default() -> Self {
        Self(["t", "x", "f"].map(str::to_owned).to_vec())
    }
}

impl FromStr for Columns {
    type Err = LogError;

    fn from_str(text: &str) -> Result<Self, LogError> {
        let names: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
        if !(3..=4).contains(&names.len()) || names.iter().any(String::is_empty) {
            return Err(LogError::new("these are not three or four names").with_help(
                "name the columns of time, position, force and, if there is one, velocity, as in \
                 t,x,f or 1,4,2",
            ));
        }
        for (index, name) in names.iter().enumerate() {
            if names[..index].contains(name) {
                return Err(LogError::new(format!("the column `{name}` is named twice"))
                    .with_help("time, position, force and velocity are four different columns"));
            }
        }
        Ok(Self(names))
    }
}

/// Column of a log as it was read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Column {
    /// Its quantity.
    pub role: Role,
    /// Its heading; none in a log without headings.
    pub heading: Option<String>,
    /// The unit that the heading, or the line below it, tells and the numbers were read in; none where it tells none, or `--scale` another.
    pub unit: Option<&'static str>,
    /// Whether the heading has another name than was asked for.
    #[serde(skip)]
    pub(crate) is_guessed: bool,
}

/// Quantity that a column of a log holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// Time, s.
    T,
    /// Position, m.
    X,
    /// The environment's force on the device from this row until the next, N.
    F,
    /// Velocity, m/s.
    V,
}

impl Role {
    /// All roles, in the order of the columns.
    pub const ALL: [Self; 4] = [Self::T, Self::X, Self::F, Self::V];

    /// Its letter on the command line.
    pub fn letter(self) -> &'static str {
        match self {
            Self::T => "t",
            Self::X => "x",
            Self::F => "f",
            Self::V => "v",
        }
    }

    /// The names that its letter stands for.
    pub fn words(self) -> &'static [&'static str] {
        match self {
            Self::T => &["time", "timestamp"],
            Self::X => &["position", "pos"],
            Self::F => &["force", "f_act"],
            Self::V => &["velocity"],
        }
    }

    /// Its quantity in a word.
    pub(super) fn quantity(self) -> &'static str {
        self.words()[0]
    }

    pub(super) fn index(self) -> usize {
        self as usize
    }
}

/// The meaning that the headings of a log gave its columns unasked, in words; none where they gave none.
pub(crate) fn described(columns: &[Column], decimal_commas: bool) -> Option<String> {
    let told = columns.iter().filter(|it| it.is_guessed || it.unit.is_some());
    let mut told: Vec<String> = told
        .map(|column| {
            let heading = shorten(column.heading.as_deref().unwrap_or_default());
            let unit = column.unit.map_or_else(String::new, |unit| format!(" in {unit}"));
            format!("{} is `{heading}`{unit}", column.role.letter())
        })
        .collect();
    if decimal_commas {
        told.push("numbers have decimal commas".to_owned());
    }
    (!told.is_empty()).then(|| told.join(", "))
}
