//! Methods that know how wrong they are.

use lyapunov_core::{Dynamics, Scalar, Signal, State};

/// A one-step method that estimates the error of its own step from the stages it has evaluated anyway.
pub trait EmbeddedPair<V: Signal, D: Dynamics<V>> {
    /// The power of the step with which the estimate falls.
    const ESTIMATE: u32;

    /// What `from` gains over `interval` s while `effort` is held, and how large the error is estimated to be.
    ///
    /// `size` tells the size of an error, given the gain it belongs to; it is not finite where the error is not.
    fn attempt(
        &self,
        dynamics: &D,
        from: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
        size: impl Fn(State<D::Coordinates>, State<D::Coordinates>) -> V::Scalar,
    ) -> (State<D::Coordinates>, V::Scalar);
}

/// A row of a Runge-Kutta method: the stages that count, and by how much.
pub(super) type Row = &'static [(usize, f64)];

/// The rates `ẋ` and `v̇` at each stage of an explicit Runge-Kutta method, one row of `rows` for each stage after the
/// first.
#[inline]
pub(super) fn stages<V: Signal, D: Dynamics<V>, const S: usize>(
    dynamics: &D,
    from: State<D::Coordinates>,
    effort: V,
    interval: V::Scalar,
    rows: &[Row],
) -> [State<D::Coordinates>; S] {
    let rate = |State { position, velocity }: State<D::Coordinates>| State {
        position: velocity,
        velocity: dynamics.acceleration(position, velocity, effort),
    };
    let mut stages = [rate(from); S];
    for (stage, row) in (1..S).zip(rows) {
        stages[stage] = rate(from + summed(&stages, row, interval));
    }
    stages
}

/// `interval Σ row[i] stages[i]`.
#[inline]
pub(super) fn summed<Q: Signal, const S: usize>(
    stages: &[State<Q>; S],
    row: Row,
    interval: Q::Scalar,
) -> State<Q> {
    let zero = Q::splat(Q::Scalar::of(0.0));
    let mut sum = State { position: zero, velocity: zero };
    for &(stage, weight) in row {
        sum = sum + times(stages[stage], Q::Scalar::of(weight));
    }
    times(sum, interval)
}

#[inline]
fn times<Q: Signal>(state: State<Q>, factor: Q::Scalar) -> State<Q> {
    State { position: state.position.scale(factor), velocity: state.velocity.scale(factor) }
}
