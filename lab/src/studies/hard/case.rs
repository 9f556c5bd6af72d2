//! A hard case and its result.

use std::fmt;

use lyapunov::stabilizers::NoStabilizer;
use serde::{Serialize, Serializer};

use super::tally::{Tally, larger};
use super::trial::{HardError, MakeStabilizer, Runs, Trial};
use crate::simulate::AnyStabilizer;
use crate::simulate::family::StabilizerName;

/// One hard case: the difficulty, the measured quantity and the promised bound.
pub struct Case {
    /// Its name.
    pub name: &'static str,
    /// Its theme.
    pub theme: &'static str,
    /// The difficulty.
    pub hard: &'static str,
    pub(super) quantity: Quantity,
    /// The largest value allowed, in the quantity's unit.
    pub bound: f64,
    /// The reason why scalars are left out or may differ, if any are.
    pub apart: Option<&'static str>,
    pub(super) trial: Box<dyn Trial>,
}

impl fmt::Debug for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Case").field("name", &self.name).finish_non_exhaustive()
    }
}

/// The quantity that a case measures.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity {
    pub(super) words: &'static str,
    pub(super) unit: &'static str,
    pub(super) of: fn(&Tally) -> f64,
}

impl Quantity {
    pub(super) const LATE_SWING: Self =
        Self { words: "late swing", unit: "mm", of: |tally| 1e3 * tally.late_swing };
    pub(super) const SWING: Self =
        Self { words: "largest swing", unit: "mm", of: |tally| 1e3 * tally.swing };
    pub(super) const ACTING: Self =
        Self { words: "largest acting force", unit: "N", of: |tally| tally.acting };
    pub(super) const GIVEN: Self =
        Self { words: "energy given out", unit: "mJ", of: |tally| 1e3 * tally.given };
    pub(super) const CORRECTION: Self =
        Self { words: "correction / limit", unit: "", of: |tally| tally.correction };

    pub(super) const fn own(words: &'static str, unit: &'static str) -> Self {
        Self { words, unit, of: |tally| tally.value }
    }
}

/// The result of a case: a row of `hard.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The case.
    pub case: &'static str,
    /// Its theme.
    pub theme: &'static str,
    /// The difficulty.
    pub hard: &'static str,
    /// The measured quantity.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The promised bound: the largest value allowed.
    pub bound: f64,
    /// The value measured with our stabilizer: the worst over all scalars and runs.
    #[serde(serialize_with = "finite_or_null")]
    pub measured: f64,
    /// Whether the bound is a promise of this stabilizer.
    pub promised: bool,
    /// Whether every promise was kept.
    pub passed: bool,
    /// The result of the naive stabilizer; none where it takes no part.
    pub naive: Option<Outcome>,
    /// The result without a stabilizer.
    pub without: Option<Outcome>,
    /// The law that was broken, in the words of the shipped laws.
    pub broken: Option<String>,
    /// The largest force, N.
    #[serde(serialize_with = "finite_or_null")]
    pub largest_force_n: f64,
    /// The largest error of the ledger, as a share of what is allowed.
    #[serde(serialize_with = "finite_or_null")]
    pub ledger_off: f64,
    /// Verdict of each kind of number; none where it takes no part.
    pub verdict: Verdicts,
    /// Whether every lane equals its own scalar run, bit for bit; none where no lanes ran.
    pub lanes_equal: Option<bool>,
    /// The reason why scalars are left out or may differ.
    pub apart: Option<&'static str>,
    /// The scene's text, if the case is a scene.
    pub scene: Option<String>,
}

impl Row {
    /// The verdict in a word.
    pub(super) fn verdict(&self) -> &'static str {
        match (self.passed, self.measured <= self.bound) {
            (true, true) => "pass",
            (true, false) => "over",
            (false, _) => "FAIL",
        }
    }
}

/// Verdict of each kind of number: whether it kept the bound.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Verdicts {
    f64: Option<bool>,
    f32: Option<bool>,
    f64_lanes: Option<bool>,
    f32_lanes: Option<bool>,
}

impl Verdicts {
    /// Whether every kind that takes part kept the bound.
    fn kept(&self) -> bool {
        [self.f64, self.f32, self.f64_lanes, self.f32_lanes].into_iter().flatten().all(|kept| kept)
    }
}

/// The result of another stabilizer.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// The measured value.
    #[serde(serialize_with = "finite_or_null")]
    pub measured: f64,
    /// The first tick on which a force was not finite.
    pub not_finite_from: Option<u64>,
    /// Whether the bound was kept.
    pub kept: bool,
}

fn finite_or_null<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    number.is_finite().then_some(*number).serialize(serializer)
}

impl Case {
    /// The result with our stabilizer, with the naive one and with none.
    ///
    /// # Errors
    /// A case that is not well-formed.
    pub fn row(&self) -> Result<Row, HardError> {
        self.judged(&self.trial.ours()?, true)
    }

    /// The result with `member` instead of our stabilizer, in `f64` and `f32`; none where it takes no part.
    ///
    /// # Errors
    /// A case that is not well-formed.
    pub fn row_of(&self, member: StabilizerName) -> Result<Option<Row>, HardError> {
        match self.trial.under(member) {
            Err(HardError::NoPart) => Ok(None),
            runs => self.judged(&runs?, self.trial.promised_by(member)?).map(Some),
        }
    }

    /// The result in `f64` with your own stabilizer, made anew for every run; none where the case is not about one
    /// value at a time.
    ///
    /// A law that it breaks is named in the words of the shipped [`laws`](lyapunov::laws).
    ///
    /// # Errors
    /// A case that is not well-formed.
    pub fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        self.trial.with(own)
    }

    fn outcome(&self, tally: &Tally) -> Outcome {
        let measured = (self.quantity.of)(tally);
        let in_range = tally.not_finite.is_none() && tally.out_of_range.is_none();
        let kept = in_range && measured <= self.bound;
        Outcome { measured, not_finite_from: tally.not_finite, kept }
    }

    fn judged(&self, runs: &Runs, promised: bool) -> Result<Row, HardError> {
        let outcome = |tally: Tally| self.outcome(&tally);
        let without = self.trial.with(&|| AnyStabilizer::new(NoStabilizer))?.map(outcome);
        let naive = self.trial.naive()?.map(outcome);
        let worst = |of: &dyn Fn(&Tally) -> f64| runs.all().map(of).fold(0.0, larger);
        let measured = worst(&|tally| (self.quantity.of)(tally));
        let kept = |tallies: &[Tally]| {
            let kept = |tally: &Tally| self.outcome(tally).kept;
            (!tallies.is_empty()).then(|| tallies.iter().all(kept))
        };
        let verdict = Verdicts {
            f64: kept(&runs.double),
            f32: kept(&runs.single),
            f64_lanes: kept(&runs.double_lanes),
            f32_lanes: kept(&runs.single_lanes),
        };
        let lanes_equal = runs.lanes_equal();
        let broken = runs.all().find_map(|tally| tally.broken);
        Ok(Row {
            case: self.name,
            theme: self.theme,
            hard: self.hard,
            quantity: self.quantity.words,
            unit: self.quantity.unit,
            bound: self.bound,
            measured,
            promised,
            passed: (verdict.kept() || !promised) && broken.is_none() && lanes_equal != Some(false),
            naive,
            without,
            broken: broken.map(|(law, tick)| format!("tick {tick}: {law}")),
            largest_force_n: worst(&|tally| tally.peak_force.max(tally.acting)),
            ledger_off: worst(&|tally| tally.off),
            verdict,
            lanes_equal,
            apart: self.apart,
            scene: self.trial.scene().map(str::to_owned),
        })
    }
}
