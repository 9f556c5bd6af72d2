//! Transitions between sticking and sliding.

use lyapunov_core::Scalar;

/// Transition of a device under friction at an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transition {
    /// It came to rest and stays.
    Stick,
    /// It left rest.
    Slip,
    /// It came to rest and went back at once: the other forces exceed static friction.
    Reverse,
    /// The period had more pieces than its work allows: it was moved over roughly.
    Cut,
}

const KINDS: [Transition; 4] =
    [Transition::Stick, Transition::Slip, Transition::Reverse, Transition::Cut];

/// Number of transitions kept per period.
const KEPT: usize = 4;

/// The transitions of one period in one lane.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Log {
    count: usize,
    last: [(f64, usize); KEPT],
}

impl Log {
    pub(super) fn note(&mut self, instant: f64, transition: Transition) {
        self.last.rotate_left(1);
        self.last[KEPT - 1] = (instant, transition as usize);
        self.count += 1;
    }
}

/// The transitions of the last period.
#[derive(Clone, Copy, Debug)]
pub struct Transitions<T> {
    count: T,
    instants: [T; KEPT],
    kinds: [T; KEPT],
}

impl<T: Scalar> Transitions<T> {
    pub(super) fn none() -> Self {
        Self { count: T::zero(), instants: [T::zero(); KEPT], kinds: [T::zero(); KEPT] }
    }

    pub(super) fn set(&mut self, lane: usize, log: &Log) {
        set(&mut self.count, lane, log.count as f64);
        for (at, &(instant, kind)) in log.last.iter().enumerate() {
            set(&mut self.instants[at], lane, instant);
            set(&mut self.kinds[at], lane, kind as f64);
        }
    }

    /// The number of transitions in lane `lane`; 0 past the last lane.
    pub fn count(&self, lane: usize) -> usize {
        self.count.lane(lane) as usize
    }

    /// The last transitions, four at most, in order: the time since the start of the period, s, and the transition.
    pub fn last(&self, lane: usize) -> impl Iterator<Item = (f64, Transition)> {
        let all = *self;
        let first = KEPT - self.count(lane).min(KEPT);
        (first..KEPT)
            .map(move |at| (all.instants[at].lane(lane), KINDS[all.kinds[at].lane(lane) as usize]))
    }
}

/// Sets lane `lane` of `scalar` to `value`.
pub(super) fn set<T: Scalar>(scalar: &mut T, lane: usize, value: f64) {
    let all = *scalar;
    *scalar = T::from_lanes(|index| if index == lane { value } else { all.lane(index) });
}
