//! What a log cannot tell, and what it contradicts, in a sentence each.

use super::device::Device;
use super::recording::Recording;
use super::wall::{STRAY, Seen, Wall};
use crate::text::{counted, found, prefixed};

/// Share of the force in contact above which a wall is said to leave something.
const LEFT: f64 = 0.1;

/// Share of the largest force above which a wall is said to leave something, and times that the error of fitted positions makes of
/// it: a loop that computes its force from `x` leaves rounding, and one that saw another `x` up to once that error.
const OWN: f64 = 1e-6;
const UNSURE: f64 = 5.0;

/// Share of the stiffness above which errors of the position are said to make it too low, and the share of the error that would do
/// that which the positions have to show at least.
const LOST: f64 = 0.02;
const SHOWN: f64 = 0.01;

/// Share of the period by which the steps of `t` scatter when that is told.
const UNEVEN: f64 = 0.01;

/// Share of the way from the least to the largest position from which on the steps of `x` are called coarse.
const COARSE: f64 = 0.01;

pub(super) fn notes(recording: &Recording, device: &Device, wall: Option<&Wall>) -> Vec<String> {
    let told = [
        recording.unread_axes.clone(),
        gaps(recording),
        uneven(recording),
        coarse(recording),
        pushed(device),
        late(recording, device, wall),
        zero(device),
        spring(device),
        no_wall(recording, wall),
        wall.and_then(clipped),
        wall.and_then(|wall| left(recording, wall)),
        wall.and_then(stray),
        wall.and_then(|wall| blurred(recording, device, wall)),
        wall.and_then(|wall| filtered(recording, wall)),
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

fn uneven(recording: &Recording) -> Option<String> {
    let scatter = recording.scatter();
    (scatter > UNEVEN * recording.period).then(|| {
        format!(
            "the steps of t scatter by {} (root mean square): if the loop ticks more evenly than it is stamped, the intervals are \
             too narrow, and t in even steps tells more",
            prefixed(scatter, "s")
        )
    })
}

fn coarse(recording: &Recording) -> Option<String> {
    let step = recording.resolution().filter(|step| *step > COARSE * recording.travel())?;
    let share = found(100.0 * step / recording.travel());
    Some(format!(
        "the steps of x are {share} % of its way: the intervals count rounding to them as noise, which it is less the coarser they are"
    ))
}

fn pushed(device: &Device) -> Option<String> {
    let [whole, short] = [device.error, device.short_error].map(|it| prefixed(it, "m"));
    if device.is_pushed {
        return Some(format!(
            "something pushes that the log does not hold, as a hand that moves or dry friction does, or f is logged late or with \
             fewer rows than the loop has ticks: from its first row the model follows the log within {whole}, over 32 rows and \
             with a constant force of their own within {short}; the numbers are those of the latter, and the intervals span both \
             fits and are not of 95 %: under a hand that moves mass and spring may come out low. The scene's hand stands still: \
             for runs like the log give it its motion, operator.motion, or a rest beyond the wall"
        ));
    }
    let steps = match device.unlike? {
        0.0 => String::new(),
        steps => format!(", where its steps leave {}", prefixed(steps, "m")),
    };
    Some(format!(
        "the model leaves {whole} of x, row after row alike{steps}: fewer rows than the loop has ticks, a force logged late, or \
         something that the log does not hold; the intervals do not count that"
    ))
}

fn late(recording: &Recording, device: &Device, wall: Option<&Wall>) -> Option<String> {
    let (acts, answers) = (device.lag(), wall.map_or(0, |wall| wall.lag));
    let rows = |rows: usize| {
        let time = found(1e3 * recording.period * rows as f64);
        format!("{} ({time} ms)", counted(rows, "row"))
    };
    match (acts, answers) {
        (0, 0) => None,
        (acts, 0) => Some(format!(
            "f acts {} late; the scene has that delay, and observe and run --against need --late {acts}",
            rows(acts)
        )),
        (0, answers) => {
            Some(format!("the wall answers {} late; the scene has that delay", rows(answers)))
        }
        _ => Some(format!(
            "f acts {} late and the wall answers {} late; the scene has the delay of both, and observe and run --against need \
             --late {acts}",
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

fn clipped(wall: &Wall) -> Option<String> {
    let (most, rows) = (prefixed(wall.largest, "N"), wall.at_most);
    wall.is_clipped.then(|| {
        format!("f stands at {most} in {rows} rows: clipped; the wall is fitted to the others, and the scene has that limit")
    })
}

fn left(recording: &Recording, wall: &Wall) -> Option<String> {
    let (most, rows) = (prefixed(wall.largest, "N"), wall.at_most);
    let [left, force] = [wall.error, wall.force].map(|it| prefixed(it, "N"));
    let leaves = format!("the wall leaves {left} of {force} in contact (root mean squares)");
    if wall.error > LEFT * wall.force {
        return Some(if 2 * rows > wall.rows {
            format!(
                "{leaves}: f stands at {most} in {rows} rows, as if clipped, and too few others tell the wall"
            )
        } else {
            format!(
                "{leaves}: f holds more than a spring and a damper, or is held longer than a row"
            )
        });
    }
    let digits = recording.force_step().unwrap_or_default();
    let sound = (OWN * wall.largest).max(digits).max(UNSURE * wall.unsure_force());
    (wall.seen != Seen::WithVelocity && wall.error > sound).then(|| {
        "f is not a spring and a damper of x and its backward difference: a filtered v (give it as a column), fewer rows than \
         ticks, another sensor, a clipped or noisy f; the wall's intervals may not count that"
            .to_owned()
    })
}

fn stray(wall: &Wall) -> Option<String> {
    let rows = if wall.strays == 1 { "row" } else { "rows" };
    (wall.stray > STRAY * wall.largest).then(|| {
        format!(
            "f is up to {} in {} {rows} where this wall gives none: an environment that pulls, or damping in free motion; no wall of \
             the scene does that",
            prefixed(wall.stray, "N"),
            wall.strays
        )
    })
}

fn blurred(recording: &Recording, device: &Device, wall: &Wall) -> Option<String> {
    // An error of the position with this deviation would leave as much of the force.
    let deviation = wall.error / wall.at[0];
    let lost = (deviation / wall.travel).powi(2);
    let steps = recording.resolution().unwrap_or_default();
    let has_error = device.error.max(steps) > SHOWN * deviation;
    (wall.seen != Seen::Fitted && lost > LOST && has_error).then(|| {
        format!(
            "if the wall saw x without the error that the log has, its stiffness is up to {} % too low",
            found(100.0 * lost)
        )
    })
}

fn filtered(recording: &Recording, wall: &Wall) -> Option<String> {
    let differs = || {
        recording.stretches.iter().any(|it| {
            let steps = it.times.windows(2).zip(it.positions.windows(2));
            let differences = steps.map(|(t, x)| (x[1] - x[0]) / (t[1] - t[0]));
            let apart = differences.zip(&it.velocities[1..]).map(|(v, logged)| (v - logged).abs());
            apart.fold(0.0, f64::max) > OWN * wall.speed
        })
    };
    (wall.seen == Seen::WithVelocity && differs()).then(|| {
        "the wall is fitted to the v of the log, and the scene takes the backward difference of x: give it the filter that the \
         loop has, as in [effects.filter]"
            .to_owned()
    })
}
