//! Forces that act some rows after their own.

use std::collections::VecDeque;

use crate::files::log::Entry;

/// The forces of the last rows, which act on the rows to come.
#[derive(Debug)]
pub(super) struct Late {
    rows: usize,
    waiting: VecDeque<Option<f64>>,
}

impl Late {
    pub(super) fn by(rows: u32) -> Self {
        Self { rows: rows as usize, waiting: VecDeque::new() }
    }

    /// The force that acts from the row of `entry` on, if the row that it stands in tells it; none on the first rows, where forces from
    /// before the log act.
    pub(super) fn acting(&mut self, entry: &Entry<'_>) -> Option<Option<f64>> {
        self.waiting.push_back(match entry {
            Entry::Good(row) => Some(row.f),
            Entry::Bad(bad) => bad.force,
        });
        if self.waiting.len() > self.rows { self.waiting.pop_front() } else { None }
    }
}
