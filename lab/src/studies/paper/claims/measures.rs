//! Measures of a trace, by the definitions of the report.

use std::ops::RangeInclusive;

use super::member::START;
use super::trace::{Point, Trace};

/// Time within which a run is judged, s: as long as a run of the study is.
pub(super) const WINDOW: f64 = 30.0;
/// Latest time from which a settled run stays within the band, s: nine tenths of the window.
const DEADLINE: f64 = 27.0;
/// Time after the first contact in which the controller replies to it, s.
const REPLY: f64 = 0.1;
/// Time over which a swing without control is compared with the swing before, s: one swing of the hand.
const SWING: f64 = 0.5;
/// Time after settling in which turns are counted, s.
const SECOND: f64 = 1.0;
/// Share of the start that a motion goes back before that counts as a turn.
const TURN: f64 = 1e-3;
/// Largest ratio of the last quarter's swing to the second's in a run that does not grow.
const GROWTH: f64 = 1.05;

/// Measures of one run, from the first tick to where it is decided: to the tick from which it has settled, to the
/// tick at which it passes a thousand times its start, else to 30 s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// The start of the run over the paper's start. The loop is homogeneous: in exact arithmetic lengths and forces are
    /// proportional to it, energies to its square.
    pub scale: f64,
    /// Time from which on `|x|` stays within 5 % of the start for 3 s, s, if it is no later than 27 s.
    pub settled: Option<f64>,
    /// Time at which `|x|` passes ten times the start, s.
    pub left: Option<f64>,
    /// Whether the run does not settle, and passes ten times its start or swings wider in the last quarter of the 30 s
    /// than in the second.
    pub grows: bool,
    /// The largest `|x|` within the second half second over that within the first.
    pub growth: Option<f64>,
    /// The largest force of the wall in the first contact, N.
    pub force_peak: f64,
    /// The controller's largest force within 0.1 s after the first contact, N; negative if against the wall's force.
    pub reply: f64,
    /// The largest observed energy until the end of the first contact, J.
    pub energy_peak: f64,
    /// The lowest observed energy, J.
    pub energy_least: f64,
    /// The observed energy where the run has settled, J.
    pub energy_settled: Option<f64>,
    /// Largest `|x|` after the first contact, m.
    pub swing: f64,
    /// Turns of the motion in the second after settling, each by more than 0.1 % of the start.
    pub turns: Option<usize>,
    /// The largest `|ΔL|` of a tick, as booked, J.
    pub largest_step: f64,
    /// The sum of all `|ΔL|`, J.
    pub variation: f64,
    /// Energy taken by the controller: the work of its held force over the true displacement, J.
    pub taken: f64,
    /// The largest part of it that one period takes, J.
    pub taken_at_once: f64,
}

impl Measures {
    /// Measures of `trace`.
    pub fn of(trace: &Trace) -> Self {
        let no_later = |time: f64| move |tick: &usize| *tick <= trace.ticks(time);
        let settled = trace.settled().filter(no_later(DEADLINE));
        let left = trace.left().filter(no_later(WINDOW));
        let end = settled
            .or(trace.gone().filter(no_later(WINDOW)))
            .unwrap_or_else(|| trace.ticks(WINDOW));
        let judged = &trace.points()[..trace.points().len().min(end + 1)];
        let contact = first_contact(judged);
        let after = judged.get(contact.end..).unwrap_or_default();
        let until = judged.len().min(contact.end + 1);
        let time = |tick: usize| tick as f64 * trace.period;
        let steps = || judged.iter().map(|point| point.booked.abs());
        let taken = || judged.windows(2).map(|pair| control(&pair[0]) * (pair[1].x - pair[0].x));
        Self {
            scale: trace.start / START.abs(),
            settled: settled.map(time),
            left: left.map(time),
            grows: settled.is_none() && (left.is_some() || swings_wider(trace, judged)),
            growth: growth(trace, judged),
            force_peak: largest(judged[contact].iter().map(|point| point.force)),
            reply: reply(&after[..after.len().min(trace.ticks(REPLY))]),
            energy_peak: largest(judged[..until].iter().map(|point| point.observed_energy)),
            energy_least: judged.iter().map(|point| point.observed_energy).fold(0.0, f64::min),
            energy_settled: settled.map(|tick| trace.points()[tick].observed_energy),
            swing: widest(after),
            turns: settled.map(|tick| turns(trace, tick)),
            largest_step: largest(steps()),
            variation: steps().sum(),
            taken: taken().sum(),
            taken_at_once: largest(taken()),
        }
    }
}

/// The controller's force, N.
fn control(point: &Point) -> f64 {
    point.alpha * point.v
}

/// The largest of the numbers, at least 0.
fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, f64::max)
}

/// The largest distance from the wall, m.
fn widest(points: &[Point]) -> f64 {
    largest(points.iter().map(|point| point.x.abs()))
}

/// The first consecutive ticks on which the wall pushes.
fn first_contact(points: &[Point]) -> std::ops::Range<usize> {
    let pushes = |point: &Point| point.force > 0.0;
    let start = points.iter().position(pushes).unwrap_or(points.len());
    let length = points[start..].iter().take_while(|point| pushes(point)).count();
    start..start + length
}

/// The controller's largest force, with its sign.
fn reply(points: &[Point]) -> f64 {
    let larger = |most: f64, force: f64| if force.abs() > most.abs() { force } else { most };
    points.iter().map(control).fold(0.0, larger)
}

/// The points between two times, s.
fn between<'a>(trace: &Trace, points: &'a [Point], times: RangeInclusive<f64>) -> &'a [Point] {
    let end = points.len().min(trace.ticks(*times.end()) + 1);
    &points[trace.ticks(*times.start()).min(end)..end]
}

/// The widest swing of the second half second over that of the first.
fn growth(trace: &Trace, points: &[Point]) -> Option<f64> {
    let [first, second] =
        [0.0..=SWING, SWING..=2.0 * SWING].map(|times| widest(between(trace, points, times)));
    (first > 0.0 && second > 0.0).then(|| second / first)
}

/// Whether the last quarter's swing is wider than the second's, beyond the band.
fn swings_wider(trace: &Trace, points: &[Point]) -> bool {
    let quarter = WINDOW / 4.0;
    let [second, last] = [quarter..=2.0 * quarter, 3.0 * quarter..=WINDOW]
        .map(|times| widest(between(trace, points, times)));
    last > (GROWTH * second).max(trace.band())
}

/// Turns in the second from `settled` on.
fn turns(trace: &Trace, settled: usize) -> usize {
    let end = trace.points().len().min(settled + trace.ticks(SECOND) + 1);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut forth, mut turns) = (None, 0);
    for point in &trace.points()[settled..end] {
        (low, high) = (low.min(point.x), high.max(point.x));
        let (risen, fallen) = (point.x - low, high - point.x);
        let enough = TURN * trace.start;
        let now = match forth {
            Some(true) => fallen <= enough,
            Some(false) => risen > enough,
            None if risen.max(fallen) <= enough => continue,
            None => risen > fallen,
        };
        if forth != Some(now) {
            turns += usize::from(forth.is_some());
            forth = Some(now);
            (low, high) = (point.x, point.x);
        }
    }
    turns
}

#[cfg(test)]
mod tests;
