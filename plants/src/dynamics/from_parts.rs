//! Equations of motion that come of parts.

use lyapunov_core::ParameterError;

/// An equation of motion whose coefficients come of the masses, dampers and springs it is made of.
pub trait FromParts: Sized {
    /// An [`Impedance`](crate::Impedance), or one for each mass.
    type Parts: Copy;

    /// The same equation of motion of other `parts`.
    ///
    /// # Errors
    /// A part that does not exist, named.
    fn made_of(&self, parts: Self::Parts) -> Result<Self, ParameterError>;
}
