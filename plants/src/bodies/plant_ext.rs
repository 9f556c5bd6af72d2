//! Adaptors of a body, chained.

use lyapunov_core::{ParameterError, Plant, Signal};

use crate::{ExternalForce, Grip, HandMotion, Jitter, OperatedBody, Trajectory};

/// The adaptors that may act on a body beside its port, chained like [`OnePortExt`](crate::OnePortExt) on ports,
/// innermost first: jitter, the motion of the rest, the grip, external forces.
///
/// A jitter moves the body with parts of its own, so a grip outside of it takes effect and one inside does not.
/// External forces stand outermost, so that the sample reports the port's effort.
///
/// ```
/// use lyapunov_core::{ParameterError, Plant};
/// use lyapunov_plants::{Body, Constant, Impedance, PlantExt, Sine};
/// let loose = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
/// let firm = Impedance { stiffness: 400.0, ..loose };
/// let mut plant = Body::new(loose, 1e-3)?
///     .led_by(Sine::new(0.0, 0.01, 2.0, 1000.0)?)
///     .gripped(loose, [(500, firm)])?
///     .pushed(Constant::new(0.5)?);
/// let sample = plant.advance(0.0);
/// # assert!(sample.position > 0.0);
/// # Ok::<(), ParameterError>(())
/// ```
pub trait PlantExt<V: Signal>: Plant<V> + Sized {
    /// Adds the external force `trajectory`, N, in +x: a load, a pulse.
    #[must_use]
    fn pushed<C: Trajectory<V>>(self, trajectory: C) -> ExternalForce<Self, C> {
        ExternalForce::new(self, trajectory)
    }

    /// Moves the rest of the operator's spring along `trajectory`, m.
    #[must_use]
    fn led_by<C: Trajectory<V>>(self, trajectory: C) -> HandMotion<Self, C>
    where
        Self: OperatedBody<V>,
    {
        HandMotion::new(self, trajectory)
    }

    /// Gives the body its `own` parts, and others from the ticks of `table` on.
    ///
    /// # Errors
    /// A tick below the one before it; parts of which this body cannot be made.
    fn gripped<R>(
        self,
        own: Self::Parts,
        table: R,
    ) -> Result<Grip<Self, R, V::Scalar>, ParameterError>
    where
        Self: OperatedBody<V>,
        R: AsRef<[(u64, Self::Parts)]>,
    {
        Grip::new(self, own, table)
    }

    /// Moves the body, made of `parts`, for intervals that deviate from its period by `deviation` s times the standard
    /// normal numbers of `normal`.
    ///
    /// # Errors
    /// `deviation` below 0, infinite or NaN; parts of which this body cannot be made.
    fn jittered<G>(
        self,
        parts: Self::Parts,
        deviation: V::Scalar,
        normal: G,
    ) -> Result<Jitter<Self, Self::Parts, V::Scalar, G>, ParameterError>
    where
        Self: OperatedBody<V>,
        G: FnMut() -> V::Scalar,
    {
        Jitter::new(self, parts, deviation, normal)
    }
}

impl<V: Signal, B: Plant<V>> PlantExt<V> for B {}
