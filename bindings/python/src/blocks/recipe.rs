//! Recipe of a stabilizer: its name, its numbers and its candidate, from which it is made, and made again.

use std::sync::Arc;

use lyapunov::stabilizers::{
    EnergyBounding, ForceBound, ForceBounding, LeastNorm, Member, NoStabilizer, SlopeBound,
    StabilizerExt, Tank, TankLimits, WindowedCredit,
};
use lyapunov::{DampingLimit, Dissipation, Lolc, ParameterError, Popc, PortEnergy, Scalar};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{Candidate, Raised};
use crate::errors;
use crate::number;

/// A number that a stabilizer is made of: its name, its unit, and what it is where it is left out.
struct Number(&'static str, &'static str, Option<f64>);

/// A number without a default.
const fn needed(name: &'static str, unit: &'static str) -> Number {
    Number(name, unit, None)
}

/// The largest damping.
const LIMIT: Number = needed("limit", "N·s/m");

/// A number of ticks.
const TICKS: Number = needed("ticks", "whole ticks");

/// The damping of the device.
const DAMPING: Number = needed("damping", "N·s/m");

/// The stabilizers of one port, under the names of docs/family.md, and their numbers in SI units.
const FAMILY: [(&str, &[Number]); 15] = [
    ("none", &[]),
    ("popc", &[LIMIT]),
    ("lolc", &[LIMIT]),
    ("popc-bounded", &[LIMIT, needed("credit", "J")]),
    ("popc-windowed", &[LIMIT, TICKS]),
    ("popc-threshold", &[LIMIT, needed("velocity", "m/s")]),
    ("popc-spread", &[LIMIT, TICKS]),
    ("popc-rate-limited", &[LIMIT, needed("rate", "N/s")]),
    ("popc-rising", &[LIMIT, TICKS]),
    ("force-bound", &[DAMPING]),
    (
        "tank",
        &[
            needed("start", "J"),
            Number("floor", "J", Some(0.0)),
            Number("ceiling", "J", Some(f64::INFINITY)),
            Number("power", "W", Some(f64::INFINITY)),
        ],
    ),
    ("energy-bounding", &[needed("c1", "N/m"), needed("c2", "N/m")]),
    ("force-bounding", &[DAMPING]),
    ("least-norm", &[LIMIT, needed("decay", "1/tick")]),
    ("slope-bound", &[needed("slope", "N/m")]),
];

/// Recipe of a stabilizer.
#[derive(Debug)]
pub(crate) struct Recipe {
    pub(crate) name: &'static str,
    pub(crate) numbers: Vec<f64>,
    /// The damping that a candidate credits.
    pub(crate) damping: Option<f64>,
    /// A candidate written in Python. What is made of the recipe shares this reference, so that the garbage collector counts
    /// one.
    pub(crate) object: Option<Arc<Py<PyAny>>>,
}

impl Recipe {
    /// The recipe that the arguments of a call tell.
    pub(crate) fn of(name: &str, given: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let found = FAMILY.iter().find(|(known, _)| *known == name);
        let (name, keys) = found.ok_or_else(|| {
            let names: Vec<&str> = FAMILY.iter().map(|(name, _)| *name).collect();
            errors::input(format!(
                "no block is called `{name}`\n  = the names are: {}\n  = every other name of docs/family.md runs in \
                 scenes: lyapunov.run, compare and map",
                names.join(", ")
            ))
        })?;
        let taken = |key: &str| -> PyResult<Option<Bound<'_, PyAny>>> {
            let value = given.map(|given| given.get_item(key)).transpose()?.flatten();
            Ok(value.filter(|value| !value.is_none()))
        };
        let (mut numbers, mut missing) = (Vec::new(), Vec::new());
        for Number(key, unit, default) in *keys {
            let value = taken(key)?.map(|value| number(&value, key)).transpose()?;
            match value.or(*default) {
                Some(value) => numbers.push(value),
                None => missing.push((*key, *unit)),
            }
        }
        let mut known: Vec<&str> = keys.iter().map(|key| key.0).collect();
        let (mut damping, mut object) = (None, None);
        if *name == "lolc" {
            known.extend(["damping", "candidate"]);
            damping = taken("damping")?.map(|value| number(&value, "damping")).transpose()?;
            object = taken("candidate")?.map(Candidate::checked).transpose()?.map(Arc::new);
        }
        let given = given.into_iter().flat_map(|given| given.keys());
        let given: Vec<String> = given.map(|key| key.extract()).collect::<PyResult<_>>()?;
        only(name, &given, &known)?;
        if *name == "lolc" && damping.is_none() && object.is_none() {
            missing.push(("damping", "N·s/m, or candidate=… with a method decrease(sample)"));
        }
        complete(name, &missing)?;
        if damping.is_some() && object.is_some() {
            return Err(errors::input(
                "`lolc` takes damping or candidate, one of the two\n  = give the damping that the device surely has, \
                 in N·s/m, or an object with a method decrease(sample)",
            ));
        }
        Ok(Self { name, numbers, damping, object })
    }

    /// The recipe of one that observes the port's energy and may inject nothing.
    pub(crate) fn observing() -> Self {
        Self { name: "popc", numbers: vec![0.0], damping: None, object: None }
    }

    /// The candidate that credits `damping`, or that `object` tells.
    pub(crate) fn candidate(
        damping: Option<f64>,
        object: Option<Arc<Py<PyAny>>>,
        raised: &Raised,
    ) -> PyResult<Candidate> {
        match (damping, object) {
            (Some(_), Some(_)) => Err(errors::input(
                "damping and candidate exclude each other\n  = let the candidate credit the damping",
            )),
            (None, Some(object)) => Ok(Candidate::Python { object, raised: raised.clone() }),
            (damping, None) => Dissipation::of(damping.unwrap_or(0.0))
                .map(|damper| Candidate::Damped((PortEnergy, damper)))
                .map_err(errors::parameter),
        }
    }

    /// A copy.
    pub(crate) fn again(&self, py: Python<'_>) -> Self {
        let object = self.object.as_ref().map(|object| Arc::new(object.clone_ref(py)));
        Self { name: self.name, numbers: self.numbers.clone(), damping: self.damping, object }
    }

    /// The arguments by name that make the same.
    pub(crate) fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let arguments = PyDict::new(py);
        let keys = FAMILY.iter().find(|(name, _)| *name == self.name).map_or(&[][..], |it| it.1);
        for (key, number) in keys.iter().zip(&self.numbers) {
            arguments.set_item(key.0, number)?;
        }
        if let Some(damping) = self.damping {
            arguments.set_item("damping", damping)?;
        }
        if let Some(object) = &self.object {
            arguments.set_item("candidate", &**object)?;
        }
        Ok(arguments)
    }

    /// The stabilizer, on any signal: in lanes every lane has the same numbers.
    pub(crate) fn make<V: lyapunov::Signal, C>(
        &self,
        candidate: impl FnOnce() -> Result<C, ParameterError>,
    ) -> Result<Member<V, C>, ParameterError> {
        let of = |index: usize| <V::Scalar as Scalar>::of(self.numbers[index]);
        let whole = |index: usize| self.numbers[index] as u32;
        let limit = || DampingLimit::at(of(0));
        let popc = || limit().map(|limit| Popc::new(PortEnergy, limit));
        Ok(match self.name {
            "popc" => Member::Popc(popc()?),
            "lolc" => Member::Lolc(Lolc::new(candidate()?, limit()?)),
            "popc-bounded" => Member::Bounded(popc()?.bounded(of(1))?),
            "popc-windowed" => {
                Member::Windowed(popc()?.summed_by(WindowedCredit::of_ticks(whole(1))?))
            }
            "popc-threshold" => Member::Threshold(popc()?.above_velocity(of(1))?),
            "popc-spread" => Member::Spread(popc()?.spread_over(whole(1))?),
            "popc-rate-limited" => Member::RateLimited(popc()?.rate_limited(of(1))?),
            "popc-rising" => Member::Rising(popc()?.rising_over(whole(1))?),
            "force-bound" => Member::ForceBound(ForceBound::new(of(0))?),
            "tank" => {
                let store = TankLimits { start: of(0), floor: of(1), ceiling: of(2), power: of(3) };
                Member::Tank(Tank::new(PortEnergy, store)?)
            }
            "energy-bounding" => Member::EnergyBounding(EnergyBounding::new(of(0), of(1))?),
            "force-bounding" => Member::ForceBounding(ForceBounding::of_damping(of(0))?),
            "least-norm" => Member::LeastNorm(LeastNorm::new(PortEnergy, limit()?, of(1))?),
            "slope-bound" => Member::SlopeBound(SlopeBound::new(of(0))?),
            _ => Member::NoStabilizer(NoStabilizer),
        })
    }
}

/// Refuses names of numbers that are not `known`.
fn only(name: &str, given: &[String], known: &[&str]) -> PyResult<()> {
    let unknown: Vec<&str> =
        given.iter().map(String::as_str).filter(|key| !known.contains(key)).collect();
    if !unknown.is_empty() {
        return Err(errors::input(format!(
            "`{name}` has no {}\n  = it takes: {}",
            unknown.join(", "),
            if known.is_empty() { "nothing".to_owned() } else { known.join(", ") }
        )));
    }
    Ok(())
}

/// Refuses a call without the numbers that are `missing`, each with its unit.
fn complete(name: &str, missing: &[(&str, &str)]) -> PyResult<()> {
    if !missing.is_empty() {
        let told =
            |it: fn(&(&str, &str)) -> String| missing.iter().map(it).collect::<Vec<_>>().join(", ");
        return Err(errors::input(format!(
            "`{name}` needs {}\n  = give by name: {}",
            told(|(key, _)| (*key).to_owned()),
            told(|(key, unit)| format!("{key}=… in {unit}"))
        )));
    }
    Ok(())
}

/// A number; whole and above 0 where it counts ticks.
fn number(value: &Bound<'_, PyAny>, key: &str) -> PyResult<f64> {
    let number = number::number(value, key)?;
    let is_count = number.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(&number);
    match key == "ticks" && !is_count {
        true => Err(errors::input(format!(
            "ticks is {number:?}; it must be a whole number from 1 to {}",
            u32::MAX
        ))),
        false => Ok(number),
    }
}
