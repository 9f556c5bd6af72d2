//! Motion over a step as a polynomial, by Taylor's method.

use nalgebra::SMatrix;

use super::Stribeck;
use super::root::{ORDER, Polynomial};

/// A linear body under a held effort, with friction on its device, in one lane.
pub(super) struct System<const S: usize> {
    pub(super) rate: SMatrix<f64, S, S>,
    pub(super) mass: f64,
    pub(super) effort: f64,
    pub(super) law: Stribeck<f64>,
}

/// State and friction over a step as polynomials of the share `τ` of it.
pub(super) struct Series<const S: usize> {
    /// Length of the step, s.
    pub(super) step: f64,
    pub(super) state: [Polynomial; S],
    /// Magnitude of the friction, N.
    pub(super) friction: Polynomial,
}

/// The most that the last terms may amount to, as a share of the largest: half a rounding.
const TAIL: f64 = f64::EPSILON / 8.0;

impl<const S: usize> System<S> {
    /// The force on the device at rest besides friction, N.
    pub(super) fn force(&self, state: &[f64; S]) -> f64 {
        self.force_of(|index| state[index]) - self.effort
    }

    /// The part of it that depends on the state, for any coefficient.
    fn force_of(&self, state: impl Fn(usize) -> f64) -> f64 {
        self.mass * self.derivative(S - 1, state)
    }

    fn derivative(&self, row: usize, state: impl Fn(usize) -> f64) -> f64 {
        (0..S).map(|index| self.rate[(row, index)] * state(index)).sum()
    }

    /// The rate at which the motion changes, rad/s: at least that of its fastest mode, the device held or not.
    fn pace(&self, device: bool) -> f64 {
        let rows = if device { S } else { S - 2 };
        let row = |row: usize| {
            let sum = |first: usize| {
                (first..rows).step_by(2).map(|i| self.rate[(row, i)].abs()).sum::<f64>()
            };
            libm::sqrt(sum(0)) + sum(1)
        };
        (1..rows).step_by(2).map(row).fold(0.0, f64::max)
    }

    /// The series while the device slides in the direction `sense`, ±1, for `longest` s or less.
    pub(super) fn slide(&self, state: &[f64; S], sense: f64, longest: f64) -> Option<Series<S>> {
        let speed = state[S - 1].abs();
        let varying = self.law.constant_above(speed).is_none();
        self.series(state, self.pace(true), longest, |series, k, law| {
            series.friction[k] = match (varying, k) {
                (true, _) => law.coefficient(&self.law, &series.state[S - 1], k),
                (false, 0) => self.law.coulomb,
                (false, _) => 0.0,
            };
            let applied = if k == 0 { self.effort } else { 0.0 };
            let force = self.force_of(|index| series.state[index][k]) - applied;
            let gain = (force - sense * series.friction[k]) / self.mass;
            // A motion from rest does not start backwards, not even by a rounding.
            if k == 0 && speed == 0.0 { sense * (sense * gain).max(0.0) } else { gain }
        })
    }

    /// The series while the device stands still for `longest` s or less and the rest of the body moves.
    pub(super) fn stick(&self, state: &[f64; S], longest: f64) -> Option<Series<S>> {
        self.series(state, self.pace(false), longest, |_, _, _| 0.0)
    }

    /// The force besides friction on a device that stands still.
    pub(super) fn force_series(&self, series: &Series<S>) -> Polynomial {
        core::array::from_fn(|k| {
            let applied = if k == 0 { self.effort } else { 0.0 };
            self.force_of(|index| series.state[index][k]) - applied
        })
    }

    /// The series from `state` over a step in which they converge, or none if no such step is found; `device` is the
    /// device's acceleration, coefficient by coefficient.
    fn series(
        &self,
        state: &[f64; S],
        pace: f64,
        longest: f64,
        device: impl Fn(&mut Series<S>, usize, &mut Exponential) -> f64,
    ) -> Option<Series<S>> {
        let mut step = longest.min(1.75 / pace);
        for _ in 0..8 {
            let mut series = Series::standing(state, step);
            let mut law = Exponential::default();
            for k in 0..ORDER {
                let last = device(&mut series, k, &mut law);
                let share = step / (k + 1) as f64;
                for row in 0..S - 1 {
                    let gain = self.derivative(row, |index| series.state[index][k]);
                    series.state[row][k + 1] = share * gain;
                }
                series.state[S - 1][k + 1] = share * last;
            }
            if series.settle(self.law.breakaway) {
                return Some(series);
            }
            // Out of range. A shorter step makes the high coefficients far smaller.
            step *= 1.0 / 4096.0;
        }
        None
    }
}

impl<const S: usize> Series<S> {
    fn standing(state: &[f64; S], step: f64) -> Self {
        let mut series = Self { step, state: [[0.0; ORDER + 1]; S], friction: [0.0; ORDER + 1] };
        for (polynomial, &value) in series.state.iter_mut().zip(state) {
            polynomial[0] = value;
        }
        series
    }

    /// Halves the step, which is exact, until the series have converged at its end; false if they are not finite.
    fn settle(&mut self, friction: f64) -> bool {
        let finite = |polynomial: &Polynomial| polynomial.iter().all(|c| c.is_finite());
        if !self.state.iter().all(finite) || !finite(&self.friction) {
            return false;
        }
        for _ in 0..1100 {
            if self.converged(friction) {
                return true;
            }
            self.step *= 0.5;
            for polynomial in self.state.iter_mut().chain([&mut self.friction]) {
                let mut share = 1.0;
                for coefficient in polynomial.iter_mut() {
                    *coefficient *= share;
                    share *= 0.5;
                }
            }
        }
        false
    }

    fn converged(&self, friction: f64) -> bool {
        let most = |from: usize, state: usize| {
            let largest =
                |c: &Polynomial| c[from..].iter().fold(0.0, |most: f64, c| most.max(c.abs()));
            self.state.iter().skip(state).step_by(2).map(largest).fold(0.0, f64::max)
        };
        let tail = |state| most(ORDER - 1, state) <= TAIL * most(1, state);
        let rest = self.friction[ORDER - 2..].iter().all(|c| c.abs() <= TAIL * friction);
        tail(0) && tail(1) && rest
    }

    /// The gain of state `index` until `share`.
    pub(super) fn gain(&self, index: usize, share: f64) -> f64 {
        self.state[index][1..].iter().rev().fold(0.0, |sum, c| (sum + c) * share)
    }

    /// The energy that friction dissipates until `share`, J.
    pub(super) fn heat(&self, share: f64) -> f64 {
        if self.friction[1..].iter().all(|&c| c == 0.0) {
            return self.friction[0] * self.gain(S - 2, share).abs();
        }
        let velocity = &self.state[S - 1];
        let power = |k: usize| -> f64 { (0..=k).map(|j| self.friction[j] * velocity[k - j]).sum() };
        let sum = (0..=ORDER).rev().fold(0.0, |sum, k| (sum + power(k) / (k + 1) as f64) * share);
        (sum * self.step).abs()
    }
}

/// The power series of `q = exp(−y²)`, from `k q_k = Σ j g_j q_(k−j)` for `q = exp g` (Knuth, The Art of Computer
/// Programming, volume 2, section 4.7).
#[derive(Default)]
struct Exponential {
    exponent: Polynomial,
    value: Polynomial,
}

impl Exponential {
    /// Coefficient `k` of the friction; the earlier ones must have been computed.
    fn coefficient(&mut self, law: &Stribeck<f64>, velocity: &Polynomial, k: usize) -> f64 {
        let ratio = |k: usize| velocity[k] / law.stribeck_velocity;
        self.exponent[k] = -(0..=k).map(|j| ratio(j) * ratio(k - j)).sum::<f64>();
        let spread = law.breakaway - law.coulomb;
        if k == 0 {
            self.value[0] = libm::exp(self.exponent[0]);
            return law.coulomb + spread * self.value[0];
        }
        let sum: f64 = (1..=k).map(|j| j as f64 * self.exponent[j] * self.value[k - j]).sum();
        self.value[k] = sum / k as f64;
        spread * self.value[k]
    }
}
