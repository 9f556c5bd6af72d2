//! Every accumulator against whole numbers, and the digits that a compensated one keeps.

use lyapunov_core::{Accumulator, Compensated, Plain, Snapshot, Wide};

use crate::Dice;

/// Numbers that every accumulator represents: each call does what it does to a whole number.
fn counts<A: Accumulator<f64>>() {
    let mut dice = Dice(7);
    let (mut sum, mut exact) = (A::zero(), 0i64);
    for tick in 0..5000 {
        let [term, most] = [dice.whole(20), dice.whole(20).abs()];
        match dice.bits() % 8 {
            0 => {
                sum.lower(most as f64);
                exact = exact.min(most);
            }
            1 if tick % 50 == 0 => {
                sum.clear();
                exact = 0;
            }
            2 | 3 => {
                sum.add(term as f64);
                exact += term;
            }
            _ => {
                exact += term;
                assert_eq!(sum.add_and_raise(term as f64, most as f64), exact as f64);
                exact = exact.max((exact + most).min(0));
            }
        }
        assert_eq!(sum.value(), exact as f64, "tick {tick}");
    }
    sum.clear();
    assert_eq!((sum.value(), A::zero().value()), (0.0, 0.0));
}

#[test]
fn whole_numbers_are_summed_without_error() {
    counts::<Plain<f64>>();
    counts::<Compensated<f64>>();
    counts::<Wide<f64>>();
}

/// Terms of 24 bits, whose exact sum is a whole number of grains: the value is off by a rounding of its own, and by
/// `4 u²` of the largest sum for each term.
#[test]
fn a_compensated_sum_keeps_the_digits_of_the_remainder() {
    let (grain, unit) = (2f64.powi(-30), 2f64.powi(-24));
    for seed in 1..20 {
        let (mut dice, mut sum) = (Dice(seed), Compensated::<f32>::zero());
        let (mut exact, mut largest) = (0i64, 0i64);
        for tick in 1..2000 {
            // Back to almost nothing every now and then, in terms that fit.
            let back = tick % 40 > 20;
            let term = if back { -(exact.clamp(-0xff_ffff, 0xff_ffff)) } else { dice.whole(24) };
            match dice.bits() % 3 {
                // What is owed stays owed: nothing is raised.
                0 => {
                    let between = sum.add_and_raise((term as f64 * grain) as f32, 0.0);
                    assert_eq!(between, sum.value());
                }
                _ => sum.add((term as f64 * grain) as f32),
            }
            exact += term;
            largest = largest.max(exact.abs());
            let off = (f64::from(sum.value()) - exact as f64 * grain).abs();
            let lost = f64::from(tick) * 4.0 * unit * unit * largest as f64 * grain;
            let bound = unit * exact.abs() as f64 * grain + lost;
            assert!(off <= bound, "off by {off:e}, {bound:e} allowed, seed {seed}, tick {tick}");
        }
    }
}

/// A debt that is raised keeps the digits below those of the sum.
#[test]
fn raising_and_lowering_keep_or_forget_what_was_gathered() {
    let small = 2f32.powi(-30);
    let mut sum = Compensated::<f32>::zero();
    [-2.0, small].into_iter().for_each(|term| sum.add(term));
    assert_eq!(sum.add_and_raise(0.0, 1.0), -2.0);
    sum.add(1.0);
    assert_eq!(sum.value(), small, "raised by 1 and by 1, of a debt of 2 less a little");
    // Lowered to a number it is that number: no error stays.
    let mut sum = Compensated::<f32>::zero();
    [1.0, small].into_iter().for_each(|term| sum.add(term));
    sum.lower(0.5);
    sum.add(-0.5);
    assert_eq!(sum.value(), 0.0);
    // Not lowered it stays whole, digits and all.
    [1.0, small].into_iter().for_each(|term| sum.add(term));
    sum.lower(2.0);
    sum.add(-1.0);
    assert_eq!(sum.value(), small);
}

/// At the end of the range, in quarters of its last place, where the largest number is 2⁵⁵ − 4: what is booked leaves a finite
/// sum, which is the nearest number if it `keeps_digits`; what leaves half of the range is booked, and what leaves more than
/// half a place beyond it is not, and changes nothing.
fn has_room<A: Accumulator<f64> + PartialEq>(keeps_digits: bool) {
    let (quarter, largest) = (2f64.powi(969), (1i64 << 55) - 4);
    let (mut dice, mut refused) = (Dice(19), 0);
    // Miri takes minutes over the texts of 300.
    let runs = if cfg!(miri) { 10 } else { 300 };
    for _ in 0..runs {
        let (mut sum, mut exact) = (A::zero(), 0i64);
        for _ in 0..40 {
            let small = dice.whole(3);
            let term = match dice.bits() % 6 {
                0 => largest,
                1 => -largest,
                // To the end, and back to a little below or above 0.
                2 => (largest - exact) & !3,
                3 => (small - exact).clamp(-largest, largest),
                _ => small,
            };
            // Terms are numbers of 53 digits.
            let term = term as f64 as i64;
            let (before, after) = (sum, exact + term);
            let booked = sum.book(term as f64 * quarter);
            let told = format!("{term} after {exact}, {before:?}");
            assert!(booked || after.abs() > 1 << 54, "no room for {told}");
            assert!(!booked || after.abs() <= largest + 2, "room for {told}");
            refused += i32::from(!booked);
            assert!(sum.value().is_finite(), "{told}");
            assert!(booked || sum == before, "{told}");
            if booked {
                let nearest = after as f64 * quarter;
                assert!(!keeps_digits || sum.value() == nearest, "{nearest:e} for {told}");
                exact = if keeps_digits { after } else { (sum.value() / quarter) as i64 };
            }
        }
    }
    assert!(refused > runs, "{refused} only");
}

#[test]
fn what_is_booked_leaves_a_finite_sum() {
    has_room::<Plain<f64>>(false);
    has_room::<Compensated<f64>>(true);
    // Here a double-double has the digits of its first part only.
    has_room::<Wide<f64>>(false);
}

/// Steps that `f32` does not see beside its largest number: a wide sum sees them, and has no room for them.
#[test]
fn a_wide_sum_stays_in_the_range_that_it_is_told_in() {
    let mut sum = Wide::<f32>::zero();
    sum.add(-f32::MAX);
    let mut refused = 0;
    for _ in 0..10 {
        refused += i32::from(!sum.book(-5e30));
        assert_eq!(sum.value(), -f32::MAX);
    }
    // A whole step of the largest number is 2e31; half of one and more would be told as infinite.
    assert!(refused >= 8, "{refused} only");
    assert!(sum.book(f32::MAX));
}

fn is_stored<A: Accumulator<f64> + Snapshot + PartialEq>() {
    let mut sum = A::zero();
    [3.0, 2f64.powi(-60)].into_iter().for_each(|term| sum.add(term));
    assert!(A::zero().restored(sum.state()).is_ok_and(|restored| restored == sum), "{sum:?}");
    sum.add(f64::INFINITY);
    assert!(A::zero().restored(sum.state()).is_err(), "{sum:?}");
}

#[test]
fn sums_are_stored_and_restored_if_they_are_finite() {
    is_stored::<Plain<f64>>();
    is_stored::<Compensated<f64>>();
    is_stored::<Wide<f64>>();
    let fresh = Compensated::<f64>::zero();
    assert!(fresh.restored((1e200, 1e200)).is_ok_and(|sum| sum.value() == 2e200));
    assert!(fresh.restored((f64::MAX, f64::MAX)).is_err(), "they add up to infinity");
}
