//! Numbers of loops.

use std::slice;

use lyapunov::Scalar;

use super::sure::MODERATE;

/// A number of all loops, or one for each.
#[derive(Clone, Copy, Debug)]
pub enum Numbers<'a> {
    /// The same for all.
    All(f64),
    /// One for each.
    Each(&'a [f64]),
}

impl Numbers<'_> {
    fn values(&self) -> &[f64] {
        match self {
            Self::All(number) => slice::from_ref(number),
            Self::Each(numbers) => numbers,
        }
    }

    /// The numbers of the loops from `first` on; lanes beyond the last loop repeat it.
    pub(super) fn lanes<T: Scalar>(self, first: usize) -> T {
        let values = self.values();
        T::from_lanes(|lane| {
            values.get(first + lane).or(values.last()).copied().unwrap_or(f64::NAN)
        })
    }

    /// The first that is not finite.
    pub(super) fn infinite(self) -> Option<f64> {
        self.values().iter().copied().find(|number| !number.is_finite())
    }

    /// Whether all of them are [moderate](super::sure).
    pub(super) fn are_moderate(self) -> bool {
        self.values().iter().all(|number| number.abs() <= MODERATE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_number_that_is_not_moderate_makes_all_of_them_so() {
        assert!(Numbers::All(-MODERATE).are_moderate());
        assert!(Numbers::Each(&[0.0, MODERATE]).are_moderate());
        for number in [2.0 * MODERATE, -2.0 * MODERATE, f64::INFINITY, f64::NAN] {
            assert!(!Numbers::All(number).are_moderate());
            assert!(!Numbers::Each(&[0.0, number, 1.0]).are_moderate());
        }
    }
}
