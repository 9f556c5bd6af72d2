//! Course of an observed energy over a log.

use serde::Serialize;

/// Number of debts that are reported one by one; the rest are only counted.
const TOLD: usize = 10;

/// A stretch with an observed energy below zero.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Debt {
    /// Time of the first row below zero, s.
    pub start: f64,
    /// Time of the next row that is not below zero, s; none if the log ends before.
    pub end: Option<f64>,
    /// Lowest value, J.
    pub lowest: f64,
}

/// Course of an observed energy, which is 0 on the first row.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ObservedEnergy {
    /// Value on the last row, J.
    #[serde(rename = "final")]
    pub last: f64,
    /// Lowest value, J; at most 0.
    pub lowest: f64,
    /// Time of the lowest value, s.
    pub lowest_at: f64,
    /// Time of the first row below zero, s; none if there is no such row.
    pub negative_at: Option<f64>,
    /// The number of times that it went below zero.
    pub debts: u64,
    /// The first ten stretches below zero.
    pub first_debts: Vec<Debt>,
    #[serde(skip)]
    open: Option<Debt>,
}

impl ObservedEnergy {
    /// Course that starts on the first row, at `time`.
    pub(super) fn starting(time: f64) -> Self {
        Self { lowest_at: time, ..Self::default() }
    }

    pub(super) fn add(&mut self, time: f64, value: f64) {
        self.last = value;
        if value < self.lowest {
            (self.lowest, self.lowest_at) = (value, time);
        }
        if value < 0.0 {
            if self.open.is_none() {
                self.negative_at.get_or_insert(time);
                self.debts += 1;
            }
            let debt = self.open.get_or_insert(Debt { start: time, end: None, lowest: value });
            debt.lowest = debt.lowest.min(value);
        } else if let Some(debt) = self.open.take() {
            self.tell(Debt { end: Some(time), ..debt });
        }
    }

    /// The whole trajectory, including a debt at the end of the log.
    pub(super) fn finish(mut self) -> Self {
        if let Some(debt) = self.open.take() {
            self.tell(debt);
        }
        self
    }

    fn tell(&mut self, debt: Debt) {
        if self.first_debts.len() < TOLD {
            self.first_debts.push(debt);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn debts_begin_below_zero_and_end_at_zero() {
        let mut sum = ObservedEnergy::starting(0.0);
        for (n, value) in [0.0, 1.0, -1.0, -3.0, -2.0, 0.0, 1.0, -0.5].into_iter().enumerate() {
            sum.add(n as f64, value);
        }
        let sum = sum.finish();
        assert_eq!((sum.last, sum.lowest, sum.lowest_at), (-0.5, -3.0, 3.0));
        assert_eq!((sum.negative_at, sum.debts), (Some(2.0), 2));
        let expected = [
            Debt { start: 2.0, end: Some(5.0), lowest: -3.0 },
            Debt { start: 7.0, end: None, lowest: -0.5 },
        ];
        assert_eq!(sum.first_debts, expected);
    }
}
