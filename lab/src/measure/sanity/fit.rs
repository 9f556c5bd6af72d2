//! Fit of a force to position and velocity.

/// Means and second moments of position, velocity and force, summed as Welford does.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fit {
    count: u64,
    means: [f64; 3],
    /// Sums of the products of deviations: xx, vv, ff, xv, xf, vf.
    moments: [f64; 6],
}

/// How a force depends on position and velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dependence {
    /// Samples.
    pub(super) count: u64,
    /// Slope over the position at a constant velocity, N/m.
    pub(super) by_position: f64,
    /// Slope over the velocity at a constant position, N·s/m.
    pub(super) by_velocity: f64,
    /// The first slope in standard deviations: those of the force for one of the position; 0 where it is not defined.
    pub(super) with_position: f64,
    /// The second slope likewise.
    pub(super) with_velocity: f64,
}

impl Fit {
    pub(super) fn add(&mut self, position: f64, velocity: f64, force: f64) {
        self.count += 1;
        let values = [position, velocity, force];
        let before: [f64; 3] = std::array::from_fn(|index| values[index] - self.means[index]);
        for (mean, off) in self.means.iter_mut().zip(before) {
            *mean += off / self.count as f64;
        }
        let after: [f64; 3] = std::array::from_fn(|index| values[index] - self.means[index]);
        let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        for (moment, (one, other)) in self.moments.iter_mut().zip(pairs) {
            *moment += before[one] * after[other];
        }
    }

    /// The number of samples.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// Share of the force's variance that position and velocity leave.
    pub(super) fn left(&self) -> f64 {
        let (_, [xv, xf, vf]) = self.correlations();
        (1.0 - weight(xf, vf, xv) * xf - weight(vf, xf, xv) * vf).max(0.0)
    }

    /// Roots of the sums of squares of position, velocity and force, and correlations xv, xf, vf.
    fn correlations(&self) -> ([f64; 3], [f64; 3]) {
        // Roots first: a product of two moments may be out of range.
        let [x, v, f] = [0, 1, 2].map(|index| self.moments[index].max(0.0).sqrt());
        let share = |moment: f64, one: f64, other: f64| {
            let share = moment / one / other;
            if share.is_finite() { share.clamp(-1.0, 1.0) } else { 0.0 }
        };
        let correlations = [
            share(self.moments[3], x, v),
            share(self.moments[4], x, f),
            share(self.moments[5], v, f),
        ];
        ([x, v, f], correlations)
    }

    pub(super) fn dependence(&self) -> Dependence {
        let ([x, v, f], [xv, xf, vf]) = self.correlations();
        let with_position = weight(xf, vf, xv);
        let with_velocity = weight(vf, xf, xv);
        let slope = |weight: f64, size: f64| {
            let slope = weight * (f / size);
            if slope.is_finite() { slope } else { 0.0 }
        };
        Dependence {
            count: self.count,
            by_position: slope(with_position, x),
            by_velocity: slope(with_velocity, v),
            with_position,
            with_velocity,
        }
    }
}

/// Weight of one of two quantities in a third, from their correlations; 0 where the two are one.
fn weight(of: f64, other: f64, across: f64) -> f64 {
    const ROUNDING: f64 = 1e-9;
    let apart = 1.0 - across * across;
    if apart > ROUNDING { (of - across * other) / apart } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn a_spring_and_a_damper_are_found() {
        let mut fit = Fit::default();
        for n in 0..200 {
            let (x, v) = ((0.1 * f64::from(n)).sin(), (0.37 * f64::from(n)).cos());
            fit.add(1e3 + x, v, 5.0 - 300.0 * x + 2.0 * v + 1e-3 * f64::from(n % 7));
        }
        let found = fit.dependence();
        assert_abs_diff_eq!(found.by_position, -300.0, epsilon = 0.01);
        assert_abs_diff_eq!(found.by_velocity, 2.0, epsilon = 0.01);
        // Both swing by as much, so the force is the spring's.
        assert_abs_diff_eq!(found.with_position, -1.0, epsilon = 0.01);
        assert_abs_diff_eq!(found.with_velocity, 0.007, epsilon = 0.003);
        assert_eq!(found.count, 200);
    }

    #[test]
    fn what_does_not_vary_correlates_with_nothing() {
        let mut fit = Fit::default();
        for n in 0..20 {
            fit.add(f64::from(n), 1.0, 3.0);
        }
        let found = fit.dependence();
        assert_eq!((found.with_position, found.with_velocity), (0.0, 0.0));
        assert_eq!((found.by_position, found.by_velocity), (0.0, 0.0));
        assert_eq!(Fit::default().dependence().with_position, 0.0);
    }

    #[test]
    fn numbers_of_any_size_stay_finite() {
        for size in [1e-300, 1e150] {
            let mut fit = Fit::default();
            for n in 0..20 {
                let x = size * (0.1 * f64::from(n)).sin();
                fit.add(x, size * (0.3 * f64::from(n)).cos(), -x);
            }
            let Dependence { with_position, with_velocity, by_position, by_velocity, .. } =
                fit.dependence();
            for number in [with_position, with_velocity, by_position, by_velocity] {
                assert!(number.is_finite());
            }
        }
    }
}
