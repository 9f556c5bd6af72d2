//! Motion over a step as a polynomial, by Taylor's method.

use lyapunov_core::lanes::{apart, together};
use lyapunov_core::{Mask, Scalar};

use super::Stribeck;
use super::exponential::{Exponential, product};
use super::root::{ORDER, Polynomial};

/// A linear body under a held effort, with friction on its device, each lane by itself.
pub(super) struct System<T, const S: usize> {
    /// By row.
    pub(super) rate: [[T; S]; S],
    pub(super) mass: T,
    pub(super) effort: T,
    pub(super) law: Stribeck<T>,
}

/// State and friction over a step as polynomials of the share `τ` of it.
pub(super) struct Series<T, const S: usize> {
    /// Length of the step, s.
    pub(super) step: T,
    pub(super) state: [Polynomial<T>; S],
    /// Magnitude of the friction, N.
    pub(super) friction: Polynomial<T>,
    /// Power series of its fall with the velocity.
    fall: Exponential<T>,
}

/// The most that the last terms may amount to, as a share of the whole: half a rounding.
pub(super) const TAIL: f64 = f64::EPSILON / 8.0;

/// The steps to try, each shorter, before a motion counts as out of range.
const TRIES: usize = 8;

impl<T: Scalar, const S: usize> System<T, S> {
    /// The force on the device at rest besides friction, N.
    #[inline(always)]
    pub(super) fn force(&self, state: &[T; S]) -> T {
        self.force_of(|index| state[index]) - self.effort
    }

    /// The part of it that depends on the state, for any coefficient.
    #[inline(always)]
    fn force_of(&self, state: impl Fn(usize) -> T) -> T {
        self.mass * self.derivative(S - 1, state)
    }

    #[inline(always)]
    fn derivative(&self, row: usize, state: impl Fn(usize) -> T) -> T {
        let row = &self.rate[row];
        let mut sum = row[0] * state(0);
        for (index, &rate) in row.iter().enumerate().skip(1) {
            sum += rate * state(index);
        }
        sum
    }

    /// The rate at which the motion changes, rad/s: at least that of its fastest mode, the device held or not.
    #[inline(always)]
    fn pace(&self, device: bool) -> T {
        let masses = if device { S / 2 } else { S / 2 - 1 };
        let zero = T::zero();
        let mut most = zero;
        for mass in 0..masses {
            let row = &self.rate[2 * mass + 1];
            let (mut springs, mut dampers) = (zero, zero);
            for other in 0..masses {
                springs += row[2 * other].magnitude();
                dampers += row[2 * other + 1].magnitude();
            }
            most = (springs.sqrt() + dampers).larger(most);
        }
        most
    }

    /// The force besides friction on a device that stands still.
    #[inline(always)]
    pub(super) fn force_series(&self, series: &Series<T, S>) -> Polynomial<T> {
        let mut force = [T::zero(); ORDER + 1];
        for (k, coefficient) in force.iter_mut().enumerate() {
            apart::<T>();
            *coefficient = self.force_of(|index| series.state[index][k]);
        }
        force[0] -= self.effort;
        force
    }

    /// Expands `series` from `state` over a step of `longest` s or less in which they converge, in those lanes `of` in which
    /// such a step is found; returns these lanes. The device slides in the direction `sense`, ±1, or stands still where that is
    /// 0.
    #[inline(always)]
    pub(super) fn expand(
        &self,
        series: &mut Series<T, S>,
        state: &[T; S],
        sense: T,
        longest: T,
        of: T::Mask,
    ) -> T::Mask {
        let sliding = sense.magnitude().above(T::zero());
        let zero = T::zero();
        let loose = if sliding.any() { self.pace(true) } else { zero };
        let held = if sliding.all() { zero } else { self.pace(false) };
        series.step = longest.smaller(T::of(1.75) / T::choose(sliding, loose, held));
        let mut tries = 1;
        loop {
            for (index, &value) in state.iter().enumerate() {
                series.state[index][0] = value;
            }
            let step = series.step;
            self.coefficients(series, sense, sliding);
            let found = series.settle(self.law.breakaway, of);
            if tries == TRIES || (found | !of).all() {
                return found;
            }
            // Out of range. A shorter step makes the high coefficients far smaller; the other lanes do the same again.
            series.step = T::choose(found, step, step * T::of(1.0 / 4096.0));
            tries += 1;
        }
    }

    /// Computes the coefficients after the first.
    #[inline(always)]
    fn coefficients(&self, series: &mut Series<T, S>, sense: T, sliding: T::Mask) {
        let zero = T::zero();
        let speed = series.state[S - 1][0].magnitude();
        let (constant, _) = self.law.constant_above(speed);
        let (varying, at_rest) = (sliding & !constant, !speed.above(zero));
        for k in 0..ORDER {
            let share = series.step / T::of((k + 1) as f64);
            let (coulomb, effort) =
                if k == 0 { (self.law.coulomb, self.effort) } else { (zero, zero) };
            let last = if sliding.any() {
                let mut friction = T::choose(sliding, coulomb, zero);
                if varying.any() {
                    let (law, fall, speed) = (&self.law, &mut series.fall, series.state[S - 1][k]);
                    let falling = if k == 0 {
                        fall.first(law, speed)
                    } else {
                        fall.coefficient(law, speed, k)
                    };
                    friction = T::choose(varying, falling, friction);
                }
                series.friction[k] = friction;
                let force = self.force_of(|index| series.state[index][k]) - effort;
                let gain = (force - sense * friction) / self.mass;
                // A motion from rest does not start backwards, not even by a rounding.
                let forwards = sense * (sense * gain).larger(zero);
                let is_start = at_rest & T::Mask::of(k == 0);
                T::choose(sliding, T::choose(is_start, forwards, gain), zero)
            } else {
                series.friction[k] = zero;
                zero
            };
            for row in 0..S - 1 {
                apart::<T>();
                let gain = self.derivative(row, |index| series.state[index][k]);
                series.state[row][k + 1] = share * gain;
            }
            series.state[S - 1][k + 1] = share * last;
        }
    }
}

impl<T: Scalar, const S: usize> Series<T, S> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = T::zero();
        Self {
            step: zero,
            state: [[zero; ORDER + 1]; S],
            friction: [zero; ORDER + 1],
            fall: Exponential::none(),
        }
    }

    /// Halves the step, which is exact, until the series have converged at its end; the lanes `of` where they have, which
    /// are those where they are finite.
    #[inline(always)]
    fn settle(&mut self, friction: T, of: T::Mask) -> T::Mask {
        let mut finite = of;
        for polynomial in self.state.iter().chain([&self.friction]) {
            for coefficient in polynomial {
                apart::<T>();
                finite = finite & coefficient.finite();
            }
        }
        for _ in 0..1100 {
            let open = together::<T, _>(finite & !self.converged(friction));
            if !open.any() {
                return finite;
            }
            let half = T::of(0.5);
            self.step = T::choose(open, self.step * half, self.step);
            for polynomial in self.state.iter_mut().chain([&mut self.friction]) {
                let mut share = T::one();
                for coefficient in polynomial.iter_mut() {
                    apart::<T>();
                    *coefficient = T::choose(open, *coefficient * share, *coefficient);
                    share *= half;
                }
            }
        }
        finite & self.converged(friction)
    }

    #[inline(always)]
    fn converged(&self, friction: T) -> T::Mask {
        let enough = T::of(TAIL) * friction;
        let mut all = T::Mask::of(true);
        for coefficient in &self.friction[ORDER - 2..] {
            all = all & !coefficient.magnitude().above(enough);
        }
        for first in 0..2 {
            let (last, largest) = (self.largest(ORDER - 1, first), self.largest(1, first));
            all = all & !last.above(T::of(TAIL) * largest);
        }
        all
    }

    /// The largest coefficient from `from` on of every other entry of the state, beginning with `first`.
    #[inline(always)]
    fn largest(&self, from: usize, first: usize) -> T {
        let mut most = T::zero();
        for mass in 0..S / 2 {
            for coefficient in &self.state[2 * mass + first][from..] {
                apart::<T>();
                most = coefficient.magnitude().larger(most);
            }
        }
        together::<T, _>(most)
    }

    /// The gain of state `index` until `share`.
    #[inline(always)]
    pub(super) fn gain(&self, index: usize, share: T) -> T {
        let mut sum = T::zero();
        for &coefficient in self.state[index][1..].iter().rev() {
            apart::<T>();
            sum = (sum + coefficient) * share;
        }
        sum
    }

    /// The energy that friction dissipates until `share`, J.
    #[inline(always)]
    pub(super) fn heat(&self, share: T) -> T {
        let zero = T::zero();
        let mut varies = T::Mask::of(false);
        for coefficient in &self.friction[1..] {
            apart::<T>();
            varies = varies | coefficient.magnitude().above(zero);
        }
        let constant = self.friction[0] * self.gain(S - 2, share).magnitude();
        if !varies.any() {
            return constant;
        }
        let velocity = &self.state[S - 1];
        let mut sum = zero;
        for k in (0..ORDER + 1).rev() {
            sum = (sum + product(&self.friction, velocity, 0, k) / T::of((k + 1) as f64)) * share;
        }
        T::choose(varies, (sum * self.step).magnitude(), constant)
    }
}
