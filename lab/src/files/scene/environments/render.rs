//! What is made of the library's environment, whose type only the scene knows.

use lyapunov::{LyapunovCandidate, ParameterError, Signal, environments::ForceLaw};

/// What is made of an environment and the term of its own damper, both of types that only the scene knows.
pub trait Render<V: Signal> {
    /// What is made of them.
    type Made;

    /// Makes it.
    ///
    /// # Errors
    /// Whatever the making meets.
    fn render(
        self,
        environment: impl ForceLaw<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError>;
}

/// The law itself, boxed.
pub(super) struct Boxed;

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
