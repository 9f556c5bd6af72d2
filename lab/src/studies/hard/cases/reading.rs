//! Samples that come late, twice, or not at all.

use lyapunov::{HeldTick, OnePort, ParameterError, Plant, PortSample, Scalar, Stabilizer};

use super::faults::{MASS, PERIOD, STIFFNESS, TICKS, hand, reach, wall};
use crate::files::scene::Basis;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{Play, Played};

/// Fault of one reading, at tick `k`.
#[derive(Clone, Copy, PartialEq)]
enum Slip {
    /// The reading is that of the tick before.
    Stale,
    /// The loop is called twice with one reading.
    Repeated,
    /// The loop is not called; the force holds.
    Dropped,
    /// The reading is that of the tick before, here and on the next tick.
    Late,
}

/// Maker of samples from positions that a program reads, each from the reading before to this one.
struct Reader<T> {
    last: T,
    applied: T,
}

impl<T: Scalar> Reader<T> {
    fn sample(&mut self, position: T, ticks: f64) -> PortSample<T> {
        let period = T::of(PERIOD * ticks);
        let displacement = position - self.last;
        self.last = position;
        HeldTick {
            period,
            position,
            velocity: displacement / period,
            displacement,
            applied: self.applied,
        }
        .sample()
    }
}

impl Play for Slip {
    /// Run `k` slips at tick `k`. Returns the error of the work booked from the readings, J.
    fn play<T: Scalar>(
        &self,
        index: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        let mut plant = hand::<T>(first)?;
        let mut port = wall::<T>()?.stabilized(stabilizer);
        let start = plant.start().position;
        let mut reader = Reader { last: start, applied: T::zero() };
        let (mut now, mut before, mut missed) = (start, start, 0.0);
        let (mut booked, mut truth) = (T::zero(), T::zero());
        for tick in 0..TICKS {
            let slips = tick == index;
            let late = *self == Slip::Late && tick == index + 1;
            let reading = match self {
                Slip::Stale | Slip::Late if slips => before,
                _ if late => before,
                _ => now,
            };
            let mut effort = reader.applied;
            if *self == Slip::Dropped && slips {
                missed = 1.0;
            } else {
                let calls = if *self == Slip::Repeated && slips { 2 } else { 1 };
                for _ in 0..calls {
                    let sample = reader.sample(reading, 1.0 + missed);
                    booked += sample.work;
                    effort = port.respond(&sample);
                    missed = 0.0;
                }
            }
            reader.applied = effort;
            before = now;
            let moved = plant.advance(effort);
            now = moved.position;
            truth += moved.work;
        }
        // The last tick's work has not been read yet.
        booked += reader.applied * (now - reader.last);
        Ok((booked - truth).magnitude())
    }

    fn runs(&self) -> u64 {
        TICKS
    }

    fn basis(&self) -> Basis {
        Basis::of_hand(MASS, PERIOD, 0.1)
    }

    fn terms(&self, limit: f64) -> Terms {
        Terms::of(TICKS, limit)
    }
}

pub(super) fn cases() -> Vec<Case> {
    let swing = |name, hard, slip| Case {
        name,
        theme: "samples",
        hard,
        quantity: Quantity::SWING,
        bound: 1e3 * reach(),
        apart: None,
        trial: Box::new(Played(slip)),
    };
    let misread = |name, bound, slip| Case {
        quantity: Quantity { words: "misread work", unit: "mJ", of: |tally| 1e3 * tally.value },
        bound,
        ..swing(name, "the same runs: the work booked against that of the true motion", slip)
    };
    // A reading that is a tick off books one displacement, v T, under the force of another tick. The two forces differ
    // by at most k v T plus the largest correction, v m / 2 T; in mJ.
    let speed = 0.1;
    let change = STIFFNESS * speed * PERIOD + 0.5 * speed * MASS / PERIOD;
    let slip = 1e3 * change * speed * PERIOD;
    vec![
        swing(
            "a stale sample",
            "the reading of the tick before, at each of 120 ticks",
            Slip::Stale,
        ),
        misread("a stale sample: work", slip, Slip::Stale),
        swing("a sample twice", "one reading, two calls, at each of 120 ticks", Slip::Repeated),
        misread("a sample twice: work", slip, Slip::Repeated),
        swing(
            "a dropped sample",
            "no call, at each of 120 ticks; the next spans two",
            Slip::Dropped,
        ),
        misread("a dropped sample: work", 1e-6, Slip::Dropped),
        swing("a late sample", "a reading comes with the next tick, at each of 120", Slip::Late),
        misread("a late sample: work", 2.0 * slip, Slip::Late),
    ]
}
