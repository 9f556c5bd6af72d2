//! Hunt-Crossley contact, whose force does not jump.

use lyapunov_core::{LyapunovCandidate, ParameterError, PortSample, Requirement, Scalar};

use crate::environments::one_sided::one_sided;
use crate::{DissipationOf, ForceLaw, Kinematics, Surface, Time};

/// A one-sided contact whose damping grows with the penetration: `f = max(0, k pᵉ (1 + d v))` for
/// `p = x − position > 0`, else 0.
///
/// Unlike that of a [`Wall`](crate::Wall) with damping, the force does not jump at the surface (Hunt and Crossley,
/// Coefficient of restitution interpreted as damping in vibroimpact, Journal of Applied Mechanics 42, 1975). Hertz
/// contact has `e = 3/2`. A free mass that strikes at a low speed `u` leaves with about `1 − 2/3 d u` of it.
///
/// `k` is in N/mᵉ, `d` in s/m. The power is computed in `f64`, whatever the scalar. Without damping and with an
/// exponent of 1 it is a wall without damping, to the last bit.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::HuntCrossley;
/// let mut flesh = HuntCrossley::new(1e4, 1.5, 0.0)?;
/// let effort: f64 = flesh.respond(&PortSample::starting(1e-3, 0.01, 0.0));
/// assert!((effort - 1e4 * 0.01_f64.powf(1.5)).abs() < 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HuntCrossley<T> {
    stiffness: T,
    exponent: T,
    damping: T,
    position: T,
}

impl<T: Scalar> HuntCrossley<T> {
    /// A contact of `stiffness` N/mᵉ to the power `exponent` and of `damping` s/m, with its surface at the origin.
    ///
    /// # Errors
    /// `stiffness` or `damping` below 0, infinite or NaN; `exponent` not above 0 and finite.
    pub fn new(stiffness: T, exponent: T, damping: T) -> Result<Self, ParameterError> {
        Ok(Self {
            stiffness: Requirement::NonNegative.check("stiffness", stiffness)?,
            exponent: Requirement::Positive.check("exponent", exponent)?,
            damping: Requirement::NonNegative.check("damping", damping)?,
            position: T::zero(),
        })
    }

    /// The same contact with its surface at `position`, m.
    #[must_use]
    pub fn at(self, position: T) -> Self {
        Self { position, ..self }
    }

    /// The credit of its own damper, `k pᵉ d v² T` strictly beyond the surface.
    pub fn dissipation(&self) -> DissipationOf<Self> {
        DissipationOf(*self)
    }

    /// `k pᵉ`, meaningless at a `depth` below 0.
    #[inline]
    fn spring(&self, depth: T) -> T {
        let power = |lane| libm::pow(depth.lane(lane), self.exponent.lane(lane));
        self.stiffness * T::from_lanes(power)
    }
}

impl<T: Scalar> ForceLaw<T> for HuntCrossley<T> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<T>) -> T {
        let depth = motion.position - self.position;
        one_sided(depth, self.spring(depth) * (T::one() + self.damping * motion.velocity))
    }

    fn stored(&self, motion: &Kinematics<T>) -> T {
        let depth = (motion.position - self.position).larger(T::zero());
        let above = |lane| self.exponent.lane(lane) + 1.0;
        T::from_lanes(|lane| self.stiffness.lane(lane) / above(lane))
            * T::from_lanes(|lane| libm::pow(depth.lane(lane), above(lane)))
    }

    fn surface(&self, _time: Time<T>) -> Option<Surface<T>> {
        Some(Surface { position: self.position, velocity: T::zero() })
    }
}

impl<T: Scalar> LyapunovCandidate<T> for DissipationOf<HuntCrossley<T>> {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<T>) -> T {
        let Self(contact) = self;
        let depth = sample.position - contact.position;
        let damping = contact.spring(depth) * contact.damping;
        let burnt = damping * (sample.velocity * sample.velocity * sample.period);
        T::choose(depth.above(T::zero()) & burnt.finite(), burnt, T::zero())
    }
}
