//! Forces that act some rows after their own.

use std::collections::VecDeque;

use crate::files::log::Entry;

/// The forces of the last rows, which act on the rows to come.
#[derive(Debug)]
pub(super) struct Late {
    rows: usize,
    waiting: VecDeque<f64>,
    last: f64,
}

impl Late {
    pub(super) fn by(rows: u32) -> Self {
        Self { rows: rows as usize, waiting: VecDeque::new(), last: 0.0 }
    }

    /// The force that acts from the row of `entry` on; none on the first rows, where forces from before the log act. A bad row
    /// without a force holds the last one.
    pub(super) fn acting(&mut self, entry: &Entry<'_>) -> Option<f64> {
        self.last = match entry {
            Entry::Good(row) => row.f,
            Entry::Bad(bad) => bad.force.unwrap_or(self.last),
        };
        self.waiting.push_back(self.last);
        if self.waiting.len() > self.rows { self.waiting.pop_front() } else { None }
    }
}
