//! Transitions between sticking and sliding.

use lyapunov_core::{Mask, Scalar};

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

/// The transitions of the last period.
#[derive(Clone, Copy, Debug)]
pub struct Transitions<T> {
    count: T,
    instants: [T; KEPT],
    kinds: [T; KEPT],
}

impl<T: Scalar> Transitions<T> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self { count: T::zero(), instants: [T::zero(); KEPT], kinds: [T::zero(); KEPT] }
    }

    /// Adds a transition in the lanes `of`.
    #[inline(always)]
    pub(super) fn note(&mut self, of: T::Mask, instant: T, transition: Transition) {
        if !of.any() {
            return;
        }
        let only = |new: T, kept: T| T::choose(of, new, kept);
        for list in
            [(&mut self.instants, instant), (&mut self.kinds, T::of(transition as u8 as f64))]
        {
            let (list, last) = list;
            for at in 1..KEPT {
                list[at - 1] = only(list[at], list[at - 1]);
            }
            list[KEPT - 1] = only(last, list[KEPT - 1]);
        }
        self.count = only(self.count + T::one(), self.count);
    }

    /// Forgets the transitions of the lanes `of`.
    #[inline(always)]
    pub(super) fn clear(&mut self, of: T::Mask) {
        self.count = T::choose(of, T::zero(), self.count);
    }

    /// Sets lane `lane` to those of a motion by itself.
    pub(super) fn set(&mut self, lane: usize, log: &Transitions<f64>) {
        set(&mut self.count, lane, log.count);
        for at in 0..KEPT {
            set(&mut self.instants[at], lane, log.instants[at]);
            set(&mut self.kinds[at], lane, log.kinds[at]);
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
#[inline(always)]
pub(super) fn set<T: Scalar>(scalar: &mut T, lane: usize, value: f64) {
    let all = *scalar;
    *scalar = T::from_lanes(|index| if index == lane { value } else { all.lane(index) });
}
