//! The teleoperator in words, and its tables.

use super::comparison::Comparison;
use super::meter::BOUND;
use super::score::Score;
use super::teleoperator::Teleoperator;
use crate::subjects::Table;
use crate::summary::{found, given};

/// The teleoperator in one line.
pub(super) fn setting(file: &Teleoperator) -> String {
    let (duration, rate) = (given(file.duration.get()), given(file.servo_rate.get()));
    let (delay, spread) = (file.channel.delay.get(), file.channel.spread.get());
    let mut setting = format!("{duration} s at {rate} Hz, {delay}");
    if spread > 0 {
        setting += &format!(" to {}", delay + spread);
    }
    setting += " ticks each way";
    if file.channel.loss.get() > 0.0 {
        setting += &format!(", {} % lost", given(100.0 * file.channel.loss.get()));
    }
    setting
}

/// What the columns are compared with.
pub(super) fn start(file: &Teleoperator) -> String {
    let cap = file.stabilizer.damping_cap.get();
    let cap =
        if cap.is_infinite() { "no damping cap".to_owned() } else { format!("cap {}", given(cap)) };
    format!(
        "{} mJ in the hand at the start, bounded within {} times that; {cap}, {} mm/s, b = {} N.s/m",
        found(1e3 * file.stored_at_start()),
        given(BOUND),
        given(1e3 * file.stabilizer.compensation_speed.get()),
        given(file.wave_impedance())
    )
}

/// How the devices moved, and what it took.
pub(super) fn of(comparison: &Comparison) -> Vec<Table> {
    let table = |headings: [[&str; 7]; 3], cells: fn(&Score) -> [String; 7]| Table {
        headings: headings.map(|line| line.map(str::to_owned).into()).into(),
        rows: comparison.scores().map(|score| cells(score).into()).collect(),
    };
    let motion = [
        ["", "", "largest", "speed at", "largest", "error at", "drift at"],
        ["", "", "energy", "the end", "error", "the end", "the end"],
        ["stabilizer", "bounded", "mJ", "mm/s", "mm", "mm", "mm"],
    ];
    let ports = [
        ["", "force", "force in", "least", "", "active at", "active at"],
        ["", "felt", "contact", "energy", "shortfall", "the master", "the slave"],
        ["stabilizer", "N", "N", "mJ", "mJ", "%", "%"],
    ];
    vec![table(motion, in_motion), table(ports, at_ports)]
}

fn in_motion(score: &Score) -> [String; 7] {
    [
        score.stabilizer.to_owned(),
        if score.bounded { "yes" } else { "no" }.to_owned(),
        number(score.energy),
        number(score.speed),
        number(score.error),
        number(score.error_end),
        number(score.drift),
    ]
}

fn at_ports(score: &Score) -> [String; 7] {
    [
        score.stabilizer.to_owned(),
        number(score.felt),
        number(score.contact),
        number(score.kept),
        number(score.shortfall),
        format!("{:.1}", score.active_master),
        format!("{:.1}", score.active_slave),
    ]
}

fn number(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |value| found(value).to_string())
}
