//! The teleoperator in words, and its tables.

use super::comparison::Comparison;
use crate::files::teleoperation::Teleoperator;
use crate::measure::teleoperation::{BAND, BOUND, Score};
use crate::show::table::{Cell, Heading, Table};
use crate::text::{counted, found, given};

/// The teleoperator in one line.
pub(super) fn setting(file: &Teleoperator) -> String {
    let (duration, rate) = (given(file.duration.get()), given(file.servo_rate.get()));
    let (delay, spread) = (file.channel.delay.get(), file.channel.spread.get());
    let ticks = match spread {
        0 => counted(delay.into(), "tick"),
        _ => format!("{delay} to {} ticks", delay + spread),
    };
    let mut setting = format!("{duration} s at {rate} Hz, {ticks} each way");
    if file.channel.loss.get() > 0.0 {
        setting += &format!(", {} % lost", given(100.0 * file.channel.loss.get()));
    }
    let ticks = file.duration.get() * file.servo_rate.get();
    if file.channel.loss.get() == 1.0 || f64::from(delay) > ticks {
        setting += ": nothing ever arrives, and each device moves by itself";
    }
    setting
}

/// The reference of the columns, and the settings of the stabilizers; the terminal breaks the line at each semicolon.
pub(super) fn start(file: &Teleoperator) -> String {
    let (cap, layers) = (file.stabilizer.damping_cap.get(), file.layers());
    let cap =
        if cap.is_infinite() { "no damping cap".to_owned() } else { format!("cap {}", given(cap)) };
    format!(
        "{} mJ in the hand at the start; grows above {} times that, settles with {} of it in motion; \
         an ideal link rests with {} N; {cap}, drift taken back at {} mm/s; tank of {} mJ, {} N.s/(m J), share {}; b = {} N.s/m, filters of {} ms",
        found(1e3 * file.stored_at_start()),
        given(BOUND),
        given(BAND),
        found(file.ideal_force()),
        given(1e3 * file.stabilizer.drift_compensated.speed.get()),
        found(1e3 * layers.level),
        found(layers.gain),
        given(layers.share),
        given(file.wave_impedance()),
        found(1e3 * file.wave_filter_time())
    )
}

/// Three tables: the devices' motion, the forces, and the energies at the ports.
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
    let forces = [
        Heading::word("stabilizer"),
        Heading::number("force\nfelt\nN"),
        Heading::number("force at\nthe end\nN"),
        Heading::number("force in\ncontact\nN"),
        Heading::number("first\ntouch\ns"),
    ];
    let energies = [
        Heading::word("stabilizer"),
        Heading::number("energy\ngiven\nmJ"),
        Heading::number("least\nenergy\nmJ"),
        Heading::number("shortfall\nmJ"),
        Heading::number("active at\nthe master\n%"),
        Heading::number("active at\nthe slave\n%"),
    ];
    vec![
        Table::new(motion).with_rows(comparison.scores().map(in_motion)),
        Table::new(forces).with_rows(comparison.scores().map(in_forces)),
        Table::new(energies).with_rows(comparison.scores().map(at_ports)),
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

fn in_forces(score: &Score) -> [Cell; 5] {
    [
        score.stabilizer.into(),
        score.felt.into(),
        score.felt_end.into(),
        score.contact.into(),
        score.touch.into(),
    ]
}

fn at_ports(score: &Score) -> [Cell; 6] {
    [
        score.stabilizer.into(),
        score.given.into(),
        score.kept.into(),
        score.shortfall.into(),
        format!("{:.1}", score.active_master).into(),
        format!("{:.1}", score.active_slave).into(),
    ]
}
