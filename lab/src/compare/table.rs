//! The table in the terminal: two parts, one under the other, of at most 100 columns.

use std::fmt;

use super::Comparison;
use super::column::Column;
use super::score::Score;
use crate::compare::setting::Setting;

/// The widest line.
const WIDEST: usize = 100;

/// What is left of a name at least.
const SHORTEST: usize = 8;

const BETWEEN: &str = "  ";

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
    let cells = scores.iter().map(|score| columns.iter().map(|c| plain(&c.cell(score))).collect());
    let (headings, mut cells): (Vec<Vec<String>>, Vec<Vec<String>>) =
        (headings.collect(), cells.collect());
    let widths = |cells: &[Vec<String>]| -> Vec<usize> {
        let all = || headings.iter().chain(cells);
        let width = |column: usize| all().map(|line| line[column].chars().count()).max();
        (0..columns.len()).map(|column| width(column).unwrap_or(0)).collect()
    };
    let numbers: usize = widths(&cells)[1..].iter().map(|width| BETWEEN.len() + width).sum();
    let room = WIDEST.saturating_sub(numbers).max(SHORTEST);
    for line in &mut cells {
        line[0] = fitted(&line[0], room);
    }
    let widths = widths(&cells);
    for (index, line) in headings.iter().chain(&cells).enumerate() {
        if index == headings.len() {
            let rules: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
            writeln!(f, "{}", rules.join(BETWEEN))?;
        }
        writeln!(f, "{}", aligned(line, &widths).trim_end())?;
    }
    Ok(())
}

/// Names to the left, everything else to the right.
fn aligned(line: &[String], widths: &[usize]) -> String {
    let cells = line.iter().zip(widths).enumerate().map(|(column, (cell, width))| {
        if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
    });
    cells.collect::<Vec<_>>().join(BETWEEN)
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
