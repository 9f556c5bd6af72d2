//! Columns of the table.

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use super::score::Score;
use crate::show::table::{Cell, Heading};
use crate::simulate::family::Judgement;
use crate::text::nearest;

/// Column of the table; its name is its key in `compare.json`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// The entrant's name.
    Stabilizer,
    /// The verdict on the run.
    Verdict,
    /// Settling time.
    SettlingTime,
    /// Peak force in short contacts.
    ShortPeak,
    /// Peak force in long contacts.
    LongPeak,
    /// Energy that the loop injected.
    EnergyInjected,
    /// Energy that the controller took.
    EnergyTaken,
    /// Largest shortfall.
    Shortfall,
    /// Stiffness felt.
    StiffnessFelt,
    /// Stiffness felt, as a share of the wall's.
    StiffnessPercent,
    /// Force error.
    ForceError,
    /// Chatter.
    Chatter,
    /// Share of active ticks.
    Active,
    /// Time of a step.
    StepTime,
    /// Size of the state.
    StateBytes,
    /// Energy that the port gave.
    EnergyGiven,
    /// Energy that the port gave beyond what it and the device's damper took.
    EnergyBeyondDamper,
    /// Force felt, as a share of the environment's own.
    ForceFelt,
    /// Whether it broke a loop that is bounded alone.
    BrokeIt,
    /// Numbers that judge the entrant.
    JudgedBy,
}

impl Column {
    /// All columns, in the order of the table.
    pub const ALL: [Self; 20] = [
        Self::Stabilizer,
        Self::Verdict,
        Self::SettlingTime,
        Self::ShortPeak,
        Self::LongPeak,
        Self::EnergyInjected,
        Self::EnergyTaken,
        Self::Shortfall,
        Self::StiffnessFelt,
        Self::StiffnessPercent,
        Self::ForceError,
        Self::Chatter,
        Self::Active,
        Self::StepTime,
        Self::StateBytes,
        Self::EnergyGiven,
        Self::EnergyBeyondDamper,
        Self::ForceFelt,
        Self::BrokeIt,
        Self::JudgedBy,
    ];

    /// The key in `compare.json`, unit included.
    pub fn key(self) -> &'static str {
        match self {
            Self::Stabilizer => "stabilizer",
            Self::Verdict => "verdict",
            Self::SettlingTime => "settling_time_s",
            Self::ShortPeak => "peak_force_short_contact_n",
            Self::LongPeak => "peak_force_long_contact_n",
            Self::EnergyInjected => "energy_injected_mj",
            Self::EnergyTaken => "energy_taken_mj",
            Self::Shortfall => "shortfall_mj",
            Self::StiffnessFelt => "stiffness_felt_n_per_m",
            Self::StiffnessPercent => "stiffness_felt_percent",
            Self::ForceError => "force_error_rms_n",
            Self::Chatter => "chatter_rms_n",
            Self::Active => "active_percent",
            Self::StepTime => "ns_per_step",
            Self::StateBytes => "state_bytes",
            Self::EnergyGiven => "energy_given_mj",
            Self::EnergyBeyondDamper => "energy_given_beyond_damper_mj",
            Self::ForceFelt => "force_felt_percent",
            Self::BrokeIt => "broke_it",
            Self::JudgedBy => "judged_by",
        }
    }

    /// Whether it holds words, and not numbers.
    pub fn is_words(self) -> bool {
        matches!(self, Self::Stabilizer | Self::Verdict | Self::BrokeIt | Self::JudgedBy)
    }

    /// The heading as words on an axis, with the unit behind a comma.
    pub fn label(self) -> String {
        let lines = match self {
            Self::StiffnessPercent => "stiffness felt\n% of asked",
            _ => self.lines(),
        };
        let (words, unit) = lines.rsplit_once('\n').unwrap_or((lines, ""));
        let words = words.replace('\n', " ");
        if unit.is_empty() { words } else { format!("{words}, {unit}") }
    }

    /// The heading in the table.
    pub(crate) fn heading(self) -> Heading {
        match self.is_words() {
            true => Heading::word(self.lines()),
            false => Heading::number(self.lines()),
        }
    }

    /// The lines of the heading; the last one is the unit.
    fn lines(self) -> &'static str {
        match self {
            Self::Stabilizer => "stabilizer",
            Self::Verdict => "verdict",
            Self::SettlingTime => "settled\ns",
            Self::ShortPeak => "peak in\ncontacts\n< 0.5 s\nN",
            Self::LongPeak => "peak in\ncontacts\n>= 0.5 s\nN",
            Self::EnergyInjected => "injected\nby loop\nmJ",
            Self::EnergyTaken => "taken by\ncontrol\nmJ",
            Self::Shortfall => "largest\nshortfall\nmJ",
            Self::StiffnessFelt => "stiffness\nfelt\nN/m",
            Self::StiffnessPercent => "of\nasked\n%",
            Self::ForceError => "force\nerror\nN rms",
            Self::Chatter => "chatter\n5-50 Hz\nN rms",
            Self::Active => "active\n%",
            // Without optimisation the numbers say nothing about a real loop.
            Self::StepTime if cfg!(debug_assertions) => {
                "time per step\nmedian (range)\nns, debug build"
            }
            Self::StepTime => "time per step\nmedian (range)\nns",
            Self::StateBytes => "state\nbytes",
            Self::EnergyGiven => "given\nby port\nmJ",
            Self::EnergyBeyondDamper => "given beyond\nthe damper\nmJ",
            Self::ForceFelt => "force\nfelt\n%",
            Self::BrokeIt => "broke it",
            Self::JudgedBy => "judged by",
        }
    }

    /// The cell that shows `score` in the table.
    pub(crate) fn cell(self, score: &Score) -> Cell {
        match self {
            Self::Stabilizer => score.stabilizer.as_str().into(),
            Self::Verdict => score.verdict.into(),
            Self::StepTime => {
                let told = score.step_time.map(|time| {
                    let decimals = if time.median < 100.0 { 2 } else { 0 };
                    let shown = |time: f64| format!("{time:.decimals$}");
                    format!("{} ({}-{})", shown(time.median), shown(time.min), shown(time.max))
                });
                told.into()
            }
            Self::StateBytes => score.state_bytes.to_string().into(),
            Self::BrokeIt => {
                score.broke_it.map(|broke| if broke { "broke it" } else { "no" }).into()
            }
            Self::JudgedBy => score.judged_by.map(Judgement::words).into(),
            Self::Active => score.active.map(|share| format!("{share:.1}")).into(),
            _ => self.value(score).into(),
        }
    }

    /// The order of two scores in this column.
    pub(super) fn order(self, one: &Score, other: &Score) -> Ordering {
        if self == Self::Stabilizer {
            return one.stabilizer.cmp(&other.stabilizer);
        }
        if self == Self::Verdict {
            return one.verdict.cmp(&other.verdict);
        }
        match (self.value(one), self.value(other)) {
            (Some(one), Some(other)) => one.total_cmp(&other),
            (one, other) => other.is_some().cmp(&one.is_some()),
        }
    }

    /// The number that sorts the column.
    pub(crate) fn value(self, score: &Score) -> Option<f64> {
        match self {
            Self::Stabilizer | Self::Verdict | Self::JudgedBy => None,
            Self::SettlingTime => score.settling_time,
            Self::ShortPeak => score.short_peak,
            Self::LongPeak => score.long_peak,
            Self::EnergyInjected => score.energy_injected,
            Self::EnergyTaken => score.energy_taken,
            Self::Shortfall => score.shortfall,
            Self::StiffnessFelt => score.stiffness_felt,
            Self::StiffnessPercent => score.stiffness_percent,
            Self::ForceError => score.force_error,
            Self::Chatter => score.chatter,
            Self::Active => score.active,
            Self::StepTime => score.step_time.map(|time| time.median),
            Self::StateBytes => Some(score.state_bytes as f64),
            Self::EnergyGiven => score.energy_given,
            Self::EnergyBeyondDamper => score.energy_given_beyond_damper,
            Self::ForceFelt => score.force_felt,
            Self::BrokeIt => score.broke_it.map(|broke| if broke { 1.0 } else { 0.0 }),
        }
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

/// Name that no column has.
#[derive(Clone, Debug, PartialEq)]
pub struct UnknownColumn {
    given: String,
}

impl fmt::Display for UnknownColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no column has that name")?;
        match nearest(&self.given, &Column::ALL.map(Column::key)) {
            Some(key) => write!(f, "\n  = did you mean `{key}`?"),
            None => {
                f.write_str("\n  = the columns are:")?;
                let keys = Column::ALL.map(Column::key);
                keys.chunks(3).try_for_each(|keys| write!(f, "\n    {}", keys.join(", ")))
            }
        }
    }
}

impl std::error::Error for UnknownColumn {}

impl FromStr for Column {
    type Err = UnknownColumn;

    fn from_str(given: &str) -> Result<Self, UnknownColumn> {
        let found = Self::ALL.into_iter().find(|column| column.key() == given);
        found.ok_or_else(|| UnknownColumn { given: given.to_owned() })
    }
}
