//! The laws of an integrator.

use num_traits::Float;

use super::tick::spread;
use crate::laws::{Allowed, Law, Tick, Violation, quantity};
use crate::{Dynamics, Integrator, Scalar, Signal};

/// Steps of the coarse runs over the interval.
const COARSE: [u32; 4] = [8, 16, 32, 64];
/// Number of places at which runs are compared: at a single one, errors of different signs may cancel.
const PLACES: usize = 8;
/// Steps of the reference run.
const FINE: u32 = 2048;
/// Allowed distance of a regressed slope below the order.
const SLACK: f64 = 0.25;

/// Check of an `integrator` on `dynamics`: the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NothingForNothing`](Law::NothingForNothing) (over an interval of 0 the gain is exactly 0),
/// [`LaneByLane`](Law::LaneByLane) and [`Converges`](Law::Converges), from each of the `starts` under its held input
/// over `interval` s.
///
/// Runs of 8, 16, 32 and 64 steps over the interval are compared with 2048 steps of Kutta's 3/8 rule; the slope of the
/// logarithm of their errors over that of the step must be at least `order` less a quarter. Errors of the size of
/// rounding are left out, so that an exact integrator has any order. An error is the sum over eight places and over all
/// axes, each relative to its largest magnitude. Choose an interval in which the fastest motion turns about one radian.
///
/// # Errors
/// The first law that is broken, with the start as its sample; for [`Converges`](Law::Converges), with the slope.
pub fn integrator<U, D, I>(
    integrator: &I,
    dynamics: &D,
    starts: impl IntoIterator<Item = (D::State, U)>,
    interval: U::Scalar,
    order: u32,
) -> Result<(), Violation>
where
    U: Signal,
    D: Dynamics<U>,
    I: Integrator<U, D> + Clone,
{
    for (index, (from, input)) in starts.into_iter().enumerate() {
        let now = Tick(index);
        let run = |from, input, interval| {
            let mut integrator = integrator.clone();
            integrator.step(dynamics, from, input, interval)
        };
        let told = now.told(quantity::RESULT);
        let gain = run(from, input, interval);
        told.finite(Law::Finite, gain)?;
        told.same(Law::Repeatable, gain, run(from, input, interval))?;
        let still = run(from, input, U::Scalar::of(0.0));
        told.same(Law::NothingForNothing, D::State::splat(U::Scalar::of(0.0)), still)?;
        for lane in 0..U::Scalar::LANES {
            let alone = run(spread(from, lane), spread(input, lane), interval);
            told.same(Law::LaneByLane, spread(gain, lane), spread(alone, lane))?;
        }
        converges(now, integrator, dynamics, from, input, interval, order)?;
    }
    Ok(())
}

/// States of a run of `steps` steps, at the end of each of [`PLACES`] equal parts of the interval.
fn follow<X: Signal>(
    from: X,
    interval: X::Scalar,
    steps: u32,
    mut gain: impl FnMut(X, X::Scalar) -> X,
) -> [X; PLACES] {
    let step = interval / X::Scalar::of(steps.into());
    let mut at = from;
    core::array::from_fn(|_| {
        for _ in 0..steps / PLACES as u32 {
            at = at + gain(at, step);
        }
        at
    })
}

/// Kutta's 3/8 rule, of order 4 (Kutta 1901).
fn three_eighths<U: Signal, D: Dynamics<U>>(
    dynamics: &D,
    from: D::State,
    input: U,
    step: U::Scalar,
) -> D::State {
    let times = |rate: D::State, factor: f64| rate.scale(step * U::Scalar::of(factor));
    let first = dynamics.rate(from, input);
    let second = dynamics.rate(from + times(first, 1.0 / 3.0), input);
    let third = dynamics.rate(from + times(first, -1.0 / 3.0) + times(second, 1.0), input);
    let last = from + times(first, 1.0) + times(second, -1.0) + times(third, 1.0);
    let fourth = dynamics.rate(last, input);
    times(first, 0.125) + times(second, 0.375) + times(third, 0.375) + times(fourth, 0.125)
}

fn converges<U, D, I>(
    now: Tick,
    integrator: &I,
    dynamics: &D,
    from: D::State,
    input: U,
    interval: U::Scalar,
    order: u32,
) -> Result<(), Violation>
where
    U: Signal,
    D: Dynamics<U>,
    I: Integrator<U, D> + Clone,
{
    let fine = follow(from, interval, FINE, |at, step| three_eighths(dynamics, at, input, step));
    let size = fine.into_iter().fold(from.map(Scalar::magnitude), |size, at| {
        size.zip(at, |size, axis| size.larger(axis.magnitude()))
    });
    let size = size.map(|axis| axis + U::Scalar::smallest_normal());
    let errors = COARSE.map(|steps| {
        let mut integrator = integrator.clone();
        let coarse =
            follow(from, interval, steps, |at, step| integrator.step(dynamics, at, input, step));
        let mut error = U::Scalar::of(0.0);
        for (coarse, fine) in coarse.into_iter().zip(fine) {
            error += (coarse - fine).zip(size, |error, size| error.magnitude() / size).sum();
        }
        error
    });
    // Each step rounds each axis once, by at most half a unit in the last place.
    let axes = D::State::splat(U::Scalar::of(1.0)).sum();
    let rounding = axes * U::Scalar::epsilon() * U::Scalar::of(f64::from(FINE));
    for lane in 0..U::Scalar::LANES {
        let errors = errors.map(|error| error.lane(lane));
        let Some(slope) = slope(errors, rounding.lane(lane)) else { continue };
        if slope.is_nan() || slope < f64::from(order) - SLACK {
            return Err(Violation {
                law: Law::Converges,
                tick: now.0,
                lane: lane as u32,
                quantity: quantity::ORDER,
                value: slope,
                allowed: Allowed::From(f64::from(order) - SLACK),
                drive: None,
            });
        }
    }
    Ok(())
}

/// Least-squares slope `d log error / d log step` over the errors above `rounding`, if there are at least two.
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
