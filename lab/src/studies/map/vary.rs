//! Variation of one number of a scene.

use std::fmt;

use toml::Value;

use super::axis::Axis;
use crate::files::scene::{Scene, is_number, is_whole};
use crate::text::nearest;

/// A number of a scene, found by its dotted key.
#[derive(Clone, Debug)]
pub(super) struct Vary {
    key: String,
    is_whole: bool,
}

/// Reason why an axis does not fit a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct VaryError {
    problem: String,
    remedy: String,
}

impl VaryError {
    pub(super) fn new(problem: String, remedy: impl Into<String>) -> Self {
        Self { problem, remedy: remedy.into() }
    }
}

impl fmt::Display for VaryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n  = {}", self.problem, self.remedy)
    }
}

impl std::error::Error for VaryError {}

impl Vary {
    /// The number that `axis` names in the scene with the TOML tree `tree`.
    pub(super) fn of(axis: &Axis, tree: &Value) -> Result<Self, VaryError> {
        let key = axis.key.as_str();
        let (list, _) = key.split_once('[').unwrap_or((key, ""));
        if let Some(Value::Array(_)) = find(tree, list) {
            let problem = format!("`{list}` is a list");
            return Err(VaryError::new(
                problem,
                "name a key that holds one number: lists cannot be mapped",
            ));
        }
        let is_whole = match find(tree, key) {
            Some(Value::Integer(_)) => true,
            Some(Value::Float(_)) => false,
            Some(_) => {
                let problem = format!("`{key}` is not a number of the scene");
                return Err(VaryError::new(problem, known(tree, key)));
            }
            // A scene may leave out a number with a default.
            None if find(tree, table(key)).is_some() && is_number(key) => is_whole(key),
            // A scene has one environment.
            None if is_number(key) && !key.starts_with("environment.") => {
                let table = table(key);
                let problem = format!("the scene has no table [{table}]");
                let remedy = format!("`{key}` is a number of it: add the table to the scene");
                return Err(VaryError::new(problem, remedy));
            }
            None => {
                let problem = format!("the scene has no number `{key}`");
                return Err(VaryError::new(problem, known(tree, key)));
            }
        };
        Ok(Self { key: key.to_owned(), is_whole })
    }

    /// Replaces the number by `value`.
    pub(super) fn write(&self, tree: &mut Value, value: f64) -> Result<(), VaryError> {
        let number = match self.is_whole {
            false => Value::Float(value),
            // From there on an `f64` steps over whole numbers.
            true if value.abs() >= WHOLE => {
                let problem = format!("`{}` = {value:?} is too large for an axis", self.key);
                let remedy = "choose whole numbers below 2^53; a scene takes larger ones";
                return Err(VaryError::new(problem, remedy));
            }
            true if value.fract() == 0.0 => Value::Integer(value as i64),
            true => {
                let problem = format!("`{}` takes whole numbers only, not {value:?}", self.key);
                let remedy = "choose FROM..TO:N so that every step is whole, as in 0..8:9";
                return Err(VaryError::new(problem, remedy));
            }
        };
        let name = self.key.rsplit('.').next().unwrap_or_default();
        let mut table = table(&self.key).split('.').filter(|_| self.key.contains('.'));
        let place = table.try_fold(tree, |place, part| place.get_mut(part));
        match place {
            Some(Value::Table(table)) => {
                table.insert(name.to_owned(), number);
                Ok(())
            }
            // A number that is not written would be the same in every cell.
            _ => {
                let problem = format!("the scene has no table for `{}`", self.key);
                Err(VaryError::new(problem, "give a number of a table that the scene has"))
            }
        }
    }
}

/// The whole numbers below it are all numbers of an axis.
const WHOLE: f64 = (1u64 << 53) as f64;

/// The most values of an axis that an error proposes.
const PROPOSED: u64 = 32;

/// The error of a `value` of `axis` with which `scene` is none, for this `reason`.
pub(super) fn no_scene(axis: &Axis, value: f64, scene: &Scene, reason: &str) -> VaryError {
    if let Some(rate) = scene.environment_rate.filter(|_| axis.key == "servo_rate") {
        let rate = rate.get();
        if (value / rate - (value / rate).round()).abs() > 1e-6 {
            let problem =
                format!("`servo_rate` = {value:?} is no multiple of `environment_rate` = {rate:?}");
            return VaryError::new(problem, multiples(axis, rate));
        }
    }
    let problem = format!("`{}` = {value:?} is no scene: {reason}", axis.key);
    VaryError::new(problem, "choose a range in which every value is right")
}

/// The remedy with a range like that of `axis` in multiples of `rate`.
fn multiples(axis: &Axis, rate: f64) -> String {
    let alone = "leave environment_rate out: it is servo_rate then";
    let [least, most] = [(axis.from / rate).ceil().max(1.0), (axis.to / rate).floor()];
    let steps = most - least;
    if !(1.0..1e9).contains(&steps) {
        return format!("choose multiples, or {alone}");
    }
    let steps = steps as u64;
    let count = 1 + (1..PROPOSED).rev().find(|fewer| steps.is_multiple_of(*fewer)).unwrap_or(1);
    let [from, to] = [least * rate, most * rate];
    format!("choose multiples, as in servo_rate={from:?}..{to:?}:{count}, or {alone}")
}

fn table(key: &str) -> &str {
    key.rsplit_once('.').map_or("", |(table, _)| table)
}

fn find<'a>(tree: &'a Value, key: &str) -> Option<&'a Value> {
    if key.is_empty() {
        return Some(tree);
    }
    key.split('.').try_fold(tree, |value, part| value.get(part))
}

/// The remedy for an unknown key: the nearest one, or all numbers of the scene.
fn known(tree: &Value, key: &str) -> String {
    let mut keys = Vec::new();
    gather(tree, "", &mut keys);
    let all: Vec<&str> = keys.iter().map(String::as_str).collect();
    match nearest(key, &all) {
        Some(near) => format!("did you mean `{near}`?"),
        None => {
            let rows: Vec<String> = all.chunks(3).map(|keys| keys.join(", ")).collect();
            format!("the numbers of this scene are:\n    {}", rows.join("\n    "))
        }
    }
}

fn gather(value: &Value, path: &str, keys: &mut Vec<String>) {
    match value {
        Value::Float(_) | Value::Integer(_) => keys.push(path.to_owned()),
        Value::Table(table) => table.iter().for_each(|(key, value)| {
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            gather(value, &path, keys);
        }),
        _ => {}
    }
}
