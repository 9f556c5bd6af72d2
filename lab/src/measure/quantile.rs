//! Quantiles of numbers.

/// Median of the numbers; of an even count the mean of the two in the middle.
pub fn median(numbers: impl Iterator<Item = f64>) -> Option<f64> {
    quantile(numbers, 0.5)
}

/// Quantile of the numbers, on the straight line between the two neighbours.
pub(crate) fn quantile(numbers: impl Iterator<Item = f64>, share: f64) -> Option<f64> {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let place = share * sorted.len().checked_sub(1)? as f64;
    let (low, high) = (place.floor() as usize, place.ceil() as usize);
    Some(sorted[low] + place.fract() * (sorted[high] - sorted[low]))
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn quantiles_lie_between_their_neighbours() {
        let numbers = || [3.0, 1.0, 2.0, 4.0].into_iter();
        assert_eq!(median(numbers()), Some(2.5));
        assert_eq!(median(numbers().take(3)), Some(2.0));
        assert_eq!(quantile(numbers(), 0.0).zip(quantile(numbers(), 1.0)), Some((1.0, 4.0)));
        assert_abs_diff_eq!(quantile(numbers(), 0.1).unwrap(), 1.3, epsilon = 1e-12);
        assert_eq!(median(std::iter::empty()), None);
    }
}
