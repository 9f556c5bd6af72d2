//! The table in the terminal: two parts, one under the other, of at most 100 columns.

use std::fmt::{self, Display};

use super::Comparison;
use super::column::Column;
use super::score::Score;
use crate::compare::setting::Setting;
use crate::subjects::Table;

/// The widest line.
const WIDEST: usize = 100;

/// What is left of a name at least.
const SHORTEST: usize = 8;

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
    let scores: Vec<&Score> = comparison.scores().collect();
    for columns in [BEHAVIOUR, FEEL] {
        writeln!(f)?;
        part(&columns, &scores, f)?;
    }
    Ok(())
}

fn part(columns: &[Column], scores: &[&Score], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let headings =
        (0..3).map(|line| columns.iter().map(|c| c.heading()[line].to_owned()).collect());
    let rows = scores.iter().map(|score| columns.iter().map(|c| plain(&c.cell(score))).collect());
    let mut table = Table { headings: headings.collect(), rows: rows.collect() };
    let room = WIDEST.saturating_sub(table.width_of_numbers()).max(SHORTEST);
    for row in &mut table.rows {
        row[0] = fitted(&row[0], room);
    }
    table.fmt(f)
}

/// `text` without what would break the line.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

/// `text` within `room`.
fn fitted(text: &str, room: usize) -> String {
    if text.chars().count() <= room {
        return text.to_owned();
    }
    text.chars().take(room - 3).chain("...".chars()).collect()
}
