//! Confidence interval of a share.

use crate::studies::chance::at_least;

/// Share of the error on either side of an interval of 95 %.
const TAIL: f64 = 0.025;

/// Halvings of an interval: more than f64 has digits.
const HALVINGS: usize = 60;

/// The interval of Clopper and Pearson that holds the true share with 95 % confidence or more, where `held` of `of`
/// independent members hold.
///
/// Its lower end is the share at which so many or more hold with a probability of 2.5 %, its upper end the one at
/// which so many or fewer do. (C. J. Clopper and E. S. Pearson, The use of confidence or fiducial limits illustrated in
/// the case of the binomial, *Biometrika* 26(4), 1934.)
pub fn clopper_pearson(held: usize, of: usize) -> [f64; 2] {
    let low = if held == 0 { 0.0 } else { share_at(|share| at_least(held, of, share) < TAIL) };
    let high = match held < of {
        true => share_at(|share| 1.0 - at_least(held + 1, of, share) > TAIL),
        false => 1.0,
    };
    [low, high]
}

/// The share up to which `is_below` holds.
fn share_at(is_below: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_below(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn the_ends_have_closed_forms_where_none_or_all_hold() {
        for of in [1, 7, 101, 1000, 100_000] {
            let root = TAIL.powf(1.0 / of as f64);
            let [none, all] = [clopper_pearson(0, of), clopper_pearson(of, of)];
            assert_eq!((none[0], all[1]), (0.0, 1.0));
            assert_abs_diff_eq!(none[1], 1.0 - root, epsilon = 1e-9);
            assert_abs_diff_eq!(all[0], root, epsilon = 1e-9);
        }
    }

    /// The rows for 10 trials of Clopper and Pearson's interval, as tables of it print them.
    #[test]
    fn the_interval_is_that_of_the_tables() {
        for (held, low, high) in [(1, 0.0025, 0.4450), (3, 0.0667, 0.6525), (5, 0.1871, 0.8129)] {
            let interval = clopper_pearson(held, 10);
            assert_abs_diff_eq!(interval[0], low, epsilon = 5e-5);
            assert_abs_diff_eq!(interval[1], high, epsilon = 5e-5);
            let others = clopper_pearson(10 - held, 10);
            assert_abs_diff_eq!(interval[0], 1.0 - others[1], epsilon = 1e-12);
        }
    }

    /// The share of all outcomes of `of` trials whose interval holds the true share, from exact binomials.
    #[test]
    fn the_interval_covers_at_least_as_often_as_it_says() {
        let of = 30_u32;
        for percent in 1..100 {
            let share = f64::from(percent) / 100.0;
            let mut ways = 1_u128;
            let mut covered = 0.0;
            for held in 0..=of {
                let [low, high] = clopper_pearson(held as usize, of as usize);
                if (low..=high).contains(&share) {
                    let other = (1.0 - share).powi((of - held) as i32);
                    covered += ways as f64 * share.powi(held as i32) * other;
                }
                ways = ways * u128::from(of - held) / u128::from(held + 1);
            }
            assert!(covered >= 0.95, "{covered} at {share}");
        }
    }
}
