//! Scale of the feedback.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
};

use crate::{ForceLaw, Kinematics, Surface, Time};

/// A port whose effort is scaled, `f_out(n) = s(n) f_in(n)`, by a scale that may change in the loop.
///
/// A spring that is compressed at a scale of 1 and released at 2 gives back twice what it took: changing the scale by
/// `Δs` does the work `Δs S`, with `S` what the port inside has stored. A sample carries the effort that was applied,
/// so that work is in the books of a stabilizer **outside** of the scale, joule by joule as it comes out. So that is
/// where it stands, `port.scaled(s)?.stabilized(c)`; inside, its own correction would be scaled as well.
///
/// A scale of 1 changes no bit. Around a [`ForceLaw`] this is one too: force and stored energy at the present scale, so
/// the work of a change is the difference of [`stored`](ForceLaw::stored) before and after it.
///
/// ```
/// use lyapunov_core::{OnePort, PortEnergy, PortSample, Stabilizer};
/// use lyapunov_plants::{OnePortExt, Spring};
/// let mut port = Spring::new(1000.0)?.scaled(0.5)?;
/// let pressed = PortSample::starting(1e-3, 0.01, 0.0);
/// assert_eq!(port.respond(&pressed), 5.0);
/// port.set_scale(1.0)?;
/// assert_eq!(port.respond(&pressed), 10.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled<P, T> {
    port: P,
    scale: T,
}

lends_port!([P, T] Scaled<P, T>);

impl<P, T: Scalar> Scaled<P, T> {
    pub(crate) fn new(port: P, scale: T) -> Result<Self, ParameterError> {
        Ok(Self { port, scale: Self::checked(scale)? })
    }

    /// The present scale.
    pub fn scale(&self) -> T {
        self.scale
    }

    /// Changes the scale between two ticks, from the next effort on.
    ///
    /// # Errors
    /// `scale` below 0, infinite or NaN; the old one stays.
    #[inline]
    pub fn set_scale(&mut self, scale: T) -> Result<(), ParameterError> {
        self.scale = Self::checked(scale)?;
        Ok(())
    }

    fn checked(scale: T) -> Result<T, ParameterError> {
        Requirement::NonNegative.check("feedback scale", scale)
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Scaled<P, V::Scalar> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        self.port.respond(sample).scale(self.scale)
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<V: Signal, L: ForceLaw<V>> ForceLaw<V> for Scaled<L, V::Scalar> {
    #[inline]
    fn force(&self, motion: &Kinematics<V>) -> V {
        self.port.force(motion).scale(self.scale)
    }

    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar {
        self.port.stored(motion) * self.scale
    }

    fn surface(&self, time: Time<V::Scalar>) -> Option<Surface<V>> {
        self.port.surface(time)
    }
}

lyapunov_core::snapshot!(impl[P: Snapshot, T: Scalar] Scaled<P, T>, is port, of P::State);
