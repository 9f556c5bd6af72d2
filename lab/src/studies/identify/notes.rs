//! What a log cannot tell, and what it contradicts, in a sentence each.

use super::device::Device;
use super::recording::Recording;
use super::wall::{Seen, Wall};
use crate::text::found;

/// Share of the force in contact above which a wall is said to leave something.
const LEFT: f64 = 0.1;

/// Share of the stiffness above which errors of the position are said to make it too low.
const LOST: f64 = 0.02;

pub(super) fn notes(recording: &Recording, device: &Device, wall: Option<&Wall>) -> Vec<String> {
    let told = [
        gaps(recording),
        pushed(device),
        late(recording, device, wall),
        zero(device),
        spring(device),
        no_wall(recording, wall),
        wall.and_then(left),
        wall.and_then(blurred),
        Some("hand and device move as one here: a log of one position does not tell their masses apart".to_owned()),
    ];
    told.into_iter().flatten().collect()
}

fn gaps(recording: &Recording) -> Option<String> {
    let gaps = recording.stretches.len() - 1;
    let times = if gaps == 1 { "a gap" } else { "gaps" };
    (gaps > 0).then(|| {
        format!("{times} cut the log into {} stretches; the scene starts with the first", gaps + 1)
    })
}

fn pushed(device: &Device) -> Option<String> {
    let [whole, short] = [device.error, device.short_error].map(|it| found(1e6 * it));
    device.is_pushed.then(|| {
        format!(
            "something pushes that the log does not hold, as a hand that moves or dry friction does: from its first row \
             the model follows the log within {whole} um, over 32 rows and with a constant force of their own within {short} um; \
             the numbers are those of the latter, with intervals that span both fits; what pushes may bias them"
        )
    })
}

fn late(recording: &Recording, device: &Device, wall: Option<&Wall>) -> Option<String> {
    let (acts, answers) = (device.lag(), wall.map_or(0, |wall| wall.lag));
    let rows = |rows: usize| {
        let time = found(1e3 * recording.period * rows as f64);
        format!("{rows} row{} ({time} ms)", if rows == 1 { "" } else { "s" })
    };
    match (acts, answers) {
        (0, 0) => None,
        (acts, 0) => Some(format!("f acts {} late; the scene has that delay", rows(acts))),
        (0, answers) => {
            Some(format!("the wall answers {} late; the scene has that delay", rows(answers)))
        }
        _ => Some(format!(
            "f acts {} late and the wall answers {} late; the scene has the delay of both",
            rows(acts),
            rows(answers)
        )),
    }
}

fn zero(device: &Device) -> Option<String> {
    (!device.damping().is_told()).then(|| "the damping is not told from 0".to_owned())
}

fn spring(device: &Device) -> Option<String> {
    (!device.stiffness().is_told())
        .then(|| "no spring of a hand is told from 0, so that its rest is none; what pushes steadily is a load".to_owned())
}

fn no_wall(recording: &Recording, wall: Option<&Wall>) -> Option<String> {
    if wall.is_some_and(|wall| wall.spread.is_some()) {
        return None;
    }
    let forces = || recording.stretches.iter().flat_map(|it| &it.forces);
    let [low, high] =
        [forces().fold(0.0_f64, |it, f| it.min(*f)), forces().fold(0.0_f64, |it, f| it.max(*f))];
    Some(if -low > high {
        "no wall: f pushes towards larger x; a wall at smaller x is turned round by --scale x=-1,f=-1".to_owned()
    } else {
        "no wall: f does not grow with a depth beyond some place; the scene has one without stiffness where x ends".to_owned()
    })
}

fn left(wall: &Wall) -> Option<String> {
    let share = wall.error / wall.force;
    (share > LEFT).then(|| {
        format!(
            "the wall leaves {} N of {} N in contact (root mean squares): f holds more than a spring and a damper, or is \
             held longer than a row",
            found(wall.error),
            found(wall.force)
        )
    })
}

fn blurred(wall: &Wall) -> Option<String> {
    // An error of the position with this deviation would leave as much of the force.
    let deviation = wall.error / wall.at[0];
    let lost = (deviation / wall.travel).powi(2);
    (wall.seen != Seen::Fitted && lost > LOST).then(|| {
        format!(
            "if the wall saw x without the error that the log has, its stiffness is up to {} % too low",
            found(100.0 * lost)
        )
    })
}
