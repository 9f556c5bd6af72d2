//! Physical energy that a port gave.

use lyapunov::{Scalar, Signal};

use crate::files::scene::Draft;

/// Sums the work of the applied force over the plant's own motion, without the device's damper and with it.
///
/// `W(n) = Σ f_act(i−1) Δx(i)` over `i ≤ n`, exact under a held force whatever was measured; in
/// several dimensions an inner product. Over a period a damper `b`
/// takes `b ∫ v² dt ≥ b Δx² / T`, so port and damper together took `W(n) + Σ b Δx(i)² / T` or more.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<V: Signal> {
    damper: V::Scalar,
    port: V::Scalar,
    both: V::Scalar,
    least: V::Scalar,
    least_of_both: V::Scalar,
}

/// `b / T` of a scene's device, N/m; NaN, unknown, with jitter, where a period is not `T`.
pub(crate) fn device_damper(scene: &Draft) -> f64 {
    let damper = scene.device.damping.get() / scene.period();
    if scene.effects.jitter.is_none() { damper } else { f64::NAN }
}

impl<V: Signal> Given<V> {
    /// Sums that are still 0, beside a device's `damper`, [`device_damper`].
    pub(crate) fn new(damper: V::Scalar) -> Self {
        let zero = V::Scalar::of(0.0);
        Self { damper, port: zero, both: zero, least: zero, least_of_both: zero }
    }

    /// Adds one more tick: how far the plant moved over the period just past, and the applied force's work on the way.
    #[inline(always)]
    pub(crate) fn add(&mut self, work: V::Scalar, moved: V) {
        self.port += work;
        self.both += work + moved.scale(self.damper).inner(moved);
        // In this order a NaN stays.
        self.least = self.least.smaller(self.port);
        self.least_of_both = self.least_of_both.smaller(self.both);
    }

    /// `max(0, −min W(n))`, J: the most that the port had given beyond all it had taken.
    pub(crate) fn by_port(&self) -> V::Scalar {
        V::Scalar::of(0.0) - self.least
    }

    /// `max(0, −min (W(n) + Σ b Δx² / T))`, J: the most that the port had given beyond what it and the device's damper
    /// had taken; NaN with an unknown damper.
    pub(crate) fn beyond_damper(&self) -> V::Scalar {
        V::Scalar::of(0.0) - self.least_of_both
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use lyapunov::lanes::AutoF64x8;

    use super::*;
    use crate::measure::samples::scene;

    const PERIOD: f64 = 1e-3;

    /// The meter after a motion from tick to tick, with the force that is held after each position.
    fn after(damping: f64, motion: impl IntoIterator<Item = (f64, f64)>) -> Given<f64> {
        let mut given = Given::new(damping / PERIOD);
        let mut last: Option<(f64, f64)> = None;
        for (position, force) in motion {
            let (moved, held) = last.map_or((0.0, 0.0), |(from, held)| (position - from, held));
            given.add(held * moved, moved);
            last = Some((position, force));
        }
        given
    }

    /// In over `ticks` steps and out again, before a spring of 2 kN/m that is held for a tick.
    fn held_spring(damping: f64, ticks: i32, step: f64) -> Given<f64> {
        let places = (0..=2 * ticks).map(|n| step * f64::from(ticks - (n - ticks).abs()));
        after(damping, places.map(|x| (x, 2000.0 * x)))
    }

    #[test]
    fn a_held_spring_gives_half_k_dx_squared_a_tick() {
        let (ticks, step) = (40, 1e-4);
        let each = 0.5 * 2000.0 * step * step;
        let whole = 80.0 * each;
        assert_relative_eq!(held_spring(0.0, ticks, step).by_port(), whole, max_relative = 1e-12);
        // Half a tick's damper, b = K T / 2, takes just that, wherever the motion is; half of it takes half.
        let paid = held_spring(1.0, ticks, step);
        assert!(paid.beyond_damper() <= 1e-12 * whole, "{paid:?}");
        assert_relative_eq!(paid.by_port(), whole, max_relative = 1e-12);
        let half = held_spring(0.5, ticks, step).beyond_damper();
        assert_relative_eq!(half, 0.5 * whole, max_relative = 1e-12);
    }

    #[test]
    fn a_steady_force_gives_the_way_back_and_a_late_damper_feeds_a_zigzag() {
        // 3 N on a swing of 2 mm: what went in over the first half comes back, and as much again.
        let swing = (0..=1000).map(|n| (0.002 * (0.02 * f64::from(n)).sin(), 3.0));
        let lowest = (0..=1000).map(|n| (0.02 * f64::from(n)).sin()).fold(0.0, f64::min);
        let given = after(0.0, swing).by_port();
        assert_relative_eq!(given, -3.0 * 0.002 * lowest, max_relative = 1e-12);
        // A damper c on the last tick's motion, held over the next: c / T Δx² a tick where the motion alternates.
        let zigzag = (1..=50).map(|n| {
            let step = if n % 2 == 0 { 1e-4 } else { -1e-4 };
            (0.5 * step, 7.0 * step / PERIOD)
        });
        let given = after(2.0, zigzag);
        assert_relative_eq!(given.by_port(), 49.0 * 7.0 * 1e-8 / PERIOD, max_relative = 1e-12);
        let beyond = 49.0 * (7.0 - 2.0) * 1e-8 / PERIOD;
        assert_relative_eq!(given.beyond_damper(), beyond, max_relative = 1e-12);
    }

    #[test]
    fn what_is_taken_first_may_be_given_back_and_what_is_given_stays_told() {
        let given = after(0.0, [(0.0, 2.0), (1e-3, 5.0), (0.0, 9.0), (1.0, 0.0)]);
        assert_relative_eq!(given.by_port(), 3e-3, max_relative = 1e-12);
        assert_eq!(after(0.0, [(0.0, 2.0), (1e-3, 1.0), (0.0, 0.0)]).by_port().to_bits(), 0);
    }

    #[test]
    fn with_jitter_the_damper_is_unknown() {
        let dissipating = scene("device.damping = 0.5\n");
        assert_eq!(device_damper(&dissipating), 50.0);
        let jitter =
            scene("device.damping = 0.5\neffects.jitter = { deviation = 1e-4, seed = 1 }\n");
        let mut given = Given::<f64>::new(device_damper(&jitter));
        given.add(-1.0, 1e-3);
        given.add(1.0, 1e-3);
        assert_eq!(given.by_port(), 1.0);
        assert!(given.beyond_damper().is_nan());
    }

    #[test]
    fn every_lane_is_its_scalar_run() {
        let motion = |lane: usize, n: u32| 1e-3 * (f64::from(n) * (0.1 + lane as f64)).sin();
        let mut lanes = Given::<AutoF64x8>::new(AutoF64x8::of(30.0));
        let mut alone = [Given::<f64>::new(30.0); 8];
        for n in 0..500 {
            let moved = |lane| motion(lane, n);
            let work = |lane| 1e3 * moved(lane) * motion(lane, 3 * n);
            lanes.add(AutoF64x8::from_lanes(work), AutoF64x8::from_lanes(moved));
            (0..8).for_each(|lane| alone[lane].add(work(lane), moved(lane)));
        }
        for (lane, alone) in alone.iter().enumerate() {
            assert_eq!(lanes.by_port().lane(lane), alone.by_port());
            assert_eq!(lanes.beyond_damper().lane(lane), alone.beyond_damper());
            assert!(alone.by_port() > alone.beyond_damper());
        }
    }
}
