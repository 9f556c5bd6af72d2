//! Equations of motion made of parts.

use lyapunov_core::ParameterError;

/// An equation of motion whose coefficients follow from its masses, dampers and springs.
pub trait FromParts: Sized {
    /// An [`Impedance`](crate::Impedance), or one for each mass.
    type Parts: Copy;

    /// The same equation of motion with other `parts`.
    ///
    /// # Errors
    /// An invalid part, by name.
    fn made_of(&self, parts: Self::Parts) -> Result<Self, ParameterError>;
}
