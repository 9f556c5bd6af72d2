//! Energy bounding: forces that hand back no more than the device's damper dissipates.

mod band;

use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Requirement, Scalar, Signal,
    Snapshot, Stabilizer,
};

use crate::StabilizerExt;
use crate::account::account_in_sum;
use crate::limiting::limiting;
use crate::range::in_range;
use band::Band;
pub use band::{PublishedBand, TightBand};

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
/// **A sample that spans more than the period `T`**, as after a missed reading, finds a damper that dissipated no more than
/// `b Δx² / T(k)`, with `T(k)` the sample's own period. There the force also has to be within what is left of the stored energy,
/// `F(k)² ≤ F(k−1)² + 2 c2 (F(k−1) Δx + b Δx² / T(k))`, which is `(F(k−1) + c2 Δx)² − ε (c2 Δx)²` with `ε = 1 − 2 b / (c2 T(k))`.
/// Over `T` itself the band above is within it, so that a clock that jitters changes the force by as much as it jitters. The
/// guarantee holds as long as `T(k) ≤ 2 b / c2`. Over a longer time a held force may give more than is stored, which the shortfall
/// tells.
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
pub struct EnergyBounding<
    V: Signal,
    B = PublishedBand<<V as Signal>::Scalar>,
    A = Plain<<V as Signal>::Scalar>,
> {
    band: B,
    /// The longest period over which `b Δx² / T` is what the damper dissipates.
    period: V::Scalar,
    force: V,
    energy: A,
}

impl<V: Signal> EnergyBounding<V> {
    /// The algorithm with the constants `c1` and `c2`, N/m; it relies on a device damping of `c1 T` with the longest period of any
    /// sample. Where samples may span several periods, give damping and period: [`on_damping`](Self::on_damping).
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
        let band = PublishedBand { rise, release, fall, burns: rise };
        Ok(Self::within(band, V::Scalar::largest()))
    }

    /// `c1 = c2 = b / T`, for a device that surely has the viscous `damping` b, N·s/m.
    ///
    /// # Errors
    /// `damping` or `period` not above 0 and finite, or their quotient out of range.
    pub fn of_damping(damping: V::Scalar, period: V::Scalar) -> Result<Self, ParameterError> {
        let slope = rate(damping, period)?;
        Self::new(slope, slope)?.on_damping(damping, period)
    }

    /// The same algorithm for a force that acts `ticks` d periods late: both constants divided by `1 + d`, and `β` does not
    /// [fall](Self::with_bounded_fall) below `−c1` either. Derived here: while a force waits the motion goes on, and then each late
    /// tick costs at most `c1 Σ Δx²`.
    ///
    /// # Errors
    /// A constant that the division takes out of range.
    pub fn delayed(mut self, ticks: u32) -> Result<Self, ParameterError> {
        let times = V::Scalar::of(1.0 + f64::from(ticks));
        let PublishedBand { rise, release, .. } = self.band;
        let within = |name, constant: V::Scalar| in_range(name, constant, constant / times);
        self.band.rise = within("energy-bounding c1", rise)?;
        self.band.release = within("energy-bounding c2", release)?;
        Ok(if ticks == 0 { self } else { self.with_bounded_fall() })
    }

    /// The same algorithm on a device that has the viscous `damping` b, N·s/m, which may be another than `c1 T`, at the `period` T, s;
    /// what it dissipates is counted in the observed energy.
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
        Requirement::InRange.require("device damping", damping, burns.finite())?;
        (self.period, self.band.burns) = (period, burns);
        Ok(self)
    }

    /// The same algorithm with `β ≥ −c1` as well, which a late force needs besides constants of at most `b / (T (1 + d))`;
    /// [`delayed`](Self::delayed) does both.
    #[must_use]
    pub fn with_bounded_fall(mut self) -> Self {
        self.band.fall = self.band.rise;
        self
    }
}

impl<V: Signal> EnergyBounding<V, TightBand<V::Scalar>> {
    /// The form with one constant, `|F(k)| ≤ |F(k−1) + c Δx|` with `c = 2 b / T`: the largest set of forces for which
    /// `F² / (2 c)` is a storage, and twice as stiff. Derived here; it keeps the same guarantee with `c` in place of
    /// `c2`.
    ///
    /// # Errors
    /// As [`of_damping`](Self::of_damping).
    pub fn tight(damping: V::Scalar, period: V::Scalar) -> Result<Self, ParameterError> {
        let slope = V::Scalar::of(2.0) * rate(damping, period)?;
        let slope = in_range("device damping", damping, slope)?;
        Ok(Self::within(TightBand { slope }, period))
    }
}

impl<V: Signal, B> EnergyBounding<V, B> {
    fn within(band: B, period: V::Scalar) -> Self {
        Self { band, period, force: V::zero(), energy: Plain::zero() }
    }
}

impl<V: Signal, B, A: Accumulator<V::Scalar>> EnergyBounding<V, B, A> {
    /// The same stabilizer with its energies summed in a `C`.
    #[must_use]
    pub fn summed_in<C: Accumulator<V::Scalar>>(self) -> EnergyBounding<V, B, C> {
        let Self { band, period, force, energy } = self;
        EnergyBounding { band, period, force, energy: C::holding(energy.value()) }
    }
}

/// The largest force, N, after one of `force` over a displacement that asks for another `given` N, of which the share `lost` is not
/// stored: `√((F + g)² − ε g²)`, and 0 where nothing is left, without squares that are out of range.
#[inline(always)]
fn kept<T: Scalar>(force: T, given: T, lost: T) -> T {
    let (whole, given) = ((force + given).magnitude(), given.magnitude());
    let size = whole.larger(given).larger(T::smallest_normal());
    let (whole, given) = (whole / size, given / size);
    size * (whole * whole - lost * (given * given)).larger(T::of(0.0)).sqrt()
}

/// `b / T`, N/m.
fn rate<T: Scalar>(damping: T, period: T) -> Result<T, ParameterError> {
    let damping = Requirement::Positive.check("device damping", damping)?;
    let period = Requirement::Positive.check("period", period)?;
    in_range("device damping", damping, damping / period)
}

impl<V: Signal, B, A> StabilizerExt for EnergyBounding<V, B, A> {}

impl<V, B, A> Stabilizer<V> for EnergyBounding<V, B, A>
where
    V: Signal,
    B: Band<V::Scalar>,
    A: Accumulator<V::Scalar>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let [one, two] = [1.0, 2.0].map(V::Scalar::of);
        let moved = sample.displacement;
        let share = (self.period / sample.period).smaller(one);
        let burns = self.band.burns() * share;
        let burnt = burns * moved.inner(moved);
        // What the damper dissipates over an unknown time is unknown, and with it the tick's change.
        let unknown = V::Scalar::of(f64::NAN);
        let change = V::Scalar::choose(sample.timed(), sample.work.sum() + burnt, unknown);
        let booked = self.energy.book(change);

        let band = &self.band;
        let least = self.force.zip(moved, |force, moved| band.ends(force, moved).0);
        let most = self.force.zip(moved, |force, moved| band.ends(force, moved).1);
        let bounded = effort.zip(least, Scalar::larger).zip(most, Scalar::smaller);

        let release = band.release();
        let lost = (one - two * burns / release).larger(-V::Scalar::largest());
        let size = self.force.zip(moved, |force, moved| kept(force, release * moved, lost));
        let within = bounded.zip(size, |force, size| force.larger(-size).smaller(size));
        let bounded = V::choose(share.below(one), within, bounded);
        let accepted = booked & effort.finite() & moved.finite() & bounded.finite();
        let correction = limiting(bounded, self.energy.value(), accepted);
        self.force = correction.effort;
        correction
    }
}

account_in_sum!(
    impl[V: Signal, B, A: Accumulator<V::Scalar>] EnergyBounding<V, B, A>, in V::Scalar, is energy
);

impl<V: Signal, B, A: Accumulator<V::Scalar> + Snapshot> Snapshot for EnergyBounding<V, B, A> {
    /// The last force, N, and the energy, J.
    type State = (V, A::State);

    fn state(&self) -> Self::State {
        (self.force, self.energy.state())
    }

    fn restored(self, (force, energy): Self::State) -> Result<Self, ParameterError> {
        let force = Requirement::Finite.check_axes("stored force", force)?;
        Ok(Self { force, energy: self.energy.restored(energy)?, ..self })
    }
}
