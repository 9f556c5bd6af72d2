//! Factors from the units of a log to SI units.

use std::str::FromStr;

use super::columns::Role;
use super::error::LogError;
use crate::text::{nearest, shorten};

/// Factor of one column: its numbers times the factor are in SI units.
///
/// ```
/// use lyapunov_lab::observe::Scale;
/// let millimetres: Scale = "x=1e-3".parse()?;
/// assert_eq!(millimetres.factor, 1e-3);
/// # Ok::<(), lyapunov_lab::observe::LogError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The column.
    pub role: Role,
    /// The factor.
    pub factor: f64,
}

impl FromStr for Scale {
    type Err = LogError;

    fn from_str(text: &str) -> Result<Self, LogError> {
        let wrong = |message: &str, help: &str| Err(LogError::new(message).with_help(help));
        let Some((name, factor)) = text.split_once('=') else {
            return wrong("there is no `=` in it", "write a column and a factor, as in x=1e-3");
        };
        let name = name.trim();
        let Some(role) = Role::ALL.into_iter().find(|role| role.letter() == name) else {
            let guess = nearest(name, &["t", "x", "f", "v"]);
            let guess = guess.map_or_else(String::new, |it| format!("did you mean `{it}`? "));
            let help =
                format!("{guess}the columns are t, x, f and v here, whatever the log calls them");
            return wrong(&format!("`{}` is none of t, x, f and v", shorten(name)), &help);
        };
        match factor.trim().parse::<f64>() {
            Ok(factor) if role == Role::T && factor <= 0.0 => {
                wrong("time must not run backwards", "the factor of t is above 0, as in t=1e-3")
            }
            Ok(factor) if factor.is_normal() => Ok(Self { role, factor }),
            _ => wrong(
                &format!("`{}` is no factor", factor.trim()),
                "write a finite number other than 0, as in x=1e-3 or f=-1",
            ),
        }
    }
}
