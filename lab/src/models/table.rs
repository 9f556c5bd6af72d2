//! The table in the terminal, of at most 100 columns.

use std::fmt;

use super::comparison::Comparison;
use super::meter::BOUND;
use super::outcome::Score;
use crate::summary::{found, given};

const BETWEEN: &str = "  ";

/// How many columns there are.
const COLUMNS: usize = 8;

pub(super) fn write(comparison: &Comparison, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "{}: {}", comparison.name, setting(comparison))?;
    writeln!(f, "{}", start(comparison))?;
    writeln!(f)?;
    let headings = headings(comparison);
    let cells: Vec<[String; COLUMNS]> = comparison.scores().map(cells).collect();
    let all = || headings.iter().chain(&cells);
    let widths: [usize; COLUMNS] = std::array::from_fn(|column| {
        all().map(|line| line[column].chars().count()).max().unwrap_or(0)
    });
    for (index, line) in all().enumerate() {
        if index == headings.len() {
            let rules: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
            writeln!(f, "{}", rules.join(BETWEEN))?;
        }
        writeln!(f, "{}", aligned(line, &widths).trim_end())?;
    }
    Ok(())
}

/// The model in one line.
pub(super) fn setting(comparison: &Comparison) -> String {
    let model = &comparison.model;
    let (duration, rate) = (given(model.duration.get()), given(model.servo_rate.get()));
    let mut setting = format!("{}, {duration} s at {rate} Hz", model.plant.name());
    let (hold, delay) = (model.controller.hold.get(), model.controller.delay.get());
    if hold > 1 {
        setting +=
            &format!(", controller at {} Hz", given(model.servo_rate.get() / f64::from(hold)));
    }
    if delay > 0 {
        setting += &format!(", controller {delay} ticks late");
    }
    setting
}

/// What the columns are compared with.
pub(super) fn start(comparison: &Comparison) -> String {
    let stabilizer = comparison.model.stabilizer;
    let cap = stabilizer.damping_cap.get();
    let cap = if cap.is_infinite() {
        "no damping cap".to_owned()
    } else {
        format!("damping cap {} m / T", given(cap))
    };
    let unit = spaced(comparison.model.plant.unit_of_value());
    format!(
        "V = {}{unit} at the start, bounded within {} times that; {cap}, decay {} 1/s",
        found(comparison.began),
        given(BOUND),
        given(stabilizer.decay.get())
    )
}

fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

pub(super) fn headings(comparison: &Comparison) -> [[String; COLUMNS]; 3] {
    let (v, input) =
        (comparison.model.plant.unit_of_value(), comparison.model.plant.unit_of_input());
    [
        ["", "", "largest", "V at", "largest", "", "largest", "energy"],
        ["", "", "V", "the end", "effort", "active", "shortfall", "taken"],
        ["stabilizer", "bounded", v, v, input, "%", v, v],
    ]
    .map(|line| line.map(str::to_owned))
}

pub(super) fn cells(score: &Score) -> [String; COLUMNS] {
    let number =
        |value: Option<f64>| value.map_or("-".to_owned(), |value| found(value).to_string());
    [
        score.stabilizer.to_owned(),
        if score.bounded { "yes" } else { "no" }.to_owned(),
        number(score.largest),
        number(score.end),
        number(score.effort),
        format!("{:.1}", score.active),
        number(score.shortfall),
        number(score.taken),
    ]
}

/// Names to the left, everything else to the right.
fn aligned(line: &[String; COLUMNS], widths: &[usize; COLUMNS]) -> String {
    let cells = line.iter().zip(widths).enumerate().map(|(column, (cell, width))| {
        if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
    });
    cells.collect::<Vec<_>>().join(BETWEEN)
}
