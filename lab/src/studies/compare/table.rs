//! Scene in a line, and table in the terminal: two parts, one below the other.

use std::fmt;

use super::Comparison;
use super::column::Column;
use crate::files::Scene;
use crate::show::described;
use crate::show::table::{Heading, Table};
use crate::text::given;

/// Columns of the loop's behaviour.
const BEHAVIOUR: [Column; 8] = [
    Column::Stabilizer,
    Column::Stable,
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

pub(super) fn write(comparison: &Comparison, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "{}: {}", comparison.name, Setting(&comparison.scene))?;
    writeln!(f, "POPC and LOLC: {}", comparison.settings)?;
    if let Some(sentence) = described::exceeded_cap(&comparison.scene) {
        writeln!(f, "{sentence}")?;
    }
    for columns in [BEHAVIOUR, FEEL] {
        let headings = columns.map(|column| match column {
            Column::Stabilizer | Column::Stable => Heading::word(column.heading()),
            _ => Heading::number(column.heading()),
        });
        let rows = comparison.scores().map(|score| columns.map(|column| column.cell(score)));
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
