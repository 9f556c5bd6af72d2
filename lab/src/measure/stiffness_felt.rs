//! Stiffness felt in long contacts.

use lyapunov::Scalar;

/// The least duration of a long contact, s.
pub(crate) const LONG: f64 = 0.5;

/// Watches the line through the wall's surface that fits best, `Σ f_act p / Σ p²`, over the long contacts: unbroken runs
/// of ticks on which the environment's force acts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StiffnessFelt<T> {
    /// Half a tick less than a long contact.
    nearly_long: T,
    /// The ticks of this contact, and its `Σ f p` and `Σ p²`.
    ticks: T,
    now: (T, T),
    /// The sums of the long contacts before.
    long: (T, T),
}

impl<T: Scalar> StiffnessFelt<T> {
    /// A meter of a loop at `rate` ticks a second.
    pub(crate) fn new(rate: f64) -> Self {
        let nothing = (T::zero(), T::zero());
        let nearly_long = T::of((LONG * rate).ceil() - 0.5);
        Self { nearly_long, ticks: T::zero(), now: nothing, long: nothing }
    }

    /// Adds one more tick: the force applied from here on, the environment's part of it, and the true depth.
    #[inline(always)]
    pub(crate) fn add(&mut self, applied: T, environment: T, depth: T) {
        let (zero, idle) = (T::zero(), environment.magnitude().below(T::smallest_positive()));
        self.long = self.long_with(idle & self.ticks.above(self.nearly_long));
        self.ticks = T::choose(idle, zero, self.ticks + T::one());
        let (product, square) = (self.now.0 + applied * depth, self.now.1 + depth * depth);
        self.now = (T::choose(idle, zero, product), T::choose(idle, zero, square));
    }

    /// The sums of the long contacts, with this contact's where it is `done`.
    #[inline(always)]
    fn long_with(&self, done: T::Mask) -> (T, T) {
        let more = |now: T| T::choose(done, now, T::zero());
        (self.long.0 + more(self.now.0), self.long.1 + more(self.now.1))
    }

    /// The stiffness in a lane, N/m; none without a long contact beyond the surface.
    pub(crate) fn stiffness(&self, lane: usize) -> Option<f64> {
        let (product, square) = self.long_with(self.ticks.above(self.nearly_long));
        let (product, square) = (product.lane(lane), square.lane(lane));
        (square > 0.0).then(|| product / square)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use lyapunov::lanes::AutoF64x8;

    use super::*;

    /// A tick: applied force, the environment's part of it, depth.
    type Tick = (f64, f64, f64);

    fn after(ticks: &[Tick]) -> Option<f64> {
        let mut felt = StiffnessFelt::new(100.0);
        ticks
            .iter()
            .for_each(|&(applied, environment, depth)| felt.add(applied, environment, depth));
        felt.stiffness(0)
    }

    /// f = 800 p + 0.1 (−1)^n on two alternating depths.
    fn pressed(ticks: usize) -> Vec<Tick> {
        let tick = |n| {
            let (p, more) = if n % 2 == 0 { (0.002, 0.1) } else { (0.004, -0.1) };
            (800.0 * p + more, 800.0 * p, p)
        };
        (0..ticks).map(tick).collect()
    }

    #[test]
    fn the_stiffness_felt_is_the_line_through_the_surface() {
        let square = 0.002_f64.powi(2) + 0.004_f64.powi(2);
        let expected = 800.0 + 0.1 * (0.002 - 0.004) / square;
        assert_relative_eq!(after(&pressed(60)).unwrap(), expected, max_relative = 1e-12);
        assert_relative_eq!(after(&pressed(50)).unwrap(), expected, max_relative = 1e-12);
        assert_eq!(after(&pressed(49)), None);
        assert_eq!(after(&[(1.0, 1.0, 0.0); 60]), None);
    }

    #[test]
    fn short_contacts_and_free_motion_do_not_count() {
        let free = (5.0, 0.0, 0.1);
        let short = [&pressed(40)[..], &[free]].concat();
        let long = pressed(60);
        assert_eq!(after(&[&short[..], &short].concat()), None);
        let whole = [&short[..], &[free; 70], &long, &[free], &short, &long].concat();
        assert_relative_eq!(after(&whole).unwrap(), after(&long).unwrap(), max_relative = 1e-12);
    }

    #[test]
    fn every_lane_is_its_scalar_run() {
        // Contacts of another length in each lane.
        let tick = |lane: usize, n: usize| -> Tick {
            let p = 1e-3 * (0.7 * n as f64).sin().abs();
            if n.is_multiple_of(45 + 2 * lane) {
                (0.3, 0.0, p)
            } else {
                (900.0 * p, 800.0 * p + 0.1, p)
            }
        };
        let mut lanes = StiffnessFelt::new(100.0);
        for n in 0..400 {
            let of = |part: fn(Tick) -> f64| AutoF64x8::from_lanes(|lane| part(tick(lane, n)));
            lanes.add(of(|it| it.0), of(|it| it.1), of(|it| it.2));
        }
        let alone = |lane| after(&(0..400).map(|n| tick(lane, n)).collect::<Vec<_>>());
        assert!((0..8).all(|lane| lanes.stiffness(lane) == alone(lane)));
        assert!(alone(0).is_none() && alone(7).is_some());
    }
}
