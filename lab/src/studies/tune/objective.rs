//! Objective of tuning.

use std::fmt;
use std::str::FromStr;

use crate::text::nearest;

/// Goal of tuning: a weighted sum of costs, the smaller the better.
///
/// `J = Σ w_i c_i` over the [terms](Term). A bare name has the weight 1: `settling`, `settling=1,force-error=0.5`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Objective {
    weights: [f64; Term::ALL.len()],
}

/// Weights whose costs can be squared, as the interval of a change does.
const WEIGHTS: std::ops::RangeInclusive<f64> = 1e-50..=1e50;

/// Cost of a run that an objective may count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// Settling time, s; of a run that does not settle its duration.
    Settling,
    /// Root mean square of the force on the plant minus the ideal wall's in contact, N.
    ForceError,
    /// Stiffness that is not felt in contacts of half a second or more, percent of the wall's; all of it where no
    /// contact lasts so long.
    Stiffness,
}

impl Term {
    /// All terms.
    pub const ALL: [Self; 3] = [Self::Settling, Self::ForceError, Self::Stiffness];

    /// Name on the command line and in `tune.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Settling => "settling",
            Self::ForceError => "force-error",
            Self::Stiffness => "stiffness",
        }
    }

    /// Unit of the cost.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Settling => "s",
            Self::ForceError => "N",
            Self::Stiffness => "% lacking",
        }
    }
}

impl Objective {
    /// Weight of `term`, per its unit.
    pub fn weight(&self, term: Term) -> f64 {
        self.weights[term as usize]
    }

    /// The terms that count.
    pub fn terms(&self) -> impl Iterator<Item = Term> + '_ {
        Term::ALL.into_iter().filter(|term| self.weight(*term) > 0.0)
    }

    /// The weighted sum of `costs`, which are in the order of [`Term::ALL`].
    pub(super) fn of(&self, costs: [f64; Term::ALL.len()]) -> f64 {
        self.terms().map(|term| self.weight(term) * costs[term as usize]).sum()
    }

    /// Unit of the sum: that of a single term of weight 1, else none.
    pub fn unit(&self) -> &'static str {
        let mut terms = self.terms();
        match (terms.next(), terms.next()) {
            (Some(term), None) if self.weight(term) == 1.0 => term.unit(),
            _ => "",
        }
    }
}

impl Default for Objective {
    fn default() -> Self {
        Self { weights: [1.0, 0.0, 0.0] }
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, term) in self.terms().enumerate() {
            let comma = if index == 0 { "" } else { "," };
            match self.weight(term) {
                1.0 => write!(f, "{comma}{}", term.name())?,
                weight => write!(f, "{comma}{}={weight}", term.name())?,
            }
        }
        Ok(())
    }
}

/// Reason why a text is no objective.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjectiveError(String);

impl fmt::Display for ObjectiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for ObjectiveError {}

impl FromStr for Objective {
    type Err = ObjectiveError;

    fn from_str(text: &str) -> Result<Self, ObjectiveError> {
        let mut weights = [0.0; Term::ALL.len()];
        for part in text.split(',').map(str::trim) {
            let (name, weight) = part.split_once('=').unwrap_or((part, "1"));
            let (name, weight) = (name.trim(), weight.trim());
            let names = Term::ALL.map(Term::name);
            let Some(term) = Term::ALL.into_iter().find(|term| term.name() == name) else {
                let remedy = match nearest(name, &names) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("the terms are {}", names.join(", ")),
                };
                return Err(ObjectiveError(format!(
                    "no objective is named `{name}`\n  = {remedy}"
                )));
            };
            let number: Option<f64> = weight.parse().ok();
            let Some(weight) = number.filter(|weight| WEIGHTS.contains(weight)) else {
                let problem = format!("the weight of `{name}` is `{weight}`");
                let remedy = "give a number from 1e-50 to 1e50, as in settling=1,force-error=0.5";
                return Err(ObjectiveError(format!("{problem}\n  = {remedy}")));
            };
            if weights[term as usize] > 0.0 {
                let problem = format!("`{name}` is in the objective twice");
                return Err(ObjectiveError(format!("{problem}\n  = name each term once")));
            }
            weights[term as usize] = weight;
        }
        Ok(Self { weights })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_objective_is_read_as_it_is_written() {
        for text in ["settling", "force-error", "settling=2,stiffness=0.5", "stiffness"] {
            let read: Objective = text.parse().unwrap();
            assert_eq!(read.to_string(), text);
        }
        let sum: Objective = "settling, force-error = 0.5".parse().unwrap();
        assert_eq!(sum.of([3.0, 4.0, 100.0]), 5.0);
    }

    #[test]
    fn a_wrong_objective_is_refused_with_a_remedy() {
        let refused = |text: &str| text.parse::<Objective>().unwrap_err().to_string();
        assert!(refused("setling").contains("did you mean `settling`?"));
        for weight in ["0", "-1", "inf", "1e155", "1e-170"] {
            assert!(refused(&format!("settling={weight}")).contains("from 1e-50 to 1e50"));
        }
        assert!(refused("settling,settling").contains("twice"));
        assert!(refused("").contains("the terms are"));
    }
}
