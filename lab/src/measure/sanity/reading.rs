//! Readings of a log that look bad: a position that jumps for one row, and a force with an offset.

use super::{Oddity, Sign};
use crate::files::log::Sample;
use crate::text::{found, prefixed};

/// Factor by which a jump is longer than the steps beside it, and than any other of the log.
const JUMP: f64 = 10.0;

/// Most by which the way back may differ from the jump, as a share.
const BACK: f64 = 0.5;

/// Fewest rows in motion that tell an offset.
const ROWS: u64 = 20;

/// Jump of the position for one row, and the largest step without jumps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    /// Times and positions of the last four rows.
    rows: [(f64, f64); 4],
    size: f64,
    time: f64,
    largest: f64,
}

impl Default for Jump {
    fn default() -> Self {
        Self { rows: [(f64::NAN, f64::NAN); 4], size: 0.0, time: 0.0, largest: 0.0 }
    }
}

impl Jump {
    pub(super) fn add(&mut self, row: &Sample) {
        let [first, second, mut third, fourth] = self.rows;
        let (before, after) = (second.1 - first.1, row.x - fourth.1);
        let (out, back) = (third.1 - second.1, fourth.1 - third.1);
        let is_long = |step: f64| step.abs() > JUMP * (before.abs() + after.abs());
        if is_long(out) && is_long(back) && (out + back).abs() < BACK * out.abs() {
            if out.abs() > self.size.abs() {
                (self.size, self.time) = (out, third.0);
            }
            // What the reading should have been, about.
            third.1 = second.1.midpoint(fourth.1);
        }
        self.largest = self.largest.max(before.abs());
        self.rows = [second, third, fourth, (row.t, row.x)];
    }

    /// A jump that nothing else in the log comes near: an encoder that flickers by a step moves by as much elsewhere.
    pub(super) fn finish(&self) -> Option<Oddity> {
        let is_bad = self.largest > 0.0 && self.size.abs() > JUMP * self.largest;
        is_bad.then(|| {
            let (size, time) = (prefixed(self.size, "m"), found(self.time));
            Oddity::new(
                Sign::Reading,
                format!("x jumps by {size} for one row at t = {time} s: a bad reading"),
            )
        })
    }
}

/// The force that most rows in motion hold, by the vote of Boyer and Moore: at rest a sound force stands as well.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Offset {
    force: f64,
    votes: u64,
    /// Rows that held it since it was last voted for anew.
    held: u64,
    rows: u64,
    touches_zero: bool,
}

impl Offset {
    pub(super) fn add(&mut self, displacement: f64, force: f64) {
        self.touches_zero |= force == 0.0;
        if displacement == 0.0 {
            return;
        }
        self.rows += 1;
        if self.votes == 0 {
            (self.force, self.held) = (force, 0);
        }
        if force == self.force {
            self.votes += 1;
            self.held += 1;
        } else {
            self.votes -= 1;
        }
    }

    /// The offset of a log whose forces reach `largest`, N, where a clipped force stands.
    pub(super) fn finish(&self, largest: f64) -> Option<Oddity> {
        let Self { force, held, rows, .. } = *self;
        let is_most = force.abs() == largest;
        let is_offset = held >= ROWS && 2 * held > rows && !self.touches_zero && !is_most;
        is_offset.then(|| {
            let text =
                format!("f is {} in {held} rows: an offset? subtract it", prefixed(force, "N"));
            Oddity::new(Sign::Reading, text)
        })
    }
}
