//! Motion with a turning direction over a step as a polynomial, by Taylor's method.

use nalgebra::SVector;

use super::Stribeck;
use super::root::{ORDER, Polynomial};
use super::series::TAIL;
use crate::Impedance;

/// A mass in a plane or in space under a held effort, with friction against its velocity, in one lane.
pub(super) struct Planar<const N: usize> {
    pub(super) parts: Impedance<f64>,
    pub(super) effort: SVector<f64, N>,
    pub(super) law: Stribeck<f64>,
}

/// Motion over a step as polynomials of the share `τ` of it.
pub(super) struct Turning<const N: usize> {
    /// Length of the step, s.
    pub(super) step: f64,
    /// The share of the step up to which the polynomials hold.
    pub(super) share: f64,
    deflection: [Polynomial; N],
    velocity: [Polynomial; N],
    speed: Polynomial,
    friction: Polynomial,
}

/// The share of the time in which the acceleration would use up the speed that a step may take: a singularity of the
/// direction, where the device would stop, is at least twice as far.
const CAUTION: f64 = 0.5;

/// Speeds, as a share of the first, that a step may neither fall below nor be off by.
const SLOWEST: f64 = 0.2;
const APART: f64 = 1e-12;

impl<const N: usize> Planar<N> {
    /// The force besides friction on the device at rest, N.
    pub(super) fn force(&self, deflection: &SVector<f64, N>) -> SVector<f64, N> {
        -(deflection * self.parts.stiffness) - self.effort
    }

    /// The acceleration of a device that moves, m/s².
    pub(super) fn acceleration(
        &self,
        deflection: &SVector<f64, N>,
        velocity: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let speed = velocity.norm();
        let friction = velocity * (self.law.at(speed) / speed);
        (self.force(deflection) - velocity * self.parts.damping - friction) / self.parts.mass
    }

    /// The motion from a deflection and a velocity that is not 0, over `longest` s or less; none where it leaves the range
    /// of the numbers.
    pub(super) fn turn(
        &self,
        deflection: &SVector<f64, N>,
        velocity: &SVector<f64, N>,
        longest: f64,
    ) -> Option<Turning<N>> {
        let (speed, Impedance { mass, damping, stiffness }) = (velocity.norm(), self.parts);
        let change = self.acceleration(deflection, velocity).norm();
        let (is_constant, floor) = self.law.constant_above(speed);
        let varies = if is_constant { speed - floor } else { self.law.stribeck_velocity };
        let pace = libm::sqrt(stiffness / mass) + damping / mass;
        let step = longest.min(CAUTION * speed.min(varies) / change).min(1.0 / pace);
        let mut turning = Turning::standing(deflection, velocity, step);
        if !(step > 0.0 && turning.expand(self, !is_constant)) {
            return None;
        }
        turning.share = turning.converged();
        // The direction is singular where the device stops; before that the polynomials are checked against themselves.
        for _ in 0..64 {
            if turning.is_sound() {
                return Some(turning);
            }
            turning.share *= 0.5;
        }
        None
    }
}

impl<const N: usize> Turning<N> {
    fn standing(deflection: &SVector<f64, N>, velocity: &SVector<f64, N>, step: f64) -> Self {
        let none = [0.0; ORDER + 1];
        let at = |start: f64| {
            let mut polynomial = none;
            polynomial[0] = start;
            polynomial
        };
        Self {
            step,
            share: 1.0,
            deflection: core::array::from_fn(|axis| at(deflection[axis])),
            velocity: core::array::from_fn(|axis| at(velocity[axis])),
            speed: none,
            friction: none,
        }
    }

    /// Computes the coefficients, of friction that `varies` with the speed or is Coulomb's; false if they are not finite.
    ///
    /// With `w = v·v`, `s = √w`, `F = c + (f − c) exp(−w / v_s²)` and `g = F / s` each coefficient follows from the ones
    /// before by the rule of the product, of `s² = w` and of `g s = F`; then `m v' = −k x − b v − g v − effort`.
    fn expand(&mut self, system: &Planar<N>, varies: bool) -> bool {
        let (law, Impedance { mass, damping, stiffness }) = (system.law, system.parts);
        let none = [0.0; ORDER + 1];
        let (mut square, mut fall, mut ratio) = (none, none, none);
        let spread = if varies { law.breakaway - law.coulomb } else { 0.0 };
        let scale = law.stribeck_velocity * law.stribeck_velocity;
        for k in 0..ORDER {
            square[k] = self.velocity.iter().map(|axis| product(axis, axis, 0..=k, k)).sum();
            self.speed[k] = match k {
                0 => libm::sqrt(square[0]),
                _ => {
                    let known = product(&self.speed, &self.speed, 1..=k - 1, k);
                    (square[k] - known) / (2.0 * self.speed[0])
                }
            };
            fall[k] = match k {
                0 => libm::exp(-square[0] / scale),
                _ => {
                    let terms = (1..=k).map(|j| j as f64 * square[j] * fall[k - j]);
                    -terms.sum::<f64>() / (scale * k as f64)
                }
            };
            // Where Coulomb's friction alone counts, the rest is below rounding.
            let rest = if spread > 0.0 { spread * fall[k] } else { 0.0 };
            self.friction[k] = if k == 0 { law.coulomb + rest } else { rest };
            let known = product(&self.speed, &ratio, 1..=k, k);
            ratio[k] = (self.friction[k] - known) / self.speed[0];
            let share = self.step / (k + 1) as f64;
            for axis in 0..N {
                let rubbed = product(&ratio, &self.velocity[axis], 0..=k, k);
                let effort = if k == 0 { system.effort[axis] } else { 0.0 };
                let pulled =
                    stiffness * self.deflection[axis][k] + damping * self.velocity[axis][k];
                self.velocity[axis][k + 1] = -share * (pulled + rubbed + effort) / mass;
                self.deflection[axis][k + 1] = share * self.velocity[axis][k];
            }
        }
        let all = self.velocity.iter().chain(&self.deflection);
        all.flatten().all(|coefficient| coefficient.is_finite())
    }

    /// The share of the step within which the last two terms of the velocity are below rounding.
    fn converged(&self) -> f64 {
        let mut share = 1.0_f64;
        for k in [ORDER - 1, ORDER] {
            let last = self.velocity.iter().fold(0.0_f64, |most, axis| most.max(axis[k].abs()));
            if last > 0.0 {
                share = share.min(libm::pow(TAIL * self.speed[0] / last, 1.0 / k as f64));
            }
        }
        share
    }

    /// Whether the speed is the length of the velocity up to the share, and far from 0.
    fn is_sound(&self) -> bool {
        [0.5, 1.0].into_iter().all(|part| {
            let at = part * self.share;
            let told = value(&self.speed, ORDER - 1, at);
            let length = self.velocity(at).norm();
            told > SLOWEST * self.speed[0] && (told - length).abs() <= APART * self.speed[0]
        })
    }

    /// The change of the deflection up to the end of the share, m.
    pub(super) fn gain(&self) -> SVector<f64, N> {
        SVector::from_fn(|axis, _| {
            let mut change = self.deflection[axis];
            change[0] = 0.0;
            value(&change, ORDER, self.share)
        })
    }

    /// The velocity at a share of the step.
    pub(super) fn velocity(&self, share: f64) -> SVector<f64, N> {
        SVector::from_fn(|axis, _| value(&self.velocity[axis], ORDER, share))
    }

    /// The energy that friction dissipates up to the end of the share, `∫ F s dt`, J.
    pub(super) fn heat(&self) -> f64 {
        let mut heat = [0.0; ORDER + 1];
        for k in 0..ORDER {
            let power = product(&self.friction, &self.speed, 0..=k, k);
            heat[k + 1] = self.step * power / (k + 1) as f64;
        }
        value(&heat, ORDER, self.share)
    }
}

/// The sum of `a_j b_(k − j)` over `terms`.
fn product(
    a: &Polynomial,
    b: &Polynomial,
    terms: core::ops::RangeInclusive<usize>,
    k: usize,
) -> f64 {
    terms.map(|j| a[j] * b[k - j]).sum()
}

/// The value of the first coefficients of a polynomial, up to `last`.
fn value(polynomial: &Polynomial, last: usize, at: f64) -> f64 {
    polynomial[..=last].iter().rev().fold(0.0, |sum, coefficient| sum * at + coefficient)
}
