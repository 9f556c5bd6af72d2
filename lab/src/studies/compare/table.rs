//! The table in the terminal: two parts, one under the other.

use std::fmt;

use super::Comparison;
use super::column::Column;
use super::setting::Setting;
use crate::show::table::{Heading, Table};

/// How the loop behaved.
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

/// How it felt, and what it cost.
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
