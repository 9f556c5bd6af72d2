//! Who gave energy and who took it.

use super::tick::Tick;

/// Sums the work of both parts of the force over the plant's true displacements.
///
/// `W_e(n) = Σ f_e(i) (x(i+1) − x(i))` over `i < n`, and `W_c` likewise; together they are the work at the port.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Energies {
    last: Option<Tick>,
    environment: f64,
    least: f64,
    controller: f64,
}

impl Energies {
    pub(super) fn add(&mut self, tick: &Tick) {
        if let Some(last) = self.last {
            let moved = tick.row.x - last.row.x;
            self.environment += last.environment * moved;
            self.controller += last.controller() * moved;
            self.least = self.least.min(self.environment);
        }
        self.last = Some(*tick);
    }

    /// `max(0, −min W_e(n))`, J: what the environment gave beyond all it had been given. No passive wall gives
    /// any, so it comes from sampling, hold, encoder, saturation and delay.
    pub(super) fn injected(&self) -> f64 {
        -self.least
    }

    /// `W_c` at the end, J: what the controller's force took out of the motion; negative if it fed it.
    pub(super) fn taken(&self) -> f64 {
        self.controller
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::tick;
    use super::*;

    fn after(ticks: &[Tick]) -> Energies {
        let mut energies = Energies::default();
        ticks.iter().for_each(|tick| energies.add(tick));
        energies
    }

    #[test]
    fn a_force_held_on_the_way_out_injects_what_was_not_stored() {
        // In over 1 mm under 2 N, out over 1 mm under 5 N: 3 mJ more than went in.
        let ticks = [tick(0.0, 2.0, 0.0), tick(0.001, 5.0, 0.0), tick(0.0, 0.0, 0.0)];
        let energies = after(&ticks);
        assert!((energies.injected() - 0.003).abs() < 1e-15);
        assert_eq!(energies.taken(), 0.0);
        // Taking it back later changes nothing.
        let back = [&ticks[..2], &[tick(0.0, 9.0, 0.0), tick(0.5, 0.0, 0.0)]].concat();
        assert!((after(&back).injected() - 0.003).abs() < 1e-15);
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
        assert!((after(&ticks).taken() - (0.006 - 0.003)).abs() < 1e-15);
        assert_eq!(after(&ticks).injected(), 0.0);
        assert_eq!(after(&ticks[..1]).taken(), 0.0);
    }
}
