//! Equations of motion that come of parts.

use lyapunov_core::ParameterError;

/// An equation of motion whose coefficients come of the masses, dampers and springs it is made of.
pub trait Assembled: Sized {
    /// An [`Impedance`](crate::Impedance), or one for each mass.
    type Parts: Copy;

    /// The equation of motion of `parts`.
    ///
    /// # Errors
    /// A part that does not exist, named.
    fn assembled(parts: Self::Parts) -> Result<Self, ParameterError>;
}
