//! The laws of a Lyapunov function.

use num_traits::Float;

use crate::laws::{Allowed, Law, Tick, Violation, quantity};
use crate::signal_axes::{axes, axis_of, largest_axis};
use crate::{LyapunovFunction, Scalar, Signal};

/// Check of a `function` at the `states` visited and at rest: the laws [`Finite`](Law::Finite),
/// [`ZeroAtRest`](Law::ZeroAtRest), [`Positive`](Law::Positive) and [`Slope`](Law::Slope).
///
/// The gradient is compared with central differences on each axis, `D(h) = (V(x + h) − V(x − h)) / 2h`, with
/// `h = ε^⅓` of the state's largest axis. The two may differ by the sum of four terms: twice `|D(2h) − D(h)|`, six
/// times the error of such differences for a smooth function; half the difference of the slopes ahead and behind, the
/// error at a kink of the gradient, as at a contact; the rounding of `V` over `h`; and `ε^⅓` of the gradient. In all,
/// the check finds errors of a gradient from about 1e-5 of it in `f64` and from a few hundredths in `f32`. A `V` that
/// loses its digits by cancellation near rest fails too, as it should; write `1 − cos θ` as `2 sin²(θ/2)`.
///
/// Only the given states are checked. Whether `V` falls along the motion, only a run can show.
///
/// # Errors
/// The first law that is broken, with the state as its sample; at rest, sample 0.
///
/// ```
/// use lyapunov_core::{LyapunovFunction, laws};
/// use nalgebra::Vector2;
/// /// `V = |x|²`, with half of its slope.
/// struct Half;
/// impl LyapunovFunction<Vector2<f64>> for Half {
///     fn value(&self, state: Vector2<f64>) -> f64 {
///         state.dot(&state)
///     }
///     fn gradient(&self, state: Vector2<f64>) -> Vector2<f64> {
///         state
///     }
/// }
/// let broken = laws::lyapunov_function(&Half, [Vector2::new(3.0, 0.0)]).unwrap_err();
/// assert_eq!(broken.law, laws::Law::Slope);
/// ```
pub fn lyapunov_function<X: Signal, F: LyapunovFunction<X>>(
    function: &F,
    states: impl IntoIterator<Item = X>,
) -> Result<(), Violation> {
    let zero = X::Scalar::of(0.0);
    let rest = X::splat(zero);
    Tick(0).told(quantity::VALUE_AT_REST).same(Law::ZeroAtRest, function.value(rest), zero)?;
    slopes(Tick(0), function, rest)?;
    for (index, state) in states.into_iter().enumerate() {
        let now = Tick(index);
        let value = function.value(state);
        now.told(quantity::VALUE).finite(Law::Finite, value)?;
        now.told(quantity::GRADIENT).finite(Law::Finite, function.gradient(state))?;
        let away = state.inner(state).above(X::Scalar::smallest_normal());
        let kept = !away | value.above(zero);
        let least = |lane| Allowed::From(X::Scalar::smallest_positive().lane(lane));
        now.told(quantity::VALUE).require(Law::Positive, kept, value, least)?;
        slopes(now, function, state)?;
    }
    Ok(())
}

/// Comparison of the gradient with differences of the value, axis by axis.
fn slopes<X: Signal>(
    now: Tick,
    function: &impl LyapunovFunction<X>,
    state: X,
) -> Result<(), Violation> {
    let of = X::Scalar::of;
    let share = of(Float::cbrt(X::Scalar::epsilon().lane(0)));
    let size = largest_axis(state);
    let size = X::Scalar::choose(size.above(of(0.0)), size, of(1.0));
    let step = share * size;
    let (here, gradient) = (function.value(state), function.gradient(state));
    // The size of the terms that may cancel in V, taking every axis as a term of its own.
    let steepness = gradient.times(state).map(Scalar::magnitude).sum() / size;
    for axis in 0..axes::<X>() {
        let at = |steps: f64| function.value(moved(state, axis, step * of(steps)));
        let [ahead, behind, far_ahead, far_behind] = [at(1.0), at(-1.0), at(2.0), at(-2.0)];
        let near = (ahead - behind) / (step * of(2.0));
        let far = (far_ahead - far_behind) / (step * of(4.0));
        let told = axis_of(gradient, axis);
        let heights = far_ahead.magnitude() + far_behind.magnitude();
        let bend = (ahead - here - (here - behind)) / step;
        let tolerance = of(2.0) * (far - near).magnitude()
            + of(0.5) * bend.magnitude()
            + of(8.0) * X::Scalar::epsilon() * heights / step
            + share * (told.magnitude() + steepness)
            + X::Scalar::smallest_normal();
        let apart = told - near;
        let allowed = |lane| Allowed::Within(tolerance.lane(lane));
        let kept = apart.magnitude().below(tolerance);
        now.told(quantity::GRADIENT).require(Law::Slope, kept, apart, allowed)?;
    }
    Ok(())
}

fn moved<X: Signal>(state: X, axis: usize, by: X::Scalar) -> X {
    let mut index = 0;
    state.map(|value| {
        let moved = if index == axis { value + by } else { value };
        index += 1;
        moved
    })
}
