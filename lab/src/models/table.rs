//! The model in words, and its table.

use super::comparison::Comparison;
use super::meter::BOUND;
use super::outcome::Score;
use crate::subjects::Table;
use crate::summary::{found, given};

pub(super) fn of(comparison: &Comparison) -> Table {
    Table { headings: headings(comparison), rows: comparison.scores().map(cells).collect() }
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

fn headings(comparison: &Comparison) -> Vec<Vec<String>> {
    let (v, input) =
        (comparison.model.plant.unit_of_value(), comparison.model.plant.unit_of_input());
    [
        ["", "", "largest", "V at", "largest", "", "largest", "energy"],
        ["", "", "V", "the end", "effort", "active", "shortfall", "taken"],
        ["stabilizer", "bounded", v, v, input, "%", v, v],
    ]
    .map(|line| line.map(str::to_owned).into())
    .into()
}

fn cells(score: &Score) -> Vec<String> {
    let number =
        |value: Option<f64>| value.map_or("-".to_owned(), |value| found(value).to_string());
    vec![
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
