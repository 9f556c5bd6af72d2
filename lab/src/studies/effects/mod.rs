//! Cost of each effect: the time of a step of a loop with it, minus that of the loop without.

mod calls;
mod picture;
mod report;
mod table;
mod timing;

use std::fmt;
use std::ops::ControlFlow;

use lyapunov::{ParameterError, Scalar};
use serde::Serialize;

use crate::files::Scene;
use crate::files::scene::{Conflict, Diagnostic};
use crate::measure::timing::Rounds;
use crate::show::json;
use crate::simulate::{F64x8, Instructions};
use calls::{BARE, Calls, Effect};

/// The costs of all effects, in nanoseconds per step on this machine; docs/effects/costs.md explains how to read
/// them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Costs {
    /// The scene whose effects these are; none for all effects on a loop of the study's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<String>,
    /// The keys that come from a clock.
    not_deterministic: [&'static str; 4],
    /// Rounds over all loops.
    rounds: usize,
    /// Ticks of a run.
    ticks: usize,
    scalars: Vec<Column>,
}

/// The costs for one kind of number; on lanes those of effects on a line only, as nothing runs a space on lanes.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Column {
    scalar: &'static str,
    /// The rollouts that one step advances.
    rollouts: usize,
    /// The set of vector instructions.
    instructions: &'static str,
    bare_ns_per_step: f64,
    effects: Vec<Cost>,
}

/// The cost of one effect.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Cost {
    effect: &'static str,
    /// The cost in a loop without any other effect.
    alone: Difference,
    /// The cost in a loop with all others that go with it.
    composed: Difference,
}

/// Loop with an effect against the same loop without it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
struct Difference {
    /// The median over the rounds.
    ns_per_step: f64,
    /// The distance from the lower quartile of the rounds to the upper one.
    spread_ns: f64,
    ratio: f64,
}

impl Costs {
    /// Measures the costs; `watch` is called for every loop that was timed, [`Costs::loops`] in all, and may end the
    /// study.
    ///
    /// # Errors
    /// See [`CostsError`].
    pub fn measured(watch: &dyn Fn() -> ControlFlow<()>) -> Result<Self, CostsError> {
        Self::timed(None, &Calls::new()?, watch)
    }

    /// The same of the effects that `scene` names, which is called `name`, in its own loop: [`Costs::loops_of`] loops.
    ///
    /// # Errors
    /// See [`CostsError`].
    pub fn of(
        name: &str,
        scene: &Scene,
        watch: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, CostsError> {
        Self::timed(Some(name.to_owned()), &Calls::of(scene)?, watch)
    }

    fn timed(
        scene: Option<String>,
        calls: &Calls,
        watch: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, CostsError> {
        let (base, best) = (Instructions::Base, Instructions::best());
        let one = timing::alone(&calls.all, base, watch)?;
        let mut scalars = vec![Column::of(("f64", 1, base), (BARE, &one), calls.effects.iter())];
        let (on_a_line, effects) = calls.on_a_line();
        if !on_a_line.is_empty() {
            let eight = timing::on_lanes(on_a_line, best, watch)?;
            let lanes = ("f64x8", F64x8::LANES, best);
            scalars.push(Column::of(lanes, (BARE, &eight), effects));
        }
        Ok(Self {
            scene,
            not_deterministic: ["bare_ns_per_step", "ns_per_step", "spread_ns", "ratio"],
            rounds: timing::ROUNDS,
            ticks: timing::TICKS,
            scalars,
        })
    }

    /// The number of timed loops.
    ///
    /// # Errors
    /// See [`CostsError`].
    pub fn loops() -> Result<usize, CostsError> {
        Ok(Calls::new()?.rounds())
    }

    /// The number of timed loops for `scene`.
    ///
    /// # Errors
    /// See [`CostsError`].
    pub fn loops_of(scene: &Scene) -> Result<usize, CostsError> {
        Ok(Calls::of(scene)?.rounds())
    }

    /// The costs as JSON.
    pub fn to_json(&self) -> String {
        json::text(self)
    }
}

impl Column {
    /// The costs of `effects` by the `times` of numbers with this name, so many rollouts at once, on these instructions.
    fn of<'a>(
        (scalar, rollouts, instructions): (&'static str, usize, Instructions),
        (bare, times): (usize, &Rounds),
        effects: impl Iterator<Item = &'a Effect>,
    ) -> Self {
        let difference = |[without, with]: [usize; 2]| Difference::of(times, without, with);
        let effects = effects.map(|effect| Cost {
            effect: effect.name,
            alone: difference(effect.alone),
            composed: difference(effect.composed),
        });
        let [_, bare_ns_per_step, _] = times.quartiles(bare);
        let (instructions, effects) = (instructions.name(), effects.collect());
        Self { scalar, rollouts, instructions, bare_ns_per_step, effects }
    }
}

impl Difference {
    fn of(times: &Rounds, without: usize, with: usize) -> Self {
        let [lower, median, upper] = times.compared(with, without, |with, without| with - without);
        let [_, ratio, _] = times.compared(with, without, |with, without| with / without);
        Self { ns_per_step: median, spread_ns: upper - lower, ratio }
    }

    /// Whether it can be told from zero.
    fn is_told(&self) -> bool {
        self.ns_per_step > self.spread_ns.max(0.0)
    }
}

impl fmt::Display for Costs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table::write(self, f)
    }
}

/// Reason why there are no costs.
#[derive(Debug)]
pub enum CostsError {
    /// A scene of the study is wrong.
    Scene(Diagnostic),
    /// The scene without some of its effects is none.
    Without(Conflict),
    /// A part cannot be made.
    Parameter(ParameterError),
    /// `watch` ended the study.
    Stopped,
}

impl fmt::Display for CostsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene(error) => error.fmt(f),
            Self::Without(conflict) => conflict.fmt(f),
            Self::Parameter(error) => error.fmt(f),
            Self::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for CostsError {}

impl From<Conflict> for CostsError {
    fn from(conflict: Conflict) -> Self {
        Self::Without(conflict)
    }
}

impl From<Diagnostic> for CostsError {
    fn from(error: Diagnostic) -> Self {
        Self::Scene(error)
    }
}

impl From<ParameterError> for CostsError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}
