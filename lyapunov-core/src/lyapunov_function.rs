//! Lyapunov function: a function of a plant's state that must not grow.

use crate::Signal;

/// Lyapunov function, or a candidate for one: `V(x)` and its gradient, for a state `x` counted from the plant's
/// intended rest.
///
/// `V(0) = 0`, and `V > 0` elsewhere, at least wherever the plant goes. Its unit is that of the observer's sum: J if
/// it is an energy. Check one of your own with [`laws::lyapunov_function`](crate::laws::lyapunov_function).
///
/// ```
/// use lyapunov_core::{LyapunovFunction, laws};
/// use nalgebra::Vector2;
/// /// Of 2 kg on a spring of 50 N/m; the state is position and velocity.
/// struct Energy;
/// impl LyapunovFunction<Vector2<f64>> for Energy {
///     fn value(&self, x: Vector2<f64>) -> f64 {
///         0.5 * (50.0 * x[0] * x[0] + 2.0 * x[1] * x[1])
///     }
///     fn gradient(&self, x: Vector2<f64>) -> Vector2<f64> {
///         Vector2::new(50.0 * x[0], 2.0 * x[1])
///     }
/// }
/// laws::lyapunov_function(&Energy, [Vector2::new(0.1, 0.0), Vector2::new(-0.3, 2.0)])?;
/// # Ok::<(), laws::Violation>(())
/// ```
pub trait LyapunovFunction<X: Signal> {
    /// `V(x)`.
    fn value(&self, state: X) -> X::Scalar;

    /// `∂V/∂x`, axis by axis.
    fn gradient(&self, state: X) -> X;
}

impl<X: Signal, F: LyapunovFunction<X> + ?Sized> LyapunovFunction<X> for &F {
    #[inline]
    fn value(&self, state: X) -> X::Scalar {
        (**self).value(state)
    }

    #[inline]
    fn gradient(&self, state: X) -> X {
        (**self).gradient(state)
    }
}
