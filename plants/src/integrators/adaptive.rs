//! Step size by tolerance.

use lyapunov_core::{Dynamics, Integrator, Mask, ParameterError, Requirement, Scalar, Signal};

use crate::EmbeddedPair;

/// Most steps per interval, repeated ones included.
const ATTEMPTS: u32 = 100_000;

/// Least tolerance, in units in the last place of one.
const ROUNDINGS: f64 = 8.0;

/// A method that covers an interval in steps of its own choice: as long as possible, and so short that the estimated
/// error of each is at most `tolerance + tolerance |y|` in every axis `y` of the state, in its own unit.
///
/// `|y|` is the larger magnitude of start and end of the step, with positions relative to the rest. The errors of many
/// steps add up, and the motion amplifies or damps them: the tolerance does not bound their total.
///
/// The next step is `0.9 ε^(−1/p)` times as long, at least a fifth and at most five times, where `ε` is the estimate
/// over the allowed error and `p` the power of the step with which the estimate falls (Hairer, Nørsett and Wanner,
/// Solving Ordinary Differential Equations I, 1993, II.4); where `ε ≥ 1` the same step is tried again with that length.
/// The length is remembered from interval to interval, so the gain depends, within the tolerance, on earlier steps.
/// Each lane has its own, and moves by it as the scalar run does, bit for bit; all axes of a lane share one. A step
/// does not take constant time.
///
/// An interval that needs more than 100 000 attempts, as very stiff motion does, gains NaN, and so does one from a
/// state that is not finite: it always ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive<P, T> {
    pair: P,
    tolerance: T,
    step: T,
}

impl<P, T: Scalar> Adaptive<P, T> {
    /// Steps of `pair` by `tolerance`, m and m/s and relative alike.
    ///
    /// # Errors
    /// `tolerance` not finite, or below 8 units in the last place of one (1.8e-15, in `f32` 9.5e-7): rounding
    /// would hide the error.
    pub fn new(pair: P, tolerance: T) -> Result<Self, ParameterError> {
        let least = T::epsilon().lane(0) * ROUNDINGS;
        let tolerance = Requirement::AtLeast(least).check("tolerance", tolerance)?;
        Ok(Self { pair, tolerance, step: T::largest() })
    }

    /// The ratio of `error`, of a step from `from`, to the allowed one; not finite where the error is not.
    #[inline]
    fn size<X: Signal<Scalar = T>>(&self, from: X, gain: X, error: X) -> T {
        let (mut worst, mut poison) = (T::zero(), T::zero());
        let larger = |one: T, other: T| one.magnitude().larger(other.magnitude());
        error.zip(from.zip(from + gain, larger), |error, size| {
            let ratio = error.magnitude() / (self.tolerance + self.tolerance * size);
            worst = ratio.larger(worst);
            poison += ratio * T::zero();
            ratio
        });
        worst + poison
    }
}

/// The factor to the length of the next step, after one with the ratio `error` of the error to the allowed one.
#[inline]
fn growth<T: Scalar>(error: T, power: u32) -> T {
    T::from_lanes(|lane| {
        let error = error.lane(lane);
        let ideal = 0.9 * libm::pow(error, -1.0 / f64::from(power));
        // NaN passes neither test and takes the shortest.
        if ideal > 5.0 {
            5.0
        } else if ideal > 0.2 {
            ideal
        } else {
            0.2
        }
    })
}

impl<U, D, P> Integrator<U, D> for Adaptive<P, U::Scalar>
where
    U: Signal,
    D: Dynamics<U>,
    P: EmbeddedPair<U, D>,
{
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        let choose = <U::Scalar as Signal>::choose;
        let (zero, one) = (U::Scalar::of(0.0), U::Scalar::of(1.0));
        let nothing = D::State::splat(zero);
        let sound = from.finite() & input.finite() & interval.finite();
        let (mut gained, mut passed) = (nothing, zero);
        for _ in 0..ATTEMPTS {
            let left = interval - passed;
            let open = sound & left.above(zero);
            if !open.any() {
                break;
            }
            // A step that almost reaches the end goes there.
            let last = !(self.step * U::Scalar::of(1.1)).below(left);
            let step = choose(open, choose(last, left, self.step), zero);
            let at = from + gained;
            let size = |gain, error| self.size(at, gain, error);
            let (gain, error) = self.pair.attempt(dynamics, at, input, step, size);
            let accepted = open & error.below(one) & gain.finite();
            gained = gained + Signal::choose(accepted, gain, nothing);
            passed = choose(accepted, choose(last, interval, passed + step), passed);
            let next = step * growth(error, P::ESTIMATE);
            // The end of the interval cuts a step short, which says nothing about the next ones.
            let next = choose(accepted & last, next.larger(self.step), next);
            self.step = choose(open, next, self.step);
        }
        let complete = sound & !passed.below(interval);
        // An abandoned interval says nothing about the next one either.
        self.step = choose(complete, self.step, U::Scalar::largest());
        Signal::choose(complete, gained, D::State::splat(U::Scalar::of(f64::NAN)))
    }
}
