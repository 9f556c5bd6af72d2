//! Use of the library's environment, whose type only the scene knows.

use lyapunov::{LyapunovCandidate, ParameterError, Signal, environments::ForceLaw};

/// A use of an environment and of the credit of its own damper, whose types only the scene knows.
pub trait Render<V: Signal> {
    /// The result.
    type Made;

    /// The result for this environment and this credit.
    ///
    /// # Errors
    /// Any error on the way to the result.
    fn render(
        self,
        environment: impl ForceLaw<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError>;
}

/// The force law itself, boxed.
pub(crate) struct Boxed;

impl<V: Signal> Render<V> for Boxed {
    type Made = Box<dyn ForceLaw<V>>;

    fn render(
        self,
        environment: impl ForceLaw<V> + 'static,
        _credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError> {
        Ok(Box::new(environment))
    }
}
