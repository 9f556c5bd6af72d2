//! Numbers that say what chance alone may do.

/// The 97.5 % point of the normal distribution.
const NORMAL: f64 = 1.959_963_984_540_054;

/// Share of cases in which chance alone may make a difference that is told.
const LEVEL: f64 = 0.05;

/// 97.5 % point of Student's distribution: exact at one to four degrees of freedom, from five on 0.2 % too small at most.
///
/// Cornish and Fisher's expansion in 1 / freedom (R. A. Fisher and E. A. Cornish, The percentile points of distributions having
/// known cumulants, *Technometrics* 2(2), 1960).
pub(super) fn student(freedom: f64) -> f64 {
    // There the expansion is up to a quarter too small. The points of 1 to 4.
    const FIRST: [f64; 4] =
        [12.706204736174705, 4.302652729749464, 3.18244630528371, 2.776445105197794];
    if (1.0..=4.0).contains(&freedom) && freedom.fract() == 0.0 {
        return FIRST[freedom as usize - 1];
    }
    let z = NORMAL;
    let (z3, z5) = (z.powi(3), z.powi(5));
    let first = (z3 + z) / 4.0;
    let second = (5.0 * z5 + 16.0 * z3 + 3.0 * z) / 96.0;
    let third = (3.0 * z.powi(7) + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / 384.0;
    z + (first + (second + third / freedom) / freedom) / freedom
}

/// More than chance in `one` against `other`: of so many pairs that differ, where either side is as likely, 5 % of cases or fewer
/// are as uneven.
///
/// The test of McNemar in its exact form, two-sided (Q. McNemar, Note on the sampling error of the difference between correlated
/// proportions or percentages, *Psychometrika* 12(2), 1947).
pub(super) fn is_uneven(one: usize, other: usize) -> bool {
    2.0 * at_least(one.max(other), one + other, 0.5) <= LEVEL
}

/// The probability that `held` or more of `of` hold where each does with probability `share`, inside 0 to 1.
pub(super) fn at_least(held: usize, of: usize, share: f64) -> f64 {
    let (mut logarithm, odds) = (of as f64 * (1.0 - share).ln(), (share / (1.0 - share)).ln());
    let mut sum = 0.0;
    for count in 0..=of {
        if count >= held {
            sum += logarithm.exp();
        }
        logarithm += ((of - count) as f64 / (count + 1) as f64).ln() + odds;
    }
    sum.min(1.0)
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;

    /// The column for 95 %, two-sided, as tables of Student's distribution print it.
    #[test]
    fn the_factor_is_that_of_the_tables() {
        for (freedom, factor) in [(1.0, 12.706), (2.0, 4.303), (3.0, 3.182), (4.0, 2.776)] {
            assert_abs_diff_eq!(student(freedom), factor, epsilon = 5e-4);
        }
        for (freedom, factor) in [(5.0, 2.571), (7.0, 2.365), (10.0, 2.228), (31.0, 2.040)] {
            assert_relative_eq!(student(freedom), factor, max_relative = 2e-3);
        }
        assert_abs_diff_eq!(student(1e9), NORMAL, epsilon = 1e-8);
    }

    /// Closed forms. All pairs fall to one side in one case in 2 to the power of their number less one: 1 / 16 of five, 1 / 32 of
    /// six. One of nine falls to the other side in 2 (1 + 9) / 512 of the cases, one of eight in 2 (1 + 8) / 256.
    #[test]
    fn five_pairs_are_chance_and_six_are_not() {
        for (one, other, uneven) in [
            (0, 0, false),
            (1, 0, false),
            (4, 4, false),
            (5, 0, false),
            (6, 0, true),
            (7, 1, false),
            (8, 1, true),
        ] {
            assert_eq!(is_uneven(one, other), uneven, "{one} {other}");
            assert_eq!(is_uneven(other, one), uneven, "{other} {one}");
        }
    }

    #[test]
    fn so_many_or_more_have_the_sum_of_the_binomial() {
        assert_abs_diff_eq!(at_least(6, 6, 0.5), 1.0 / 64.0, epsilon = 1e-15);
        assert_abs_diff_eq!(at_least(2, 3, 0.25), 10.0 / 64.0, epsilon = 1e-15);
        assert_abs_diff_eq!(at_least(0, 7, 0.3), 1.0, epsilon = 1e-14);
    }
}
