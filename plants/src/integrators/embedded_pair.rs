//! Methods with an estimate of their own error.

use lyapunov_core::{Dynamics, Scalar, Signal};

/// A one-step method that estimates the error of its own step from stages that it evaluates anyway.
pub trait EmbeddedPair<U: Signal, D: Dynamics<U>> {
    /// The power of the step with which the estimate falls.
    const ESTIMATE: u32;

    /// The gain of `from` over `interval` s while `input` is held, and the estimated size of its error.
    ///
    /// `size` measures an error, given the gain it belongs to; it is not finite where the error is not.
    fn attempt(
        &self,
        dynamics: &D,
        from: D::State,
        input: U,
        interval: U::Scalar,
        size: impl Fn(D::State, D::State) -> U::Scalar,
    ) -> (D::State, U::Scalar);
}

/// A row of a Runge-Kutta method: the stages that count, and their weights.
pub(super) type Row = &'static [(usize, f64)];

/// The rates at each stage of an explicit Runge-Kutta method, one row of `rows` for each stage after the
/// first.
#[inline]
pub(super) fn stages<U: Signal, D: Dynamics<U>, const S: usize>(
    dynamics: &D,
    from: D::State,
    input: U,
    interval: U::Scalar,
    rows: &[Row],
) -> [D::State; S] {
    let mut stages = [dynamics.rate(from, input); S];
    for (stage, row) in (1..S).zip(rows) {
        stages[stage] = dynamics.rate(from + summed(&stages, row, interval), input);
    }
    stages
}

/// `interval Σ row[i] stages[i]`.
#[inline]
pub(super) fn summed<X: Signal, const S: usize>(
    stages: &[X; S],
    row: Row,
    interval: X::Scalar,
) -> X {
    let mut sum = X::splat(X::Scalar::of(0.0));
    for &(stage, weight) in row {
        sum = sum + stages[stage].scale(X::Scalar::of(weight));
    }
    sum.scale(interval)
}
