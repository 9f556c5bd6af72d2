//! Contact of a point with a solid.

use lyapunov_core::{
    Dissipation, InContact, LyapunovCandidate, ParameterError, PortSample, Requirement, Scalar,
    Signal,
};

use crate::environments::one_sided::{depth_stored, one_sided};
use crate::{DissipationOf, ForceLaw, Kinematics, NearestPoint, Solid};

/// Contact with a solid that pushes out what enters it: `f = max(0, k p − b v·n)` along the outward normal `n` for a
/// depth `p > 0` below the nearest point of the surface, else 0.
///
/// Efforts act against the plant, so the effort returned is `−f n`: on a plane whose normal is `−x` this is the
/// [`Wall`](crate::Wall). There is no friction.
///
/// A force from depth alone has no memory of the point of entry: in a thin or soft solid the nearest surface can become
/// the far one, and the point is pushed through (Zilles and Salisbury, A constraint-based god-object method for haptic
/// display, IROS 1995, who remember the entry instead).
///
/// ```
/// use lyapunov_core::{PortSample, OnePort};
/// use lyapunov_plants::{Contact, Sphere};
/// use nalgebra::Vector2;
/// let mut ball = Contact::with(Sphere::new(Vector2::zeros(), 0.05)?, 1000.0, 0.0)?;
/// let inside = PortSample::starting(1e-3, Vector2::new(0.0, 0.04), Vector2::zeros());
/// let effort = ball.respond(&inside); // 10 N upwards on the plant
/// assert!((effort - Vector2::new(0.0, -10.0)).norm() < 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S, T> {
    solid: S,
    stiffness: T,
    damper: Dissipation<T>,
}

impl<S, T: Scalar> Contact<S, T> {
    /// Contact with `solid` of `stiffness` N/m and `damping` N·s/m.
    ///
    /// # Errors
    /// `stiffness` or `damping` below 0, infinite or NaN.
    pub fn with(solid: S, stiffness: T, damping: T) -> Result<Self, ParameterError> {
        let stiffness = Requirement::NonNegative.check("stiffness", stiffness)?;
        Ok(Self { solid, stiffness, damper: Dissipation::of(damping)? })
    }

    /// The credit of its own damper, `b (v·n)² T` strictly below the surface.
    pub fn dissipation(&self) -> DissipationOf<Self>
    where
        S: Copy,
    {
        DissipationOf(*self)
    }
}

impl<V: Signal, S: Solid<V>> ForceLaw<V> for Contact<S, V::Scalar> {
    #[inline]
    fn force(&self, motion: &Kinematics<V>) -> V {
        let NearestPoint { depth, normal } = self.solid.nearest(motion.position);
        let leaving = motion.velocity.inner(normal);
        let push = one_sided(depth, self.stiffness * depth - self.damper.damping() * leaving);
        let zero = V::Scalar::of(0.0);
        normal.map(|axis| zero - axis * push)
    }

    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar {
        depth_stored(self.stiffness, self.solid.nearest(motion.position).depth)
    }
}

impl<V: Signal, S: Solid<V>> LyapunovCandidate<V> for DissipationOf<Contact<S, V::Scalar>> {
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let Self(contact) = self;
        let NearestPoint { depth, normal } = contact.solid.nearest(sample.position);
        let inside = PortSample::starting(sample.period, depth, sample.velocity.inner(normal));
        contact.damper.gated(InContact { position: V::Scalar::of(0.0) }).decrease(&inside)
    }
}
