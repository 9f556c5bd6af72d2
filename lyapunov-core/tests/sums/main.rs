//! Sums, ledgers, samples and numbers against whole numbers and closed forms: what a mutated line breaks.
//!
//! The oracle is integer arithmetic. Few types and no dependency: a changed line is built and tested in seconds
//! (scripts/mutants.sh).

mod accumulators;
mod double_double;
mod ledger;
mod numbers;
mod samples;

/// Whole numbers by splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
struct Dice(u64);

impl Dice {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// A whole number of up to so many `bits` and either sign, small ones as often as large ones.
    fn whole(&mut self, bits: u32) -> i64 {
        let size = self.bits() >> 1 >> (63 - bits) >> (self.bits() % u64::from(bits));
        if self.bits() & 1 == 0 { size as i64 } else { -(size as i64) }
    }
}
