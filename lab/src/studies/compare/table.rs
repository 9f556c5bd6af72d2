//! Scene in a line, and table in the terminal: three parts, one below the other.

use std::fmt;

use super::Comparison;
use super::column::Column;
use super::look_at::LookAt;
use crate::files::Scene;
use crate::show::described;
use crate::show::table::{Heading, Table};
use crate::show::verdict::by_speed;
use crate::text::given;

/// Columns of the loop's behaviour.
const BEHAVIOUR: [Column; 8] = [
    Column::Stabilizer,
    Column::Verdict,
    Column::SettlingTime,
    Column::ShortPeak,
    Column::LongPeak,
    Column::EnergyInjected,
    Column::EnergyTaken,
    Column::Shortfall,
];

/// Columns of feel and cost.
const FEEL: [Column; 8] = [
    Column::Stabilizer,
    Column::StiffnessFelt,
    Column::StiffnessPercent,
    Column::ForceError,
    Column::Chatter,
    Column::Active,
    Column::StepTime,
    Column::StateBytes,
];

/// Columns of energy and force on the true motion.
const PHYSICAL: [Column; 6] = [
    Column::Stabilizer,
    Column::EnergyGiven,
    Column::EnergyBeyondDamper,
    Column::ForceFelt,
    Column::BrokeIt,
    Column::JudgedBy,
];

pub(super) fn write(comparison: &Comparison, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "{}: {}", comparison.name, Setting(&comparison.scene))?;
    writeln!(f, "POPC and LOLC: {}", comparison.settings)?;
    if let Some(sentence) = described::exceeded_cap(&comparison.scene) {
        writeln!(f, "{sentence}")?;
    }
    if let Some(by) = by_speed(&comparison.scene) {
        writeln!(f, "judged {by}")?;
    }
    for sign in LookAt::of(comparison) {
        writeln!(f, "{}", sign.line(comparison.outcomes.len()))?;
    }
    for columns in [&BEHAVIOUR[..], &FEEL, &PHYSICAL] {
        let headings = columns.iter().map(|column| match column {
            Column::Stabilizer | Column::Verdict | Column::BrokeIt | Column::JudgedBy => {
                Heading::word(column.heading())
            }
            _ => Heading::number(column.heading()),
        });
        let rows = comparison
            .scores()
            .map(|score| columns.iter().map(|column| column.cell(score)).collect::<Vec<_>>());
        write!(f, "\n{}", Table::new(headings).with_rows(rows))?;
    }
    Ok(())
}

pub(super) struct Setting<'a>(pub(super) &'a Scene);

impl fmt::Display for Setting<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = self.0;
        let (duration, rate) = (given(scene.duration.get()), given(scene.servo_rate.get()));
        write!(f, "{duration} s at {rate} Hz")?;
        if scene.environment_ratio() > 1 {
            write!(f, " over {} Hz", given(scene.environment_rate()))?;
        }
        write!(f, ", {} {}", scene.environment.name(), described::environment(scene))
    }
}
