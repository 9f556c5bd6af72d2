//! The teleoperator in words, and its tables.

use super::comparison::Comparison;
use crate::files::teleoperation::Teleoperator;
use crate::measure::teleoperation::{BAND, BOUND, Score};
use crate::show::table::{Cell, Heading, Table};
use crate::text::{found, given};

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

/// The values at the start that the columns are compared with.
pub(super) fn start(file: &Teleoperator) -> String {
    let cap = file.stabilizer.damping_cap.get();
    let cap =
        if cap.is_infinite() { "no damping cap".to_owned() } else { format!("cap {}", given(cap)) };
    format!(
        "{} mJ in the hand at the start; grows above {} times that, settles with {} of it in motion; \
         {cap}, {} mm/s, b = {} N.s/m",
        found(1e3 * file.stored_at_start()),
        given(BOUND),
        given(BAND),
        given(1e3 * file.stabilizer.compensation_speed.get()),
        given(file.wave_impedance())
    )
}

/// Two tables: the devices' motion, and the forces and energies at the ports.
pub(super) fn of(comparison: &Comparison) -> Vec<Table> {
    let motion = [
        Heading::word("stabilizer"),
        Heading::word("verdict"),
        Heading::number("largest\nenergy\nmJ"),
        Heading::number("speed at\nthe end\nmm/s"),
        Heading::number("largest\nerror\nmm"),
        Heading::number("error at\nthe end\nmm"),
        Heading::number("drift at\nthe end\nmm"),
    ];
    let ports = [
        Heading::word("stabilizer"),
        Heading::number("force\nfelt\nN"),
        Heading::number("force in\ncontact\nN"),
        Heading::number("least\nenergy\nmJ"),
        Heading::number("shortfall\nmJ"),
        Heading::number("active at\nthe master\n%"),
        Heading::number("active at\nthe slave\n%"),
    ];
    vec![
        Table::new(motion).with_rows(comparison.scores().map(in_motion)),
        Table::new(ports).with_rows(comparison.scores().map(at_ports)),
    ]
}

fn in_motion(score: &Score) -> [Cell; 7] {
    [
        score.stabilizer.into(),
        score.verdict.into(),
        score.energy.into(),
        score.speed.into(),
        score.error.into(),
        score.error_end.into(),
        score.drift.into(),
    ]
}

fn at_ports(score: &Score) -> [Cell; 7] {
    [
        score.stabilizer.into(),
        score.felt.into(),
        score.contact.into(),
        score.kept.into(),
        score.shortfall.into(),
        format!("{:.1}", score.active_master).into(),
        format!("{:.1}", score.active_slave).into(),
    ]
}
