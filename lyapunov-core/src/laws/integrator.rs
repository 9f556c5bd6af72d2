//! The laws of an integrator.

use num_traits::Float;

use crate::laws::{Law, Tick, Violation};
use crate::{Dynamics, Integrator, Scalar, Signal, State};

/// Steps of the coarse runs over the interval.
const COARSE: [u32; 4] = [8, 16, 32, 64];
/// Steps of the run that they are compared with.
const FINE: u32 = 2048;
/// How far below its order a regressed slope may lie.
const SLACK: f64 = 0.25;

/// Checks that `integrator` keeps the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NothingForNothing`](Law::NothingForNothing) (over no time it gains exactly nothing),
/// [`LaneByLane`](Law::LaneByLane) and [`Converges`](Law::Converges) on `dynamics`, from each of the `starts` under
/// its held effort over `interval` s.
///
/// Its errors over the interval in 8, 16, 32 and 64 steps are taken against 2048 steps of Kutta's 3/8 rule, and the
/// slope of their logarithms over that of the step must be `order` or more, less a quarter. Errors of the size of
/// rounding are left out, so that an exact integrator has any order. Choose an interval in which the fastest motion
/// turns about one radian.
///
/// # Errors
/// The first law that is broken, the start as its sample; for [`Converges`](Law::Converges) the slope.
pub fn integrator<V, D, I>(
    integrator: &I,
    dynamics: &D,
    starts: impl IntoIterator<Item = (State<D::Coordinates>, V)>,
    interval: V::Scalar,
    order: u32,
) -> Result<(), Violation>
where
    V: Signal,
    D: Dynamics<V>,
    I: Integrator<V, D> + Clone,
{
    for (index, (from, effort)) in starts.into_iter().enumerate() {
        let now = Tick(index);
        let run = |from, effort, interval| {
            let mut integrator = integrator.clone();
            integrator.step(dynamics, from, effort, interval)
        };
        let gain = run(from, effort, interval);
        now.finite(Law::Finite, gain.position)?;
        now.finite(Law::Finite, gain.velocity)?;
        same(now, Law::Repeatable, gain, run(from, effort, interval))?;
        let still = State { position: zero(), velocity: zero() };
        same(now, Law::NothingForNothing, still, run(from, effort, V::Scalar::of(0.0)))?;
        for lane in 0..V::Scalar::LANES {
            let alone = State {
                position: spread(from.position, lane),
                velocity: spread(from.velocity, lane),
            };
            let alone = run(alone, spread(effort, lane), interval);
            now.same(Law::LaneByLane, spread(gain.position, lane), spread(alone.position, lane))?;
            now.same(Law::LaneByLane, spread(gain.velocity, lane), spread(alone.velocity, lane))?;
        }
        converges(now, integrator, dynamics, from, effort, interval, order)?;
    }
    Ok(())
}

fn zero<Q: Signal>() -> Q {
    Q::splat(Q::Scalar::of(0.0))
}

fn same<Q: Signal>(now: Tick, law: Law, one: State<Q>, other: State<Q>) -> Result<(), Violation> {
    now.same(law, one.position, other.position)?;
    now.same(law, one.velocity, other.velocity)
}

/// Lane `lane` of every axis, in all lanes.
fn spread<Q: Signal>(signal: Q, lane: usize) -> Q {
    signal.map(|axis| Q::Scalar::of(axis.lane(lane)))
}

/// The magnitudes of all axes of a state together, velocities over `interval`, m.
fn size<Q: Signal>(state: State<Q>, interval: Q::Scalar) -> Q::Scalar {
    let of = |signal: Q| signal.map(Scalar::magnitude).sum();
    of(state.position) + of(state.velocity) * interval
}

fn difference<Q: Signal>(one: State<Q>, other: State<Q>) -> State<Q> {
    State { position: one.position - other.position, velocity: one.velocity - other.velocity }
}

/// Where `steps` steps lead.
fn follow<Q: Signal>(
    from: State<Q>,
    interval: Q::Scalar,
    steps: u32,
    mut gain: impl FnMut(State<Q>, Q::Scalar) -> State<Q>,
) -> State<Q> {
    let step = interval / Q::Scalar::of(steps.into());
    (0..steps).fold(from, |state, _| state + gain(state, step))
}

/// Kutta's 3/8 rule, of order 4 (Kutta 1901).
fn three_eighths<V: Signal, D: Dynamics<V>>(
    dynamics: &D,
    from: State<D::Coordinates>,
    effort: V,
    step: V::Scalar,
) -> State<D::Coordinates> {
    let rate = |at: State<D::Coordinates>| State {
        position: at.velocity,
        velocity: dynamics.acceleration(at.position, at.velocity, effort),
    };
    let times = |state: State<D::Coordinates>, factor: f64| {
        let factor = step * V::Scalar::of(factor);
        State { position: state.position.scale(factor), velocity: state.velocity.scale(factor) }
    };
    let first = rate(from);
    let second = rate(from + times(first, 1.0 / 3.0));
    let third = rate(from + times(first, -1.0 / 3.0) + times(second, 1.0));
    let fourth = rate(from + times(first, 1.0) + times(second, -1.0) + times(third, 1.0));
    times(first, 0.125) + times(second, 0.375) + times(third, 0.375) + times(fourth, 0.125)
}

fn converges<V, D, I>(
    now: Tick,
    integrator: &I,
    dynamics: &D,
    from: State<D::Coordinates>,
    effort: V,
    interval: V::Scalar,
    order: u32,
) -> Result<(), Violation>
where
    V: Signal,
    D: Dynamics<V>,
    I: Integrator<V, D> + Clone,
{
    let fine = follow(from, interval, FINE, |at, step| three_eighths(dynamics, at, effort, step));
    let errors = COARSE.map(|steps| {
        let mut integrator = integrator.clone();
        let coarse =
            follow(from, interval, steps, |at, step| integrator.step(dynamics, at, effort, step));
        size(difference(coarse, fine), interval)
    });
    let moved = size(from, interval) + size(fine, interval);
    // Position and velocity are each rounded once a step, by half a unit in the last place at most.
    let rounding = moved * V::Scalar::epsilon() * V::Scalar::of(f64::from(FINE));
    for lane in 0..V::Scalar::LANES {
        let errors = errors.map(|error| error.lane(lane));
        let Some(slope) = slope(errors, rounding.lane(lane)) else { continue };
        if slope.is_nan() || slope < f64::from(order) - SLACK {
            return Err(Violation { law: Law::Converges, tick: now.0, value: slope });
        }
    }
    Ok(())
}

/// By least squares, `d log error / d log step` over the errors that are above `rounding`, if there are two.
fn slope(errors: [f64; COARSE.len()], rounding: f64) -> Option<f64> {
    let (mut count, mut x, mut y, mut xx, mut xy) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (steps, error) in
        COARSE.into_iter().zip(errors).filter(|&(_, error)| error > rounding || error.is_nan())
    {
        let (step, error) = (-Float::ln(f64::from(steps)), Float::ln(error));
        count += 1.0;
        x += step;
        y += error;
        xx += step * step;
        xy += step * error;
    }
    (count >= 2.0).then(|| (count * xy - x * y) / (count * xx - x * x))
}
