//! The model in words, and its table.

use super::comparison::Comparison;
use crate::files::models::{Model, Plant};
use crate::measure::models::{BAND, BOUND, Score};
use crate::show::table::{Cell, Heading, Table};
use crate::text::{found, given};

/// Rounding of one over a gain as it is written.
const ROUNDING: f64 = 1e-3;

pub(super) fn of(comparison: &Comparison) -> Table {
    let plant = &comparison.model.plant;
    let (v, input) = (plant.unit_of_value(), plant.unit_of_input());
    let headings = [
        Heading::word("stabilizer"),
        Heading::word("verdict"),
        Heading::number(format!("largest\nV\n{v}")),
        Heading::number(format!("V at\nthe end\n{v}")),
        Heading::number(format!("largest\neffort\n{input}")),
        Heading::number("active\n%"),
        Heading::number(format!("largest\nshortfall\n{v}")),
        Heading::number(format!("energy\ntaken\n{v}")),
    ];
    Table::new(headings).with_rows(comparison.scores().map(cells))
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

/// The values at the start that the columns are compared with.
pub(super) fn start(comparison: &Comparison) -> String {
    let stabilizer = comparison.model.stabilizer;
    let cap = stabilizer.damping_cap.get();
    let cap = if cap.is_infinite() {
        "no damping cap".to_owned()
    } else {
        format!("damping cap {} m / T", given(cap))
    };
    let unit = spaced(comparison.model.plant.unit_of_value());
    let mut start = format!(
        "V = {}{unit} at the start; grows above {} times that, settles within {} of it; {cap}, decay {} 1/s",
        found(comparison.began),
        given(BOUND),
        given(BAND),
        given(stabilizer.decay.get())
    );
    if let Some([wanted, rendered]) = masses(&comparison.model) {
        let rendered = match rendered.is_finite() {
            true => format!("{} kg", found(rendered)),
            false => "none".to_owned(),
        };
        start +=
            &format!("; V has a mass of {} kg, the controller renders {rendered}", given(wanted));
    }
    start
}

/// The mass in the V of an admittance device, and the one that its controller renders, where these are two.
fn masses(model: &Model) -> Option<[f64; 2]> {
    let Plant::AdmittanceDevice(device) = &model.plant else { return None };
    let wanted = device.wanted_mass.get();
    // Infinite without this gain: the device does not yield.
    let rendered = -model.controller.derivative.axis(0).recip();
    ((rendered / wanted - 1.0).abs() > ROUNDING).then_some([wanted, rendered])
}

fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

fn cells(score: &Score) -> [Cell; 8] {
    [
        score.stabilizer.into(),
        score.verdict.into(),
        score.largest.into(),
        score.end.into(),
        score.effort.into(),
        format!("{:.1}", score.active).into(),
        score.shortfall.into(),
        score.taken.into(),
    ]
}
