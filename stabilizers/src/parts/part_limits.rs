//! Damping limits of a rigid body: one for translation, one for rotation.

use lyapunov_core::{ParameterError, Scalar, Screw, Signal, Spatial};
use nalgebra::Vector3;

use crate::{AxisWeights, DampingLimit, DirectedDamping};

/// Mass and moment of inertia of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyInertia<T> {
    /// Mass, kg.
    pub mass: T,
    /// Moment of inertia, kg·m².
    pub moment: T,
}

#[cfg(feature = "approx")]
lyapunov_core::approximate!(impl[T: PartialEq] BodyInertia<T>, of T { mass, moment });

/// Largest damping that a stabilizer may inject into translation, N·s/m, and into rotation, N·m·s/rad.
///
/// Two numbers with two units, and no operation between them. [`PerPart`](crate::PerPart) takes one for each of its
/// stabilizers; [`DirectedDamping::within`] keeps both under a single sum.
///
/// ```
/// use lyapunov_stabilizers::{BodyInertia, PartLimits};
/// let limits = PartLimits::of_body(0.5, BodyInertia { mass: 0.4, moment: 2e-4 }, 1e-3)?;
/// assert_eq!(limits.translation.most(), 200.0); // N·s/m
/// assert!((limits.rotation.most() - 0.1_f64).abs() < 1e-15); // N·m·s/rad
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartLimits<T> {
    /// Of translation, N·s/m.
    pub translation: DampingLimit<T>,
    /// Of rotation, N·m·s/rad.
    pub rotation: DampingLimit<T>,
}

#[cfg(feature = "approx")]
lyapunov_core::approximate!(impl[T: PartialEq] PartLimits<T>, of DampingLimit<T> { translation, rotation });

impl<T: Scalar> PartLimits<T> {
    /// The limits `cap · mass / period` and `cap · moment / period` ([`DampingLimit::of_mass`]), with the smallest mass
    /// and the smallest moment of inertia that move with the port, about its reference point.
    ///
    /// Off the centre of mass they are smaller than the body's: with the centre at `c` a force at the reference point
    /// meets down to `1 / (1 / m + c² / I)`.
    ///
    /// # Errors
    /// `damping_cap` below 0 or NaN; a mass or moment of `inertia`, or `period`, not above 0 and finite.
    pub fn of_body(
        damping_cap: T,
        inertia: BodyInertia<T>,
        period: T,
    ) -> Result<Self, ParameterError> {
        let limit = |inertia| DampingLimit::of_mass(damping_cap, inertia, period);
        let translation = limit(inertia.mass)?;
        let rotation = limit(inertia.moment)
            .map_err(|error| ParameterError { parameter: renamed(error.parameter), ..error })?;
        Ok(Self { translation, rotation })
    }

    /// The limits for a wrench that acts `ticks` periods late ([`DampingLimit::delayed`]).
    #[must_use]
    pub fn delayed(self, ticks: u32) -> Self {
        let Self { translation, rotation } = self;
        Self { translation: translation.delayed(ticks), rotation: rotation.delayed(ticks) }
    }
}

/// The name under which a caller knows the inertia that [`DampingLimit`] refused.
fn renamed(parameter: &'static str) -> &'static str {
    if parameter == "mass" { "moment of inertia" } else { parameter }
}

impl<S, V: Spatial> DirectedDamping<S, AxisWeights<V>, V::Scalar> {
    /// `stabilizer` with one sum for translation and rotation, and a damping for each: both take the same share of their
    /// limits, `(s L_t v, s L_r ω)` with `0 ≤ s ≤ 1`.
    ///
    /// In proportion to mass and moment of inertia, such a correction takes the same share of velocity and angular
    /// velocity. What one part absorbed pays for the other; [`PerPart`](crate::PerPart) keeps them apart. `stabilizer`
    /// says how much to dissipate and should have no limit of its own, which would be one number for both:
    ///
    /// ```
    /// use lyapunov_core::{PortEnergy, HeldTick, Screw, Signal, Stabilizer, WorldAxes};
    /// use lyapunov_stabilizers::{BodyInertia, DampingLimit, DirectedDamping, PartLimits, Popc};
    /// use nalgebra::Vector3;
    /// let limits = PartLimits::of_body(0.5, BodyInertia { mass: 0.4, moment: 2e-4 }, 1e-3)?;
    /// let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY)?);
    /// let mut popc = DirectedDamping::within(unlimited, limits);
    /// let twist = Screw::<f64, WorldAxes>::new(Vector3::x() * 0.1, Vector3::z() * 3.0);
    /// let applied = Screw::new(Vector3::x() * -2.0, Vector3::zeros()); // gave 0.2 mJ
    /// let sample = HeldTick { period: 1e-3, position: twist.scale(1e-3), velocity: twist, displacement: twist.scale(1e-3), applied }.sample();
    /// let added = popc.stabilize(&sample, Screw::new(Vector3::zeros(), Vector3::zeros())).effort;
    /// assert!((added.translation.x / 0.1 / 200.0 - added.rotation.z / 3.0 / 0.1).abs() < 1e-12);
    /// assert!((added.inner(twist) * 1e-3 - 2e-4).abs() < 1e-15);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    pub fn within(stabilizer: S, limits: PartLimits<V::Scalar>) -> Self {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let [translation, rotation] = [limits.translation, limits.rotation].map(DampingLimit::most);
        // Numbers of two units are compared here only to keep the weights within 1; the choice leaves the law.
        let most = translation.larger(rotation);
        let share = |limit: V::Scalar| {
            V::Scalar::choose(most.above(zero), (limit / most).smaller(one), one)
        };
        let weights = Screw::new(
            Vector3::from_element(share(translation)),
            Vector3::from_element(share(rotation)),
        );
        let metric = AxisWeights::of_shares(V::of_screw(weights));
        Self::new(stabilizer, metric, DampingLimit::finite(most))
    }
}
