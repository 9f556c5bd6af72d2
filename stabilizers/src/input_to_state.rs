//! Input-to-state stable port: an environment that is asked a little before the device is there.

use lyapunov_core::{
    Correction, HeldTick, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal,
    Snapshot,
};

/// The input-to-state stable approach, as in Jafari and Ryu (IEEE International Conference on Robotics and Automation,
/// 2015) and Jafari, Nabeel and Ryu (IEEE Transactions on Robotics, 2017): a port around the environment.
///
/// ```text
/// s(k) = f(k−1) / μ
/// q(k) = x(k) − s(k),  v' = v − (s(k) − s(k−1)) / T   what the environment is asked at; v' = v − ḟ / μ under one μ
/// f(k) = environment(q(k), v')
/// F(k) = f(k) + τ (f(k) − f(k−1)) / T                 what is given
/// ```
///
/// with `μ` (N/m) a bound of the environment's slope, `0 ≤ df/dq ≤ μ`, and `τ` (s) the feed-forward of its rate, which
/// is limited by noise. (Equations as in two public implementations.) A spring `K` is felt as `K` and `μ` in series,
/// `K' = K μ / (K + μ)`, with a damper `τ K'`: it adds damping, and so it settles what a bounding law only bounds.
///
/// **Guarantee** (derived here), in continuous time, from rest, of a monotone environment without memory that stores
/// `W`: `∫ F v = W(q) + f² / (2 μ) + τ ∫ ḟ q̇ + (τ / μ) ∫ ḟ²`, in which no term is below 0. **Assumed** is that the
/// slope never exceeds `μ`: from `μ = K` on downwards the recursion with `f(k−1)` swings by itself. A hold and a delay
/// keep no more than the rule of a sampled spring and damper, `K' T² / m < 2 β (2 − β) / (2 + β)` with
/// `β = τ K' T / m`, so energy may be generated, by a bounded amount while the loop is stable.
///
/// Run it at the environment's rate, inside a hold if the servo is faster: there the rate term would be an impulse of
/// one tick. `T` is the period of its own calls.
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, OnePort};
/// use lyapunov_stabilizers::InputToState;
/// struct Spring(f64); // N/m
/// impl OnePort<f64> for Spring {
///     fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
///         self.0 * sample.position
///     }
/// }
/// let mut port = InputToState::new(Spring(5000.0), 8500.0, 5e-3)?;
/// let mut force = port.respond(&HeldTick {
///     period: 1e-3, position: 1e-3, velocity: 1.0, displacement: 1e-3, applied: 0.0
/// }.sample());
/// for _ in 0..200 {
///     force = port.respond(&HeldTick {
///         period: 1e-3, position: 1e-3, velocity: 0.0, displacement: 0.0, applied: force
///     }.sample());
/// }
/// assert!((force - 1e-3 / (1.0 / 5000.0 + 1.0 / 8500.0)).abs() < 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct InputToState<P, V: Signal> {
    port: P,
    slope: V::Scalar,
    share: V::Scalar,
    feed: V::Scalar,
    answer: V,
    asked: V,
    shift: V,
}

impl<P, V: Signal> InputToState<P, V> {
    /// `port` with the largest `slope` μ, N/m, and the rate `feed` τ, s. An infinite slope asks the environment at `x`.
    ///
    /// # Errors
    /// `slope` not above 0; `feed` below 0, infinite or NaN.
    pub fn new(port: P, slope: V::Scalar, feed: V::Scalar) -> Result<Self, ParameterError> {
        let slope = Requirement::AboveZero.check("largest slope", slope)?;
        Self::with(port, slope, V::Scalar::of(0.0), feed)
    }

    /// `port` whose slope is watched: `μ ← max(μ, s |Δf| / |Δq|)`, with `share` s; until something is seen `q = x`. The
    /// published `s` is 1.7.
    ///
    /// # Errors
    /// `share` not above 1 and finite, where the recursion would swing; `feed` below 0, infinite or NaN.
    pub fn adaptive(port: P, share: V::Scalar, feed: V::Scalar) -> Result<Self, ParameterError> {
        // The least number above 1.
        let least = V::Scalar::of(1.0) + V::Scalar::epsilon();
        let share = Requirement::AtLeast(least.lane(0)).check("share of the slope", share)?;
        Self::with(port, V::Scalar::of(0.0), share, feed)
    }

    fn with(
        port: P,
        slope: V::Scalar,
        share: V::Scalar,
        feed: V::Scalar,
    ) -> Result<Self, ParameterError> {
        let feed = Requirement::NonNegative.check("rate feed-forward", feed)?;
        let (zero, asked) = (V::zero(), V::splat(V::Scalar::of(f64::NAN)));
        Ok(Self { port, slope, share, feed, answer: zero, asked, shift: zero })
    }

    /// The port inside.
    pub fn port(&self) -> &P {
        &self.port
    }

    /// The port inside, to be changed between ticks.
    pub fn port_mut(&mut self) -> &mut P {
        &mut self.port
    }

    /// The slope `μ`, N/m; 0 while none is known.
    #[inline]
    pub fn slope(&self) -> V::Scalar {
        self.slope
    }

    /// `μ` after the environment answered a motion of `moved` by `change`.
    #[inline(always)]
    fn watch(&mut self, moved: V, change: V) {
        let steepness = (change.inner(change) / moved.inner(moved)).sqrt();
        let seen = self.share * steepness;
        let seen = V::Scalar::choose(seen.finite(), seen, V::Scalar::of(0.0));
        self.slope = seen.larger(self.slope);
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for InputToState<P, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let known = self.slope.above(V::Scalar::of(0.0));
        let shift = V::choose(known, self.answer.map(|answer| answer / self.slope), V::zero());
        let position = sample.position - shift;
        let moved = sample.displacement - (shift - self.shift);
        // A period that is none makes the answer NaN, as a period that is NaN does.
        let unknown = V::Scalar::of(f64::NAN);
        let period = V::Scalar::choose(sample.timed(), sample.period, unknown);
        let rate = V::Scalar::of(1.0) / period;
        let velocity = sample.velocity - (shift - self.shift).scale(rate);
        let asked =
            HeldTick { period, position, velocity, displacement: moved, applied: self.answer }
                .sample();
        let answer = self.port.respond(&asked);
        let change = answer - self.answer;
        let given = answer + change.scale(self.feed * rate);

        let sound = answer.finite() & position.finite();
        let from = V::choose(self.asked.finite(), self.asked, position);
        self.watch(position - from, V::choose(sound, change, V::zero()));
        self.asked = V::choose(sound, position, self.asked);
        self.shift = V::choose(shift.finite(), shift, self.shift);
        self.answer = V::choose(sound, answer, self.answer);
        given
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal> Snapshot for InputToState<P, V> {
    /// The memory of the port inside, the slope, the last answer, the position it was asked at, NaN before the first, and
    /// the shift.
    type State = (P::State, V::Scalar, V, V, V);

    fn state(&self) -> Self::State {
        (self.port.state(), self.slope, self.answer, self.asked, self.shift)
    }

    fn restored(
        self,
        (port, slope, answer, asked, shift): Self::State,
    ) -> Result<Self, ParameterError> {
        let slope = Requirement::Limit.check("stored slope", slope)?;
        let answer = Requirement::Finite.check_axes("stored answer", answer)?;
        let asked = Requirement::Finite.check_known("stored position", asked)?;
        let shift = Requirement::Finite.check_axes("stored shift", shift)?;
        Ok(Self { port: self.port.restored(port)?, slope, answer, asked, shift, ..self })
    }
}
