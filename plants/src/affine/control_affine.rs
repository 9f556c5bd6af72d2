//! `ControlAffine` trait: a plant that is affine in its input.

use lyapunov_core::{LyapunovFunction, Scalar, Signal};
use nalgebra::SVector;

/// A plant of `N` states that is affine in its `M` inputs: `ẋ = f(x) + g(x) u`.
///
/// The state is relative to the rest of the plant, in SI units; `u` is the output of its actuators. With a
/// [`LyapunovFunction`] `V` the plant has a port: `V̇ = L_f V + L_g V u`, so `u` feeds `V` along the flow `y = L_g V`,
/// as a force feeds an energy along a velocity.
///
/// ```
/// use lyapunov_plants::ControlAffine;
/// use nalgebra::{Vector1, Vector2};
/// /// A pendulum of 1 m and 1 kg that hangs, turned by a torque; the state is angle and rate.
/// struct Pendulum;
/// impl ControlAffine<f64, 2, 1> for Pendulum {
///     fn drift(&self, x: Vector2<f64>) -> Vector2<f64> {
///         Vector2::new(x[1], -9.81 * libm::sin(x[0]))
///     }
///     fn input_fields(&self, _: Vector2<f64>) -> [Vector2<f64>; 1] {
///         [Vector2::new(0.0, 1.0)]
///     }
/// }
/// ```
pub trait ControlAffine<T: Scalar, const N: usize, const M: usize> {
    /// `f(x)`: the rate of the state without input, per s.
    fn drift(&self, state: SVector<T, N>) -> SVector<T, N>;

    /// The columns of `g(x)`: the rate of the state per unit of each input, per s.
    fn input_fields(&self, state: SVector<T, N>) -> [SVector<T, N>; M];

    /// The rate of the state, `f(x) + g(x) u`, per s.
    #[inline]
    fn rate(&self, state: SVector<T, N>, input: SVector<T, M>) -> SVector<T, N> {
        let fields = self.input_fields(state);
        let mut rate = self.drift(state);
        for (field, push) in fields.into_iter().zip(input.data.0[0]) {
            rate += field.scale(push);
        }
        rate
    }

    /// `L_g V`, the derivative of `function` along each input's field: the flow of the port.
    #[inline]
    fn flow<F>(&self, function: &F, state: SVector<T, N>) -> SVector<T, M>
    where
        F: LyapunovFunction<SVector<T, N>>,
    {
        let gradient = function.gradient(state);
        SVector::from(self.input_fields(state).map(|field| field.inner(gradient)))
    }
}

impl<T, P, const N: usize, const M: usize> ControlAffine<T, N, M> for &P
where
    T: Scalar,
    P: ControlAffine<T, N, M> + ?Sized,
{
    #[inline]
    fn drift(&self, state: SVector<T, N>) -> SVector<T, N> {
        (**self).drift(state)
    }

    #[inline]
    fn input_fields(&self, state: SVector<T, N>) -> [SVector<T, N>; M] {
        (**self).input_fields(state)
    }
}
