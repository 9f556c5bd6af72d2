//! Measures of a trace, by the definitions of the report.

use super::ensemble::{START, Trace};

/// Multiple of its start that a bounded run never leaves.
const BOUND: f64 = 10.0;

/// Measures of one run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// The start of the run over the paper's start. The loop is homogeneous: in exact arithmetic lengths and forces are
    /// proportional to it, energies to its square.
    pub scale: f64,
    /// Whether `|x|` stays within ten times the start.
    pub bounded: bool,
    /// Time from which on `|x|` stays within 5 % of the start, s.
    pub settled: Option<f64>,
    /// The largest force of the wall in the first contact, N.
    pub force_peak: f64,
    /// The controller's largest force within 0.1 s after the first contact, N; negative if against the wall's force.
    pub reply: f64,
    /// The largest observed energy, J.
    pub energy_peak: f64,
    /// The observed energy at the end, J.
    pub energy_end: f64,
    /// Largest `|x|` after the first contact, m.
    pub swing: f64,
    /// RMS velocity over the second after settling, m/s.
    pub jitter: Option<f64>,
    /// Largest over median `|ΔL|` of active ticks, each as booked.
    pub impulsiveness: Option<f64>,
    /// Energy taken by the controller: the work of its held force over the true displacement, J.
    pub taken: f64,
    /// The same per active tick, J.
    pub taken_per_sample: Option<f64>,
    /// Share of ticks on which the controller acts.
    pub active: f64,
}

impl Measures {
    /// Measures of `trace`.
    pub fn of(trace: &Trace) -> Self {
        let first = first_contact(trace);
        let settled = settled(trace);
        let active = trace.alpha.iter().filter(|&&alpha| alpha > 0.0).count();
        let taken = taken(trace);
        let contact = first.clone().unwrap_or(0..0);
        let start = trace.x.first().copied().unwrap_or(START).abs();
        Self {
            scale: start / START.abs(),
            bounded: trace.x.iter().all(|x| x.abs() <= BOUND * start),
            settled: settled.map(|tick| tick as f64 * trace.period),
            force_peak: largest(&trace.force[contact.clone()]),
            reply: reply(trace, contact.end),
            energy_peak: largest(&trace.observed_energy),
            energy_end: trace.observed_energy.last().copied().unwrap_or(0.0),
            swing: trace.x[contact.end..].iter().fold(0.0, |most, x| x.abs().max(most)),
            jitter: settled.and_then(|tick| jitter(trace, tick)),
            impulsiveness: impulsiveness(trace),
            taken,
            taken_per_sample: (active > 0).then(|| taken / active as f64),
            active: active as f64 / trace.x.len() as f64,
        }
    }
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(0.0, f64::max)
}

/// The first consecutive ticks on which the wall pushes.
fn first_contact(trace: &Trace) -> Option<std::ops::Range<usize>> {
    let start = trace.force.iter().position(|&force| force > 0.0)?;
    let length = trace.force[start..].iter().position(|&force| force <= 0.0);
    Some(start..length.map_or(trace.force.len(), |length| start + length))
}

/// The tick from which on `|x|` stays within 5 % of the start.
fn settled(trace: &Trace) -> Option<usize> {
    let band = 0.05 * trace.x.first()?.abs();
    let inside = trace.x.iter().rev().take_while(|x| x.abs() <= band).count();
    (inside > 0).then(|| trace.x.len() - inside)
}

/// The controller's largest force within 0.1 s from `tick` on, with its sign.
fn reply(trace: &Trace, tick: usize) -> f64 {
    let end = trace.x.len().min(tick + (0.1 / trace.period).round() as usize);
    (tick.min(end)..end)
        .map(|tick| trace.alpha[tick] * trace.v[tick])
        .fold(0.0, |most: f64, force| if force.abs() > most.abs() { force } else { most })
}

/// RMS velocity over the second from `tick` on.
fn jitter(trace: &Trace, tick: usize) -> Option<f64> {
    let second = trace.v.get(tick..tick + trace.period.recip().round() as usize)?;
    let squares: f64 = second.iter().map(|v| v * v).sum();
    Some((squares / second.len() as f64).sqrt())
}

/// Largest over median booked step of active ticks. The booked steps are needed because at rest they are far below the
/// last digit of the observed energy.
fn impulsiveness(trace: &Trace) -> Option<f64> {
    let ticks = trace.alpha.iter().zip(&trace.booked);
    let steps = ticks.filter(|(alpha, _)| **alpha > 0.0).map(|(_, booked)| booked.abs());
    let most = steps.clone().fold(0.0, f64::max);
    let median = median(steps)?;
    (median > 0.0).then(|| most / median)
}

/// Work of the controller's held force over the true displacement.
fn taken(trace: &Trace) -> f64 {
    (1..trace.x.len())
        .map(|tick| trace.alpha[tick - 1] * trace.v[tick - 1] * (trace.x[tick] - trace.x[tick - 1]))
        .sum()
}

/// Median of the numbers; of an even count the mean of the two in the middle.
pub fn median(numbers: impl Iterator<Item = f64>) -> Option<f64> {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    let (low, high) = (sorted.len().checked_sub(1)? / 2, sorted.len() / 2);
    Some(0.5 * (sorted[low] + sorted[high]))
}
