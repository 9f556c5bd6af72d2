//! Energy bounding: forces that hand back no more than the device's damper dissipates.

mod band;

use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Requirement, Scalar, Signal,
    Snapshot, Stabilizer,
};

use crate::StabilizerExt;
use crate::account::account_in_sum;
use crate::range::in_range;
use band::{Band, Published, Tight};

/// The energy-bounding algorithm, after Kim and Ryu (International Journal of Robotics Research 29(6), 2010): the force
/// changes by `β Δx`, and `β` is clipped so that the sample and hold gives no more than the device's damping
/// dissipates.
///
/// ```text
/// Δx(k) = 0:  F(k) = F(k−1)                       else  β = (f(k) − F(k−1)) / Δx(k),  r = F(k−1) / Δx(k)
/// γmin ≤ β ≤ min(c1, γmax),   γ = c2 − r ± √(c2² + r²);     F(k) = F(k−1) + β Δx(k)
/// ```
///
/// Each axis by itself, in N, m and N/m. It is worked out in forces, without the division: with `S = √(F² + (c2 Δx)²)`
/// the force is `f` clipped to `c2 Δx ± S`, and by `F + c1 Δx` inwards from above, outwards from below.
///
/// **Guarantee** (derived here; the paper's own text was not at hand): `γ` is exactly
/// `(F(k)² − F(k−1)²) / (2 c2) ≤ F(k) Δx`, and `β ≤ c1` gives `F(k−1) Δx ≥ F(k) Δx − c1 Δx²`. So with `c1 ≤ b / T` port
/// and damper together, `Σ F Δx + b Δx² / T`, never fall below `(F(n)² − F(0)²) / (2 c2)`, whatever the motion and
/// whatever the environment. That energy is the reported observed energy. **Assumed** are a viscous damping `b` that is
/// surely there, and a force that acts over the next period as it was given. For one that acts `d` ticks late take
/// [`delayed`](Self::delayed); with `c1 = b / T` a tick too late an adversary does take energy out.
///
/// `c1` is the steepest wall that is felt, `c2` how fast energy may be handed back. It needs no velocity and adds no
/// damping: it bounds a swing and need not end it. While nothing moves the force stays, so that what was not reached at
/// rest is never reached.
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, Stabilizer};
/// use lyapunov_stabilizers::EnergyBounding;
/// let mut bounding = EnergyBounding::of_damping(0.5, 1e-3)?; // c1 = c2 = 500 N/m
/// bounding.stabilize(&PortSample::starting(1e-3, 0.0, 0.1), 0.0);
/// let pressed = HeldTick {
///     period: 1e-3, position: 0.1e-3, velocity: 0.1, displacement: 0.1e-3, applied: 0.0
/// }.sample();
/// let effort: f64 = bounding.stabilize(&pressed, 0.5).effort; // 5 kN/m
/// assert!((effort - 0.05).abs() < 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct EnergyBounding<V: Signal, B = Published<<V as Signal>::Scalar>> {
    band: B,
    force: V,
    energy: Plain<V::Scalar>,
}

impl<V: Signal> EnergyBounding<V> {
    /// The algorithm with the constants `c1` and `c2`, N/m; it relies on a device damping of `c1 T`.
    ///
    /// # Errors
    /// `c1` or `c2` not above 0 and finite; `c2` above `c1`: on the way out the two bounds would not be compatible.
    pub fn new(c1: V::Scalar, c2: V::Scalar) -> Result<Self, ParameterError> {
        let rise = Requirement::Positive.check("energy-bounding c1", c1)?;
        let release = Requirement::Positive.check("energy-bounding c2", c2)?;
        for lane in 0..V::Scalar::LANES {
            let most = Requirement::AtMost(rise.lane(lane));
            most.check("energy-bounding c2", release.lane(lane))?;
        }
        let fall = V::Scalar::largest();
        Ok(Self::within(Published { rise, release, fall, burns: rise }))
    }

    /// `c1 = c2 = b / T`, for a device that surely has the viscous `damping` b, N·s/m.
    ///
    /// # Errors
    /// `damping` or `period` not above 0 and finite, or their quotient out of range.
    pub fn of_damping(damping: V::Scalar, period: V::Scalar) -> Result<Self, ParameterError> {
        Self::delayed(damping, period, 0)
    }

    /// `c1 = c2 = b / (T (1 + d))`, for a force that acts `ticks` d periods late; derived here.
    ///
    /// While a force waits the motion goes on, and `β` must not fall below `−c1` either: then each late tick costs at
    /// most `c1 Σ Δx²`.
    ///
    /// # Errors
    /// As [`of_damping`](Self::of_damping).
    pub fn delayed(
        damping: V::Scalar,
        period: V::Scalar,
        ticks: u32,
    ) -> Result<Self, ParameterError> {
        let slope = rate(damping, period)? / V::Scalar::of(1.0 + f64::from(ticks));
        Ok(Self::new(slope, slope)?.on_damping(damping, period)?.late(ticks))
    }

    /// The same algorithm on a device that has the viscous `damping` b, N·s/m, which may be another than `c1 T`; what it
    /// dissipates is counted in the observed energy.
    ///
    /// # Errors
    /// `damping` below 0, infinite or NaN; `period` not above 0 and finite, or their quotient out of range.
    pub fn on_damping(
        mut self,
        damping: V::Scalar,
        period: V::Scalar,
    ) -> Result<Self, ParameterError> {
        let damping = Requirement::NonNegative.check("device damping", damping)?;
        let period = Requirement::Positive.check("period", period)?;
        let burns = damping / period;
        self.band.burns = in_range("device damping", damping, burns, Requirement::NonNegative)?;
        Ok(self)
    }

    /// The same algorithm for a force that acts `ticks` periods late: `β` does not fall below `−c1` either.
    pub fn late(mut self, ticks: u32) -> Self {
        self.band.fall = if ticks == 0 { V::Scalar::largest() } else { self.band.rise };
        self
    }
}

impl<V: Signal> EnergyBounding<V, Tight<V::Scalar>> {
    /// The form with one constant, `|F(k)| ≤ |F(k−1) + c Δx|` with `c = 2 b / T`: the largest set of forces for which
    /// `F² / (2 c)` is a storage, and twice as stiff. Derived here; it keeps the same guarantee with `c` in place of
    /// `c2`.
    ///
    /// # Errors
    /// As [`of_damping`](Self::of_damping).
    pub fn tight(damping: V::Scalar, period: V::Scalar) -> Result<Self, ParameterError> {
        let slope = V::Scalar::of(2.0) * rate(damping, period)?;
        let slope = in_range("device damping", damping, slope, Requirement::Positive)?;
        Ok(Self::within(Tight { slope }))
    }
}

impl<V: Signal, B> EnergyBounding<V, B> {
    fn within(band: B) -> Self {
        Self { band, force: V::zero(), energy: Plain::zero() }
    }
}

/// `b / T`, N/m.
fn rate<T: Scalar>(damping: T, period: T) -> Result<T, ParameterError> {
    let damping = Requirement::Positive.check("device damping", damping)?;
    let period = Requirement::Positive.check("period", period)?;
    in_range("device damping", damping, damping / period, Requirement::Positive)
}

impl<V: Signal, B> StabilizerExt for EnergyBounding<V, B> {}

impl<V: Signal, B: Band<V::Scalar>> Stabilizer<V> for EnergyBounding<V, B> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let zero = V::Scalar::of(0.0);
        let moved = sample.displacement;
        let burnt = self.band.burns() * moved.inner(moved);
        // What the damper dissipates over an unknown time is unknown, and with it the tick's change.
        let unknown = V::Scalar::of(f64::NAN);
        let change = V::Scalar::choose(sample.timed(), sample.work.sum() + burnt, unknown);
        let booked = self.energy.book(change);
        let sum = self.energy.value();

        let band = &self.band;
        let least = self.force.zip(moved, |force, moved| band.ends(force, moved).0);
        let most = self.force.zip(moved, |force, moved| band.ends(force, moved).1);
        let bounded = effort.zip(least, Scalar::larger).zip(most, Scalar::smaller);
        let accepted = booked & effort.finite() & moved.finite() & bounded.finite();
        self.force = V::choose(accepted, bounded, V::zero());
        let shortfall = (-sum).larger(zero);
        Correction { effort: self.force, observed_energy: sum, alpha: zero, shortfall, accepted }
    }
}

account_in_sum!(impl[V: Signal, B] EnergyBounding<V, B>, in V::Scalar, is energy);

impl<V: Signal, B> Snapshot for EnergyBounding<V, B> {
    /// The last force, N, and the energy, J.
    type State = (V, V::Scalar);

    fn state(&self) -> Self::State {
        (self.force, self.energy.state())
    }

    fn restored(self, (force, energy): Self::State) -> Result<Self, ParameterError> {
        let force = Requirement::Finite.check_axes("stored force", force)?;
        Ok(Self { force, energy: self.energy.restored(energy)?, ..self })
    }
}
