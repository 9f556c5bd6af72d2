//! The rules between the values of a model.

use lyapunov::Requirement;

use super::model::Model;
use super::plant::Plant;
use crate::files::scene::{Conflict, Refused, Scalar, check_single, check_ticks};
use crate::text::found;

/// The most that a number loses where it is shown with four digits, as a share.
const ROUNDING: f64 = 1e-3;

impl Model {
    /// Checks the rules between values, except those of the loop's blocks, which are checked when the loop is built.
    ///
    /// # Errors
    /// The first broken rule, with its key.
    pub(crate) fn check_rules(&self) -> Result<(), Conflict> {
        check_ticks(self.duration, self.servo_rate)?;
        self.check_initial()?;
        self.check_gains()?;
        if self.scalar == Scalar::F32 { check_single(self) } else { Ok(()) }
    }

    fn check_initial(&self) -> Result<(), Conflict> {
        let (states, given) = (self.plant.states(), self.initial.len());
        if given == states.len() {
            return Ok(());
        }
        Err(Conflict::new(
            "initial",
            format!(
                "`initial` has {}, but the plant `{}` has {} states",
                numbers(given),
                self.plant.name(),
                states.len()
            ),
            format!("give them all, counted from rest: {}", states.join(", ")),
        ))
    }

    fn check_gains(&self) -> Result<(), Conflict> {
        let inputs = self.plant.inputs();
        for (key, gains) in [
            ("controller.proportional", &self.controller.proportional),
            ("controller.derivative", &self.controller.derivative),
        ] {
            let given = gains.len();
            if given != 0 && given != inputs {
                let (name, remedy) = (self.plant.name(), ["a number", "a list of two"][inputs - 1]);
                let has = ["one input", "two inputs"][inputs - 1];
                return Err(Conflict::new(
                    key,
                    format!("`{key}` has {}, but the plant `{name}` has {has}", numbers(given)),
                    format!("give {remedy}"),
                ));
            }
        }
        Ok(())
    }

    /// The conflict at `key` for a parameter that a block of the loop rejected.
    pub(crate) fn refusal(&self, (key, error): Refused) -> Conflict {
        if key == "controller.proportional" {
            let remedy = match (&self.plant, error.requirement) {
                (Plant::InvertedPendulum(_), Requirement::AtLeast(least)) => {
                    format!("give {least:?} N.m/rad or more: that is m g l")
                }
                (Plant::ProstheticLeg(_), Requirement::AtLeast(least)) => {
                    let enough = found(least * (1.0 + ROUNDING));
                    format!(
                        "gravity pulls the leg out of its posture: two springs of {enough} N.m/rad or more hold it"
                    )
                }
                (Plant::ProstheticLeg(_), _) => "give two numbers above 0".to_owned(),
                _ => "give numbers of 0 or more".to_owned(),
            };
            // A leg's springs hold it together.
            let (value, noun) = match error.requirement {
                Requirement::AtLeast(_) if self.plant.inputs() > 1 => {
                    let gains = [0, 1].map(|input| self.controller.proportional.axis(input));
                    (format!("{gains:?}"), "the springs")
                }
                _ => (format!("{:?}", error.value), "a spring"),
            };
            let problem =
                format!("with `{key}` = {value}, {noun} of V, V is not positive away from rest");
            return Conflict::new(key, problem, remedy);
        }
        Conflict::beyond(self.scalar, (key, error))
    }
}

fn numbers(count: usize) -> String {
    if count == 1 { "one number".to_owned() } else { format!("{count} numbers") }
}
