//! Motion through one period, from event to event.

use super::Transition::{Cut, Reverse, Slip, Stick};
use super::root::{Polynomial, first_fall};
use super::series::{Series, System};
use super::transition::Log;

/// Most pieces of a period.
const PIECES: usize = 1024;

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Stuck,
    /// Sliding in the direction ±1.
    Sliding(f64),
}

/// The motion through one period, in one lane.
pub(super) struct Trajectory<'a, const S: usize> {
    system: &'a System<S>,
    state: [f64; S],
    elapsed: f64,
    remaining: f64,
    /// The total gain, without the rounding of adding it to a deflection.
    pub(super) gain: [f64; S],
    /// The energy that friction dissipated, J.
    pub(super) heat: f64,
    pub(super) log: Log,
}

impl<'a, const S: usize> Trajectory<'a, S> {
    /// The motion from `state` through `interval` s.
    pub(super) fn run(system: &'a System<S>, state: [f64; S], interval: f64) -> Self {
        let (gain, log) = ([0.0; S], Log::default());
        let mut trajectory =
            Self { system, state, elapsed: 0.0, remaining: interval, gain, heat: 0.0, log };
        let mut phase = match state[S - 1] {
            0.0 => trajectory.at_rest(),
            velocity => Phase::Sliding(velocity.signum()),
        };
        if state[S - 1] == 0.0 && phase != Phase::Stuck && interval > 0.0 {
            trajectory.log.note(0.0, Slip);
        }
        for _ in 0..PIECES {
            if trajectory.remaining <= 0.0 {
                break;
            }
            let next = match phase {
                Phase::Stuck => trajectory.stick(),
                Phase::Sliding(sense) => trajectory.slide(sense),
            };
            match next {
                Some(next) => phase = next,
                None => break,
            }
        }
        if trajectory.remaining > 0.0 {
            trajectory.log = Log::default();
            trajectory.log.note(0.0, Cut);
        }
        trajectory
    }

    /// Whether it reached the end of the period.
    pub(super) fn complete(&self) -> bool {
        self.remaining <= 0.0
    }

    /// Entry `index` of the state, a velocity. It is not a sum of gains: a device at rest has exactly 0.
    pub(super) fn velocity(&self, index: usize) -> f64 {
        self.state[index]
    }

    /// The phase of a device that has come to rest.
    fn at_rest(&self) -> Phase {
        let force = self.system.force(&self.state);
        if force.abs() <= self.system.law.breakaway {
            Phase::Stuck
        } else {
            Phase::Sliding(force.signum())
        }
    }

    fn stick(&mut self) -> Option<Phase> {
        let series = self.system.stick(&self.state, self.remaining)?;
        let force = self.system.force_series(&series);
        let breakaway = self.system.law.breakaway;
        let slip = |sense: f64| {
            let mut reserve = force.map(|coefficient| -sense * coefficient);
            // A force within a rounding above static friction counts as equal to it: this device was just found to
            // stick.
            reserve[0] = (reserve[0] + breakaway).max(0.0);
            first_fall(&reserve).map(|share| (share, sense))
        };
        let first = match (slip(1.0), slip(-1.0)) {
            (Some(forwards), Some(back)) if back.0 < forwards.0 => Some(back),
            (None, back) => back,
            (forwards, _) => forwards,
        };
        self.pass(&series, first.map_or(1.0, |(share, _)| share));
        Some(match first {
            None => Phase::Stuck,
            Some((_, sense)) => {
                self.log.note(self.elapsed, Slip);
                Phase::Sliding(sense)
            }
        })
    }

    fn slide(&mut self, sense: f64) -> Option<Phase> {
        let start = self.state[S - 1];
        let series = self.system.slide(&self.state, sense, self.remaining)?;
        let floor = self.system.law.constant_above(start.abs()).unwrap_or(0.0);
        let mut above: Polynomial = series.state[S - 1].map(|coefficient| sense * coefficient);
        above[0] -= floor;
        let fall = first_fall(&above);
        self.heat += series.heat(fall.unwrap_or(1.0));
        self.pass(&series, fall.unwrap_or(1.0));
        let stopped = floor == 0.0 && fall.is_some();
        if !stopped && sense * self.state[S - 1] > 0.0 {
            return Some(Phase::Sliding(sense));
        }
        self.state[S - 1] = 0.0;
        let next = match self.at_rest() {
            // The device did not leave rest: the force equals static friction within rounding, and falls.
            Phase::Sliding(_) if start == 0.0 && fall == Some(0.0) => Phase::Stuck,
            next => next,
        };
        match next {
            Phase::Stuck => self.log.note(self.elapsed, Stick),
            // At the end of the period the next effort decides.
            Phase::Sliding(towards) if towards != sense && self.remaining > 0.0 => {
                self.log.note(self.elapsed, Reverse);
            }
            Phase::Sliding(_) => {}
        }
        Some(next)
    }

    /// Moves on by `share` of the step.
    fn pass(&mut self, series: &Series<S>, share: f64) {
        for (index, value) in self.state.iter_mut().enumerate() {
            let gain = series.gain(index, share);
            *value += gain;
            self.gain[index] += gain;
        }
        let passed = share * series.step;
        self.elapsed += passed;
        self.remaining -= passed;
    }
}
