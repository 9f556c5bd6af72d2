//! Physical energy that a port gave.

use lyapunov::Scalar;

use crate::files::scene::Draft;

/// Sums the work of the applied force over the plant's own motion, without the device's damper and with it.
///
/// `W(n) = Σ f_act(i−1) Δx(i)` over `i ≤ n`, exact under a held force whatever was measured. Over a period a damper `b`
/// takes `b ∫ v² dt ≥ b Δx² / T`, so port and damper together took `W(n) + Σ b Δx(i)² / T` or more.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<T> {
    damper: T,
    port: T,
    both: T,
    least: T,
    least_of_both: T,
}

/// `b / T` of a scene's device, N/m; NaN, unknown, with jitter, where a period is not `T`.
pub(crate) fn device_damper(scene: &Draft) -> f64 {
    let damper = scene.device.damping.get() / scene.period();
    if scene.effects.jitter.is_none() { damper } else { f64::NAN }
}

impl<T: Scalar> Given<T> {
    /// Sums that are still 0, beside a device's `damper`, [`device_damper`].
    pub(crate) fn new(damper: T) -> Self {
        let zero = T::zero();
        Self { damper, port: zero, both: zero, least: zero, least_of_both: zero }
    }

    /// Adds one more tick: how far the plant moved over the period just past, and the applied force's work on the way.
    #[inline(always)]
    pub(crate) fn add(&mut self, work: T, moved: T) {
        self.port += work;
        self.both += work + self.damper * moved * moved;
        // In this order a NaN stays.
        self.least = self.least.smaller(self.port);
        self.least_of_both = self.least_of_both.smaller(self.both);
    }

    /// `max(0, −min W(n))`, J: the most that the port had given beyond all it had taken.
    pub(crate) fn by_port(&self) -> T {
        T::zero() - self.least
    }

    /// `max(0, −min (W(n) + Σ b Δx² / T))`, J: the most that the port had given beyond what it and the device's damper
    /// had taken; NaN with an unknown damper.
    pub(crate) fn beyond_damper(&self) -> T {
        T::zero() - self.least_of_both
    }
}
