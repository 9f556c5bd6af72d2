//! Slope bound: forces that change no faster with the displacement than a given slope.

use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Requirement, Scalar, Signal,
    Snapshot, Stabilizer,
};

use crate::StabilizerExt;
use crate::account::account_in_sum;
use crate::limiting::limiting;
use crate::range::in_range;

/// A bound of the slope, derived here: the force `F` follows the effort `f`, axis by axis, with changes in the sector
/// of a largest slope `μ`, `0 ≤ ΔF Δx ≤ μ Δx²`; it may fall towards 0 with the effort at any time.
///
/// ```text
/// δ(n) = δ(n−1) + Δf(n) − (Δf(n), as far as it is between 0 and μ Δx(n))        what is held back, N
/// δ(n) nearer to 0 by at most ρ T, and then as far as it is between 0 and f(n)
/// F(n) = f(n) − δ(n),   δ(0) = 0
/// ```
///
/// An environment whose changes are in the sector passes unchanged, to the bit; a wall that is stiffer is felt as a
/// spring `μ`, on the way in and out. Nothing asks for energy: where the environment makes loops in the graph of force
/// over displacement, a motion to and fro over `d` m takes out up to `μ d² / 2` J on each axis, of which a passivity
/// controller would brake all, and this does nothing. So the port is not passive. It is bounded where what moves dissipates more
/// than that, which a linear damper does at every size of the swing or at none: a hand and device of the damping `b`
/// that swing at `ω` dissipate `π b ω d² / 4` on the way, so `μ < π b ω / 2`. On one axis a linear wall makes no such loop, nor
/// does a force with a slope within 0 and `μ`: there is only the hold's leak of `μ Δx² / 2` a tick, and a device damping
/// of `b ≥ μ T / 2` dissipates that ([`of_damping`](Self::of_damping); the condition of Colgate and Schenkel, Journal of
/// Robotic Systems 14(1), 1997, with `μ` for the wall's stiffness). For a linear wall `F² / (2 μ)` is a storage of port
/// and damper if it is stiffer than `μ`, and the spring's own energy if it is softer. So port and damper give nothing
/// before a wall that is met from outside, where the first effort is 0. The first effort passes whole: a loop that
/// starts in contact with a wall `k` at an effort `f` may give up to `f² / (2 min(k, μ))`. Both bounds hold without a creep only. A
/// wall that is steep at first and then flat does make a loop, with a long step in and short ones out.
///
/// **On several axes** all of this is of one axis after the other, so it holds where the force on each axis depends on the
/// position along it alone. Before a slanted plane, or a sphere, it does not, however soft they are: the force on an axis
/// that does not move is held back whole, that on the other one stays, and sliding along the surface takes energy from it,
/// metre by metre. `tests/family/slope_bound.rs` counts it.
///
/// A force that rises at rest is held back: a moving wall, a weight, what a damper does with the velocity alone. A
/// creep of `ρ` N/s ([`creeping`](Self::creeping)) lets it come, by `ρ T` a tick.
///
/// At `μ = 2 b / T`, prompt, it is near to the tight form of [`EnergyBounding`](crate::EnergyBounding), which is
/// stricter: that one clips what has no energy to pay for it, this one only what is too steep. An environment that
/// relies on its slope and is asked differently is [`InputToState`](crate::InputToState).
///
/// It needs no velocity and adds no damping. The observed energy is the work of the port; what it gave more than it
/// took is reported as shortfall.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortSample, Stabilizer};
/// use lyapunov_stabilizers::SlopeBound;
/// let mut bound = SlopeBound::of_damping(0.5, 1e-3)?; // μ = 2 b / T = 1 kN/m
/// bound.stabilize(&PortSample::starting(1e-3, 0.0, 0.1), 0.0);
/// let pressed = HeldTick {
///     period: 1e-3, position: 0.1e-3, velocity: 0.1, displacement: 0.1e-3, applied: 0.0
/// }.sample();
/// let effort: f64 = bound.stabilize(&pressed, 5.0).effort; // 50 kN/m
/// assert_abs_diff_eq!(effort, 0.1, epsilon = 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SlopeBound<V: Signal, A = Plain<<V as Signal>::Scalar>> {
    slope: V::Scalar,
    creep: V::Scalar,
    /// Not finite before the first sound effort.
    asked: V,
    held: V,
    energy: A,
}

impl<V: Signal> SlopeBound<V> {
    /// A bound of `slope` N/m.
    ///
    /// # Errors
    /// `slope` not above 0 and finite.
    pub fn new(slope: V::Scalar) -> Result<Self, ParameterError> {
        let slope = Requirement::Positive.check("slope", slope)?;
        let creep = V::Scalar::of(0.0);
        let asked = V::splat(V::Scalar::of(f64::NAN));
        Ok(Self { slope, creep, asked, held: V::zero(), energy: Plain::zero() })
    }

    /// The slope `2 b / T`, for a device that surely has the viscous `damping` b, N·s/m.
    ///
    /// # Errors
    /// `damping` or `period` not above 0 and finite, or a slope out of range.
    pub fn of_damping(damping: V::Scalar, period: V::Scalar) -> Result<Self, ParameterError> {
        let damping = Requirement::Positive.check("device damping", damping)?;
        let period = Requirement::Positive.check("period", period)?;
        let slope = V::Scalar::of(2.0) * damping / period;
        Self::new(in_range("device damping", damping, slope)?)
    }
}

impl<V: Signal, A: Accumulator<V::Scalar>> SlopeBound<V, A> {
    /// The same bound, which lets the held-back force through at `rate` N/s.
    ///
    /// # Errors
    /// `rate` below 0, infinite or NaN.
    pub fn creeping(self, rate: V::Scalar) -> Result<Self, ParameterError> {
        let mut creeping = self;
        creeping.set_creep(rate)?;
        Ok(creeping)
    }

    /// The same bound with its energies summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<V::Scalar>>(self) -> SlopeBound<V, B> {
        let Self { slope, creep, asked, held, energy } = self;
        SlopeBound { slope, creep, asked, held, energy: B::holding(energy.value()) }
    }
}

impl<V: Signal, A> StabilizerExt for SlopeBound<V, A> {}

/// `value`, limited to the range between 0 and `end`.
#[inline(always)]
fn within<T: Scalar>(value: T, end: T) -> T {
    value.larger(end.smaller(T::of(0.0))).smaller(end.larger(T::of(0.0)))
}

impl<V: Signal, A: Accumulator<V::Scalar>> Stabilizer<V> for SlopeBound<V, A> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let booked = self.energy.book(sample.work.sum());

        let change = effort - V::choose(self.asked.finite(), self.asked, effort);
        let followed = change.zip(sample.displacement.scale(self.slope), within);
        let creep = self.creep * sample.period;
        let held = (self.held + (change - followed))
            .zip(effort, |held, asked| within(held - held.larger(-creep).smaller(creep), asked));
        let sound = effort.finite()
            & sample.displacement.finite()
            & (held.sum() + creep).finite()
            & sample.timed();
        self.held = V::choose(sound, held, self.held);
        self.asked = V::choose(sound, effort, self.asked);
        limiting(effort - held, self.energy.value(), booked & sound)
    }
}

account_in_sum!(impl[V: Signal, A: Accumulator<V::Scalar>] SlopeBound<V, A>, in V::Scalar, is energy);

impl<V: Signal, A> SlopeBound<V, A> {
    /// The slope, N/m.
    pub fn slope(&self) -> V::Scalar {
        self.slope
    }

    /// Changes the slope between ticks; what is held back stays, and is given as the device moves.
    ///
    /// # Errors
    /// `slope` not above 0 and finite; the old one stays.
    pub fn set_slope(&mut self, slope: V::Scalar) -> Result<(), ParameterError> {
        self.slope = Requirement::Positive.check("slope", slope)?;
        Ok(())
    }

    /// The creep, N/s.
    pub fn creep(&self) -> V::Scalar {
        self.creep
    }

    /// Changes the creep between ticks.
    ///
    /// # Errors
    /// `rate` below 0, infinite or NaN; the old one stays.
    pub fn set_creep(&mut self, rate: V::Scalar) -> Result<(), ParameterError> {
        self.creep = Requirement::NonNegative.check("creep", rate)?;
        Ok(())
    }
}

impl<V: Signal, A: Snapshot> Snapshot for SlopeBound<V, A> {
    /// The effort that was asked for, NaN before the first, and the one held back, N, and the energy.
    type State = (V, V, A::State);

    fn state(&self) -> Self::State {
        (self.asked, self.held, self.energy.state())
    }

    fn restored(self, (asked, held, energy): Self::State) -> Result<Self, ParameterError> {
        let asked = Requirement::Finite.check_known("stored effort", asked)?;
        let held = Requirement::Finite.check_axes("stored effort", held)?;
        Ok(Self { asked, held, energy: self.energy.restored(energy)?, ..self })
    }
}
