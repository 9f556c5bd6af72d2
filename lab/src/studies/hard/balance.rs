//! The energy balance of a port, kept outside of the library with about 32 digits.

/// The energies that a correction reports on one tick, J.
#[derive(Clone, Copy, Debug)]
pub(super) struct Told {
    /// The observed energy `L(n)`.
    pub(super) sum: f64,
    /// Energy that the correction is to dissipate, `α v² T`, J.
    pub(super) dissipated: f64,
    /// The part of the debt that the correction cannot serve.
    pub(super) shortfall: f64,
}

/// Sum of the energies that crossed a port, to twice the digits; it checks the energies that a correction reports.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Balance {
    supplied: Double,
    absolute: f64,
    largest: f64,
    ticks: f64,
    /// Energy that corrections were to dissipate, where the ledger takes it for done, J.
    served: f64,
    /// The rounding unit of the ledger's scalar.
    unit: f64,
    /// The rounding of a tick below the smallest normal number of that scalar, where numbers round by more than the unit, J.
    underflow: f64,
    /// The same of all ticks. It is summed, since the processor takes a hundred times as long for a product of such numbers.
    underflows: f64,
}

impl Balance {
    /// Balance for a scalar with the rounding unit `unit` and the smallest normal number `tiny`, starting at `budget`
    /// joules.
    pub(super) fn new(unit: f64, tiny: f64, budget: f64) -> Self {
        let (supplied, absolute, largest) = (budget.into(), budget, budget);
        // Works below the smallest normal number are rounded by up to half of the smallest positive one.
        let underflow = 4.0 * tiny * unit;
        let (ticks, served, underflows) = (0.0, 0.0, 0.0);
        Self { supplied, absolute, largest, ticks, served, unit, underflow, underflows }
    }

    /// All work and credit so far, J.
    pub(super) fn supplied(&self) -> f64 {
        self.supplied.value()
    }

    /// The sum of the magnitudes of all works and credits, J.
    pub(super) fn size(&self) -> f64 {
        self.absolute
    }

    /// Books the works and credits of a tick if they are finite, as a ledger does. A credit that is the difference of a
    /// stored energy is rounded like that energy; `held` is that energy, J.
    #[inline]
    pub(super) fn book(&mut self, terms: &[Double], held: f64) {
        let sum = terms.iter().fold(Double::default(), |sum, term| sum.plus(*term));
        if sum.value().is_finite() {
            self.supplied = self.supplied.plus(sum);
            self.absolute += terms.iter().map(|term| term.value().abs()).sum::<f64>();
        }
        self.largest = self.largest.max(self.supplied().abs()).max(held.abs());
        self.ticks += 1.0;
        self.underflows += self.underflow;
    }

    /// Allows for the margin of a correction that is to dissipate `energy` joules, of which a ledger books the exact
    /// debt: a served debt is exceeded by 4 ε of it and the roundings of a step, by less than 8 ε.
    pub(super) fn allow(&mut self, energy: f64) {
        self.served += energy;
    }

    /// Error of the balance `supplied = stored − dissipated − shortfall`, as a share of the allowed
    /// `4 u (Σ |work| + ticks · largest stored)`.
    pub(super) fn off(&self, told: Told) -> f64 {
        let stored = told.sum.max(0.0);
        let owed = Double::from(told.dissipated).plus(told.shortfall.into());
        let error = self.supplied.plus(owed).plus((-stored).into()).value().abs();
        self.share(error, self.served.max(told.dissipated))
    }

    /// Observed energy reported beyond what was supplied, as the same share: the only error of a ledger that may forget
    /// credit.
    pub(super) fn over(&self, told: Told) -> f64 {
        self.share((-self.supplied.plus((-told.sum).into()).value()).max(0.0), self.served)
    }

    /// Share of the allowed error that `error` is, where corrections are to dissipate `served` joules.
    fn share(&self, error: f64, served: f64) -> f64 {
        let sums = self.absolute + self.ticks * self.largest;
        let rounding = 4.0 * self.unit * sums + 16.0 * self.unit * served;
        error / (rounding + self.underflows)
    }
}

/// An unevaluated sum of two `f64`: a number and its rounding error (Dekker, Numerische Mathematik 18, 1971).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// The product of two `f64`, exact where nothing underflows.
    pub(super) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    /// This times `factor`.
    pub(super) fn times(self, factor: f64) -> Self {
        let product = Self::product(self.high, factor);
        Self::normal(product.high, product.low + self.low * factor)
    }

    /// This plus `other`.
    pub(super) fn plus(self, other: Self) -> Self {
        let high = self.high + other.high;
        let share = high - self.high;
        let error = (self.high - (high - share)) + (other.high - share);
        Self::normal(high, error + (self.low + other.low))
    }

    /// The nearest `f64`.
    pub(super) fn value(self) -> f64 {
        self.high
    }

    fn normal(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: f64 = f64::EPSILON / 2.0;

    fn after(works: &[(f64, f64)]) -> Balance {
        let mut balance = Balance::new(UNIT, f64::MIN_POSITIVE, 0.0);
        works
            .iter()
            .for_each(|(force, moved)| balance.book(&[Double::product(*force, *moved)], 0.0));
        balance
    }

    #[test]
    fn a_true_balance_closes_and_one_that_hides_a_thousandth_does_not() {
        let told = |sum, dissipated, shortfall| Told { sum, dissipated, shortfall };
        let stored = after(&[(2.0, 0.5), (-1.0, 0.25)]);
        assert_eq!(stored.off(told(0.75, 0.0, 0.0)), 0.0);
        assert!(stored.off(told(0.75 + 1e-3, 0.0, 0.0)) > 1e6);
        // A debt may be dissipated, left as shortfall, or both; the observed energy may not hide it.
        let owed = after(&[(2.0, 0.5), (-3.0, 0.5)]);
        assert_eq!(owed.off(told(-0.5, 0.25, 0.25)), 0.0);
        assert!(owed.off(told(-0.5, 0.25, 0.0)) > 1e6);
        assert!(owed.off(told(0.0, 0.0, 0.0)) > 1e6);
    }

    /// 1e16 + 1 − 1e16: a plain sum gives 0.
    #[test]
    fn the_balance_keeps_what_a_plain_sum_rounds_away() {
        assert_eq!(after(&[(1e8, 1e8), (1.0, 1.0), (-1e8, 1e8)]).supplied(), 1.0);
    }

    #[test]
    fn works_that_are_not_finite_are_not_booked() {
        assert_eq!(after(&[(1.0, 1.0), (f64::NAN, 1.0), (f64::MAX, 1e9)]).supplied(), 1.0);
    }
}
