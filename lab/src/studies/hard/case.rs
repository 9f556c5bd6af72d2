//! A hard case and what came of it.

use std::fmt;

use lyapunov::stabilizers::NoStabilizer;
use serde::{Serialize, Serializer};

use super::naive::Naive;
use super::tally::{Tally, larger};
use super::trial::{HardError, OwnStabilizer, Runs, Trial};
use crate::simulate::AnyStabilizer;
use crate::simulate::family::{StabilizerName, lacks_damping};

/// One hard case: what makes it hard, what is measured, and the bound that is promised.
pub struct Case {
    /// What it is called.
    pub name: &'static str,
    /// What it is about.
    pub theme: &'static str,
    /// What makes it hard.
    pub hard: &'static str,
    pub(super) quantity: Quantity,
    /// What is measured may not be more, in the quantity's unit.
    pub bound: f64,
    /// Why scalars are left out or may differ, if any are.
    pub apart: Option<&'static str>,
    pub(super) trial: Box<dyn Trial>,
}

impl fmt::Debug for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Case").field("name", &self.name).finish_non_exhaustive()
    }
}

/// What is measured of a run.
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

/// What came of a case: a row of `hard.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The case.
    pub case: &'static str,
    /// What it is about.
    pub theme: &'static str,
    /// What makes it hard.
    pub hard: &'static str,
    /// What was measured.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// What was promised: no more than this.
    pub bound: f64,
    /// What was measured with our stabilizer: the worst over all scalars and runs.
    #[serde(serialize_with = "finite_or_null")]
    pub measured: f64,
    /// Whether the bound is a promise of this stabilizer.
    pub promised: bool,
    /// Whether all that is promised held.
    pub passed: bool,
    /// What the naive one came to; none where it cannot be told.
    pub naive: Option<Outcome>,
    /// What came of no stabilizer at all.
    pub without: Option<Outcome>,
    /// The law that was broken, in the words of the shipped laws.
    pub broken: Option<String>,
    /// The largest force, N.
    #[serde(serialize_with = "finite_or_null")]
    pub largest_force_n: f64,
    /// By how much the account was off, as a share of what is allowed.
    #[serde(serialize_with = "finite_or_null")]
    pub ledger_off: f64,
    /// Whether each kind of number kept the bound; none where it takes no part.
    pub verdict: Verdicts,
    /// Whether every lane did what its own scalar run did, bit for bit; none where no lanes ran.
    pub lanes_equal: Option<bool>,
    /// Why scalars are left out or may differ.
    pub apart: Option<&'static str>,
    /// The scene, if it is one.
    pub scene: Option<String>,
}

impl Row {
    /// What came of it in a word.
    pub(super) fn verdict(&self) -> &'static str {
        match (self.passed, self.measured <= self.bound) {
            (true, true) => "pass",
            (true, false) => "over",
            (false, _) => "FAIL",
        }
    }
}

/// Whether each kind of number kept the bound.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Verdicts {
    f64: Option<bool>,
    f32: Option<bool>,
    f64_lanes: Option<bool>,
    f32_lanes: Option<bool>,
}

impl Verdicts {
    /// Whether all that take part kept the bound, and so agree.
    fn kept(&self) -> bool {
        [self.f64, self.f32, self.f64_lanes, self.f32_lanes].into_iter().flatten().all(|kept| kept)
    }
}

/// What another stabilizer came to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// What was measured.
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
    /// Runs it with our stabilizer, with the naive one and with none.
    ///
    /// # Errors
    /// A case that is not written right.
    pub fn row(&self) -> Result<Row, HardError> {
        let runs = self.trial.ours()?;
        let naive = self.trial.naive()?.map(|tally| self.outcome(&tally));
        let without = self.without()?;
        Ok(self.judged(&runs, true, naive, without))
    }

    /// Runs it with `member` in the place of our stabilizer, in `f64` and `f32`; none where it takes no part.
    ///
    /// # Errors
    /// A case that is not written right.
    pub fn row_of(&self, member: StabilizerName) -> Result<Option<Row>, HardError> {
        let runs = match self.trial.under(member) {
            // In a loop that lacks what it is set by it takes no part.
            Err(HardError::Parameter(error)) if lacks_damping(&error) => return Ok(None),
            runs => runs?,
        };
        let Some(runs) = runs else { return Ok(None) };
        let naive = self.trial.naive()?.map(|tally| self.outcome(&tally));
        let without = self.without()?;
        Ok(Some(self.judged(&runs, self.trial.promised_by(member)?, naive, without)))
    }

    fn without(&self) -> Result<Option<Outcome>, HardError> {
        let nothing = || AnyStabilizer::new(NoStabilizer);
        Ok(self.trial.with(&nothing)?.map(|tally| self.outcome(&tally)))
    }

    /// Runs it in `f64` with a stabilizer of one's own, made anew for every run; none where the case is about
    /// something else than one value at a time.
    ///
    /// What it breaks is told in the words of the shipped [`laws`](lyapunov::laws).
    ///
    /// # Errors
    /// A case that is not written right.
    pub fn with(&self, own: OwnStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        self.trial.with(own)
    }

    /// The naive implementation of the paper's steps in this case.
    ///
    /// # Errors
    /// A case that is not written right.
    pub fn naive(&self) -> Result<Option<Tally>, HardError> {
        self.with(&|| AnyStabilizer::new(Naive::<f64>::default()))
    }

    fn outcome(&self, tally: &Tally) -> Outcome {
        let measured = (self.quantity.of)(tally);
        let in_range = tally.not_finite.is_none() && tally.out_of_range.is_none();
        let kept = in_range && measured <= self.bound;
        Outcome { measured, not_finite_from: tally.not_finite, kept }
    }

    fn judged(
        &self,
        runs: &Runs,
        promised: bool,
        naive: Option<Outcome>,
        without: Option<Outcome>,
    ) -> Row {
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
        Row {
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
        }
    }
}
