//! The rules between the values of a scene.

use std::fmt;

use lyapunov::{ParameterError, Requirement};
use serde::Serialize;

use super::{Draft, Integrator, Motion, Positive, Scalar, Scene};

/// The most ticks of one run.
const MOST_TICKS: f64 = 1e9;

/// The largest allowed distance of servo_rate / environment_rate from a whole number.
const RATIO_TOLERANCE: f64 = 1e-9;

/// A conflict between values of a scene that are each allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    key: String,
    problem: String,
    remedy: String,
    asker: Option<&'static str>,
}

/// Part of a loop that cannot be built: the key to change, and why.
pub(crate) type Refused = (&'static str, ParameterError);

impl Conflict {
    /// The conflict of a loop that leaves the range of `scalar` in this part.
    pub(crate) fn beyond(scalar: Scalar, (key, error): Refused) -> Self {
        let problem = format!("the loop is beyond the range of {}", scalar.name());
        Self::new(key, problem, format!("{error}: give values nearer to 1"))
    }

    pub(crate) fn new(
        key: impl Into<String>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self { key: key.into(), problem: problem.into(), remedy: remedy.into(), asker: None }
    }

    /// The same conflict, caused by the key `asker`, whose place is shown if the key at fault is absent.
    pub(super) fn asked_by(self, asker: &'static str) -> Self {
        Self { asker: Some(asker), ..self }
    }

    /// The key that causes the conflict; see [`Conflict::asked_by`].
    pub(super) fn asker(&self) -> Option<&'static str> {
        self.asker
    }

    /// The key to change, with its table path.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The problem in words.
    pub fn problem(&self) -> &str {
        &self.problem
    }

    /// The remedy in words.
    pub fn remedy(&self) -> &str {
        &self.remedy
    }
}

impl fmt::Display for Conflict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.problem, self.remedy)
    }
}

impl std::error::Error for Conflict {}

impl Draft {
    /// The scene, if it keeps the rules between values; those of the loop's blocks are checked when the loop is built.
    ///
    /// # Errors
    /// The first broken rule, with its key.
    pub(crate) fn by_rules(self) -> Result<Scene, Conflict> {
        check_ticks(self.duration, self.servo_rate)?;
        self.check_environment_rate()?;
        self.check_tables()?;
        self.check_scalar()?;
        self.check_signal()?;
        Ok(Scene(self))
    }

    fn check_environment_rate(&self) -> Result<(), Conflict> {
        let (servo, rate) = (self.servo_rate.get(), self.environment_rate());
        let ratio = servo / rate;
        let whole = ratio.round();
        let tolerance = RATIO_TOLERANCE.max(f64::EPSILON * ratio);
        if ratio.is_finite() && whole >= 1.0 && (ratio - whole).abs() <= tolerance {
            return Ok(());
        }
        let remedy = if ratio < 1.0 {
            format!("it can be at most the servo rate, {servo:?} Hz")
        } else if ratio.is_finite() {
            let (fewer, more) = (ratio.floor(), ratio.ceil());
            format!(
                "the nearest rates that do are {:?} Hz (ratio {fewer}) and {:?} Hz (ratio {more})",
                servo / fewer,
                servo / more
            )
        } else {
            format!("give a rate in Hz, for example `environment_rate = {servo:?}`")
        };
        Err(Conflict {
            key: "environment_rate".to_owned(),
            problem: format!(
                "`environment_rate` = {rate:?} Hz does not divide `servo_rate` = {servo:?} Hz"
            ),
            remedy: format!(
                "servo_rate / environment_rate is {ratio:?}, not a whole number of 1 or more; {remedy}"
            ),
            asker: None,
        })
    }

    fn check_scalar(&self) -> Result<(), Conflict> {
        if self.scalar != Scalar::F32 {
            return Ok(());
        }
        check_single(self)?;
        self.lost_rest().map_or(Ok(()), |(key, value)| Err(lost(key, value)))
    }

    /// Checks that this program has the loop of the scalar.
    #[cfg(feature = "every-scalar")]
    fn check_signal(&self) -> Result<(), Conflict> {
        Ok(())
    }

    #[cfg(not(feature = "every-scalar"))]
    fn check_signal(&self) -> Result<(), Conflict> {
        if self.scalar == Scalar::F32 {
            let problem = "this program computes in f64 only";
            let remedy = "run it with the command `lyapunov`";
            return Err(Conflict::new("scalar", problem, remedy));
        }
        Ok(())
    }

    /// The conflict for a parameter that a block of the loop rejected.
    pub(crate) fn out_of_range(&self, error: &ParameterError, scalar: &str) -> Conflict {
        if let Some(conflict) = self.refused_part(error, scalar) {
            return conflict;
        }
        let (operator, device) = (&self.operator, &self.device);
        let mass = ("device.mass", device.mass.get());
        let damping = ("device.damping", device.damping.get());
        let theirs = [
            ("operator.mass", operator.mass.get()),
            ("operator.damping", operator.damping.get()),
            ("operator.stiffness", operator.stiffness.get()),
        ];
        let rate = ("servo_rate", self.servo_rate.get());
        let sum = |one: &str, other: &str| {
            format!("`{one}` and `{other}` together are beyond the range of {scalar}")
        };
        let (keys, problem) = match (error.parameter, error.requirement) {
            ("mass" | "device mass", Requirement::InRange) => {
                let mut keys = vec![mass, damping, theirs[0], theirs[1], theirs[2], rate];
                keys.extend(self.further_parts());
                (keys, format!("the motion within one period is beyond the range of {scalar}"))
            }
            ("mass", _) => (vec![mass, theirs[0]], sum(theirs[0].0, mass.0)),
            ("damping", _) => (vec![damping, theirs[1]], sum(theirs[1].0, damping.0)),
            ("period", _) => (vec![rate], format!("`servo_rate` gives no period within {scalar}")),
            _ => match self.refused(error, scalar) {
                Some(conflict) => return conflict,
                None => (vec![rate], error.to_string()),
            },
        };
        let (key, value) = standing_out(keys).unwrap_or(rate);
        let remedy = format!("`{key}` = {value:?} stands out; give a value nearer to 1");
        Conflict::new(key, problem, remedy)
    }

    /// The conflict of a parameter that one part of the scene decides.
    fn refused_part(&self, error: &ParameterError, scalar: &str) -> Option<Conflict> {
        let value = error.value;
        Some(match (error.parameter, error.requirement) {
            (key @ "device.damping", Requirement::Positive) => {
                let name = self.stabilizer.map_or("", |it| it.name());
                Conflict::new(
                    key,
                    format!(
                        "`stabilizer.{name}` relies on a damping of the device, and `{key}` is {value:?} N.s/m"
                    ),
                    format!(
                        "give the damping that the device surely has, or write the numbers of [stabilizer.{name}]"
                    ),
                )
            }
            (key, _) if key.starts_with("stabilizer.") => Conflict::new(
                key,
                format!("`{key}` has no default on this loop"),
                "write it in that table",
            ),
            ("period", Requirement::InRange) if self.integrator != Integrator::Exact => {
                self.integrator.overtaxed(scalar)
            }
            (key @ "tolerance", Requirement::AtLeast(least)) => Conflict::new(
                key,
                format!("`{key}` = {value:?} is less than rounding in {scalar} lets a step keep"),
                format!("give {least:?} or more"),
            ),
            ("t" | "value", _) => Conflict::new(
                "operator.motion.path",
                format!(
                    "two rows of the motion are so far apart that it leaves the range of {scalar}"
                ),
                "give times in s and places in m",
            ),
            _ => return None,
        })
    }

    /// The values of link and grip that also enter the motion within one period.
    fn further_parts(&self) -> Vec<(&'static str, f64)> {
        let link = self.link.iter().flat_map(|link| {
            [("link.stiffness", link.stiffness.get()), ("link.damping", link.damping.get())]
        });
        let grip = self.operator.grip.iter().flat_map(|grip| {
            let stiffness = grip.stiffness.iter().map(|it| ("operator.grip.stiffness", it.get()));
            stiffness.chain(grip.damping.iter().map(|it| ("operator.grip.damping", it.get())))
        });
        link.chain(grip).collect()
    }

    /// The conflict of a number that a block rejected, where the scene has it or the requirement has a number of its own.
    fn refused(&self, error: &ParameterError, scalar: &str) -> Option<Conflict> {
        let requirement = error.requirement;
        let conflict = match (self.holder(error), requirement) {
            (Some((key, value)), Requirement::InRange) => Conflict::new(
                &key,
                format!("`{key}` = {value:?} takes the loop beyond the range of {scalar}"),
                "give a value nearer to 1",
            ),
            (Some((key, value)), _) => Conflict::new(
                &key,
                error.to_string(),
                format!("`{key}` = {value:?} is that number; it must be {requirement}"),
            ),
            (None, Requirement::AtMost(_) | Requirement::AtLeast(_)) => Conflict::new(
                format!("stabilizer.{}", self.stabilizer?.name()),
                error.to_string(),
                "change the numbers of the scene that it follows from",
            ),
            (None, _) => return None,
        };
        Some(conflict)
    }

    /// The key of the value that a block rejected, and the value there.
    fn holder(&self, error: &ParameterError) -> Option<(String, f64)> {
        let single = self.scalar == Scalar::F32;
        let scene = toml::Value::try_from(self).ok()?;
        find(&scene, "", &|key, value| {
            let held = if single { f64::from(value as f32) } else { value };
            is_named(key, error.parameter) && held == error.value
        })
    }

    /// The first position of a recorded motion that single precision cannot hold.
    fn lost_rest(&self) -> Option<(String, f64)> {
        let Some(Motion::File { samples, .. }) = &self.operator.motion else {
            return None;
        };
        let lost = samples.iter().find(|(_, rest)| (*rest as f32).is_infinite());
        lost.map(|(_, rest)| ("operator.motion.path".to_owned(), *rest))
    }
}

/// Checks that a run has no more ticks than allowed and that its period is finite.
pub(crate) fn check_ticks(duration: Positive, servo_rate: Positive) -> Result<(), Conflict> {
    let (duration, rate) = (duration.get(), servo_rate.get());
    if !rate.recip().is_finite() {
        return Err(Conflict::new(
            "servo_rate",
            format!(
                "`servo_rate` = {rate:?} Hz is too small: its period 1 / servo_rate is infinite"
            ),
            "give a rate in Hz, for example `servo_rate = 1000.0`",
        ));
    }
    let ticks = (duration * rate).round();
    if ticks <= MOST_TICKS {
        return Ok(());
    }
    Err(Conflict::new(
        "duration",
        format!("`duration` = {duration:?} s at `servo_rate` = {rate:?} Hz makes {ticks:e} ticks"),
        format!("a run has at most 1e9 ticks: at this rate at most {:?} s", MOST_TICKS / rate),
    ))
}

/// Checks that single precision can hold every number of `file`.
pub(crate) fn check_single(file: &impl Serialize) -> Result<(), Conflict> {
    // Walking the serialized form covers every number, including those of tables added later.
    let found = toml::Value::try_from(file).ok().and_then(|file| {
        find(&file, "", &|_, number| {
            let single = number as f32;
            number.is_finite() && (single.is_infinite() || (single == 0.0) != (number == 0.0))
        })
    });
    found.map_or(Ok(()), |(key, value)| Err(lost(key, value)))
}

/// The conflict of a number that single precision cannot hold.
fn lost(key: String, value: f64) -> Conflict {
    Conflict::new(
        &key,
        format!("`{key}` = {value:?} is beyond the range of f32"),
        "f32 holds sizes from 1e-45 to 3.4e38; take `scalar = \"f64\"` or another value",
    )
}

/// The value of the most unusual size, where any of the values may be wrong.
pub(crate) fn standing_out(keys: Vec<(&str, f64)>) -> Option<(&str, f64)> {
    let odd = |value: f64| if value > 0.0 { value.log10().abs() } else { 0.0 };
    keys.into_iter().max_by(|one, other| odd(one.1).total_cmp(&odd(other.1)))
}

/// Whether a block's name for a parameter, words such as `encoder resolution`, ends with the last part of `key`.
fn is_named(key: &str, parameter: &str) -> bool {
    let last = key.rsplit('.').next().unwrap_or(key).replace('_', " ");
    parameter.strip_suffix(&last).is_some_and(|before| before.is_empty() || before.ends_with(' '))
}

/// The first number of a serialized scene for which `is` holds, given its key; with its table path.
fn find(value: &toml::Value, path: &str, is: &dyn Fn(&str, f64) -> bool) -> Option<(String, f64)> {
    match value {
        toml::Value::Float(number) => is(path, *number).then(|| (path.to_owned(), *number)),
        toml::Value::Array(list) => list.iter().find_map(|value| find(value, path, is)),
        toml::Value::Table(table) => table.iter().find_map(|(key, value)| {
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            find(value, &path, is)
        }),
        _ => None,
    }
}
