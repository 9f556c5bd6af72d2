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
