//! Energies that environment and controller give and take.

use lyapunov::{Scalar, Signal};

/// Sums the work of both parts of the force over the plant's true displacements.
///
/// `W_e(n) = Σ f_e(i) (x(i+1) − x(i))` over `i < n`, and `W_c` likewise, as inner products in several dimensions;
/// together they are the work at the port.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Energies<V: Signal> {
    position: V,
    environment: V,
    controller: V,
    given: V::Scalar,
    least: V::Scalar,
    taken: V::Scalar,
}

impl<V: Signal> Energies<V> {
    /// Sums that are still 0.
    pub(crate) fn new() -> Self {
        let (still, zero) = (V::zero(), V::Scalar::of(0.0));
        // Before the first tick no force acts, so no work is done wherever the plant starts.
        Self {
            position: still,
            environment: still,
            controller: still,
            given: zero,
            least: zero,
            taken: zero,
        }
    }

    /// Adds one more tick: the plant's true position, and the two parts of the force from here on.
    #[inline(always)]
    pub(crate) fn add(&mut self, position: V, environment: V, controller: V) {
        let moved = position - self.position;
        self.given += self.environment.inner(moved);
        self.taken += self.controller.inner(moved);
        self.least = self.given.smaller(self.least);
        *self = Self { position, environment, controller, ..*self };
    }

    /// `max(0, −min W_e(n))`, J: the energy that the environment gave beyond all it had been given. No passive wall
    /// gives any, so it comes from sampling, hold, encoder, saturation and delay.
    pub(crate) fn injected(&self) -> V::Scalar {
        V::Scalar::of(0.0) - self.least
    }

    /// `W_c` at the end, J: the energy that the controller's force took out of the motion; negative if it fed the
    /// motion.
    pub(crate) fn taken(&self) -> V::Scalar {
        self.taken
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// A tick at `x`, with the wall's and the controller's force.
    type Tick = (f64, f64, f64);

    fn tick(x: f64, environment: f64, controller: f64) -> Tick {
        (x, environment, controller)
    }

    fn after(ticks: &[Tick]) -> Energies<f64> {
        let mut energies = Energies::new();
        ticks.iter().for_each(|&(x, wall, control)| energies.add(x, wall, control));
        energies
    }

    #[test]
    fn a_force_held_on_the_way_out_injects_what_was_not_stored() {
        // In over 1 mm under 2 N, out over 1 mm under 5 N: 3 mJ more than went in.
        let ticks = [tick(0.0, 2.0, 0.0), tick(0.001, 5.0, 0.0), tick(0.0, 0.0, 0.0)];
        let energies = after(&ticks);
        assert_abs_diff_eq!(energies.injected(), 0.003, epsilon = 1e-15);
        assert_eq!(energies.taken(), 0.0);
        // Taking it back later changes nothing.
        let back = [&ticks[..2], &[tick(0.0, 9.0, 0.0), tick(0.5, 0.0, 0.0)]].concat();
        assert_abs_diff_eq!(after(&back).injected(), 0.003, epsilon = 1e-15);
    }

    #[test]
    fn a_spring_injects_nothing() {
        let swing = |n: i32| 0.004 * (0.001 * f64::from(n)).sin();
        // The mean of both ends is the force that makes a spring's work exact.
        let ticks: Vec<Tick> =
            (0..9000).map(|n| tick(swing(n), 500.0 * (swing(n) + swing(n + 1)), 0.0)).collect();
        assert!(after(&ticks).injected() < 1e-15);
    }

    #[test]
    fn the_controller_takes_by_braking_and_gives_by_pushing() {
        let ticks = [tick(0.0, 0.0, 3.0), tick(0.002, 0.0, 1.0), tick(-0.001, 0.0, 8.0)];
        assert_abs_diff_eq!(after(&ticks).taken(), 0.006 - 0.003, epsilon = 1e-15);
        assert_eq!(after(&ticks).injected(), 0.0);
        assert_eq!(after(&ticks[..1]).taken(), 0.0);
    }
}
