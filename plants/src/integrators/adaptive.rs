//! Steps by tolerance.

use lyapunov_core::{Dynamics, Integrator, Mask, ParameterError, Requirement, Scalar, Signal};

use crate::EmbeddedPair;

/// How many steps one interval may take, those that are tried again included.
const ATTEMPTS: u32 = 100_000;

/// How many units in the last place of one a tolerance has at least.
const ROUNDINGS: f64 = 8.0;

/// A method that covers an interval in steps of its own choice: as long as it can, and so short that what each is
/// estimated to err by is at most `tolerance + tolerance |y|` in every axis `y` of the state, in its own unit.
///
/// `|y|` is the larger magnitude of start and end of the step, positions counted from the rest. The error over many
/// steps is theirs together, grown or damped by the motion: the tolerance is no bound for it.
///
/// A step is followed by one `0.9 ε^(−1/p)` times as long, within a fifth and five times, where `ε` is the estimate over
/// what is allowed and `p` the power with which it falls (Hairer, Nørsett and Wanner, Solving Ordinary Differential
/// Equations I, 1993, II.4); the same is tried again where `ε ≥ 1`. The length is remembered from interval to interval,
/// and so the gain depends, within the tolerance, on the steps before. Each lane has its own, and moves by it as the
/// scalar run does, bit for bit; all axes of one have one together. The time of a step is not constant.
///
/// An interval that needs more than 100 000 attempts, as very stiff motion does, gains NaN, and so does one from what is
/// not finite: it always ends.
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

    /// How large `error` of a step from `from` is against what is allowed; not finite where the error is not.
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

/// How much longer the next step may be, after one with an error of `error` of what is allowed.
#[inline]
fn growth<T: Scalar>(error: T, power: u32) -> T {
    T::from_lanes(|lane| {
        let error = error.lane(lane);
        let ideal = 0.9 * libm::pow(error, -1.0 / f64::from(power));
        // NaN is neither and takes the shortest.
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
            // A step that all but reaches the end goes there.
            let last = !(self.step * U::Scalar::of(1.1)).below(left);
            let step = choose(open, choose(last, left, self.step), zero);
            let at = from + gained;
            let size = |gain, error| self.size(at, gain, error);
            let (gain, error) = self.pair.attempt(dynamics, at, input, step, size);
            let accepted = open & error.below(one) & gain.finite();
            gained = gained + Signal::choose(accepted, gain, nothing);
            passed = choose(accepted, choose(last, interval, passed + step), passed);
            let next = step * growth(error, P::ESTIMATE);
            // The end of the interval cuts steps short and says nothing of the next ones.
            let next = choose(accepted & last, next.larger(self.step), next);
            self.step = choose(open, next, self.step);
        }
        let complete = sound & !passed.below(interval);
        // What has been given up says nothing of the next interval either.
        self.step = choose(complete, self.step, U::Scalar::largest());
        Signal::choose(complete, gained, D::State::splat(U::Scalar::of(f64::NAN)))
    }
}
