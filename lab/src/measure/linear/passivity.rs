//! Colgate and Schenkel's condition: the worlds that are passive for any passive operator.

use std::f64::consts::PI;

use nalgebra::Complex;

use super::LinearPart;
use super::linear_part::VelocitySource;

/// Angles per wave of the fastest term.
const FINE: u64 = 16;

/// Ratio of neighbouring angles near 0, where a slow filter has its corner.
const RATIO: f64 = 1.15;

/// The angle that stands for the limit at 0, as a share of the fastest wave.
const LEAST: f64 = 1e-9;

/// Steps of the golden section: the place to ten digits, the value to all.
const SECTIONS: usize = 48;

/// A function that rises by no more than this share of itself is level: the rest is rounding.
const FLAT: f64 = 1e-13;

/// Newton's steps at most; a few are enough.
const STEPS: usize = 32;

/// Distance from a stiffness at which its slope is taken, as a share of it.
const NEARBY: f64 = 1e-5;

/// Share of an interval that one step of the golden section leaves.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

impl LinearPart {
    /// The damping that the device must have, N·s/m, for the port to be passive: then no passive operator, linear or
    /// not, can make the loop unstable. Infinite where no damping is enough.
    ///
    /// # One rate
    /// The world answers samples `T` apart by `H(z) = z^(−d) (K + (B + M (1 − z⁻¹) / T) F(z) (1 − z⁻¹) / T)`, `F` the
    /// low pass, and its force is held. The loop is passive if and only if
    ///
    /// ```text
    /// b > (T / 2) max over θ in (0, π] of Re[(1 − e^(−jθ)) H(e^(jθ))] / (1 − cos θ)
    /// ```
    ///
    /// (Colgate and Schenkel, Journal of Robotic Systems 14, 1997: linear damping `b`, exact samples, no quantization;
    /// a mass at the port adds nothing that is sure to brake.)
    ///
    /// # Two rates
    /// With an environment slower, by `r`, than the servo that estimates its velocities, samples at neither rate
    /// determine its force, and the theorem does not apply as printed. Its argument does. Between two samples of the
    /// servo the damper dissipates least where the motion is straight, `b Δx² / T`. So the port is passive if and only
    /// if, for all sequences of displacements `u(n)`, `Σ b u² / T + Σ f u ≥ 0`. Over a period of the environment all
    /// `f` are one answer, or, with delay, two: `f = e cᵀ u` with vectors of `r` entries that depend only on `θ`, the
    /// phase of a period. The Hermitian part of `e cᵀ` has two eigenvalues other than 0, and the lower one gives
    ///
    /// ```text
    /// b > T max over θ in (0, π] of (√(r ‖c‖² − Im²(cᵀe)) − Re(cᵀe)) / 2.
    /// ```
    ///
    /// With one rate the matrix is one number and the condition is the one above. With no damper and no mass in the
    /// world it is the one above with the environment's period for `T`.
    ///
    /// # The maximum
    /// The function is sampled at 16 angles per half wave of its fastest term, and at angles in proportion towards 0,
    /// where a filter's corner may be; the golden section then narrows down every maximum among the samples. The limit
    /// at 0 is one of the angles, in a form in which nothing cancels.
    ///
    /// # Exact velocity
    /// A sample of the plant's own velocity may take any value at no cost of energy, because it lasts no time: a world
    /// that uses it is passive with no device.
    pub fn passive_damping(&self) -> f64 {
        if self.needs_velocity() && self.velocity == VelocitySource::Exact {
            return f64::INFINITY;
        }
        self.needed(self.environment.stiffness)
    }

    /// The largest stiffness, N/m, at which the device's own damping is no less than
    /// [`passive_damping`](Self::passive_damping); 0 where no stiffness passes, NaN out of the range of the numbers.
    ///
    /// The needed damping is a convex function of the stiffness, so the stiffnesses that pass form one range.
    pub fn passive_max_stiffness(&self) -> f64 {
        if self.needs_velocity() && self.velocity == VelocitySource::Exact {
            return 0.0;
        }
        let damping = self.device.damping;
        let scale = (damping + self.environment.damping.abs()) / self.environment_period();
        let mut stiffness = if scale > 0.0 { scale } else { self.environment.mass };
        while stiffness > 0.0 && stiffness.is_finite() && self.needed(stiffness) <= damping {
            stiffness *= 2.0;
        }
        // A convex function from the side where it is too large: Newton's steps never overshoot the place, and if there
        // is none they leave the searched range.
        for _ in 0..STEPS {
            if stiffness <= 0.0 {
                return 0.0;
            }
            let (angle, needed) = self.worst(stiffness);
            let at = |stiffness: f64| World::of(self, stiffness).needed(angle);
            let nearby = NEARBY * stiffness;
            let slope = (at(stiffness + nearby) - at(stiffness - nearby)) / (2.0 * nearby);
            let step = (needed - damping) / slope;
            if slope <= 0.0 || !step.is_finite() {
                return if slope <= 0.0 { 0.0 } else { f64::NAN };
            }
            stiffness -= step;
            if step <= 2.0 * f64::EPSILON * stiffness {
                break;
            }
        }
        stiffness.max(0.0)
    }

    /// The damping needed at `stiffness`.
    fn needed(&self, stiffness: f64) -> f64 {
        self.worst(stiffness).1.max(0.0)
    }

    /// The angle at which the most damping is needed, and that damping.
    fn worst(&self, stiffness: f64) -> (f64, f64) {
        let world = World::of(self, stiffness);
        let angles = angles(world.late);
        let values: Vec<f64> = angles.iter().map(|angle| world.needed(*angle)).collect();
        let places = || angles.iter().copied().zip(values.iter().copied());
        let start = (angles[0], values[0]);
        let most = places().fold(start, |one, other| if other.1 > one.1 { other } else { one });
        let least = values.iter().copied().fold(most.1, f64::min);
        if most.1 - least <= FLAT * most.1.abs() {
            return most;
        }
        // Between two samples a maximum rises by less than this share of the whole range.
        let near = most.1 - 0.05 * (most.1 - least);
        let last = values.len() - 1;
        let is_top = |index: &usize| {
            let (before, after) = (values[index.saturating_sub(1)], values[last.min(index + 1)]);
            let value = values[*index];
            value >= near && value >= before && value >= after && value > before.min(after)
        };
        let narrow = |index: usize| {
            let around = [angles[index.saturating_sub(1)], angles[last.min(index + 1)]];
            narrowed(around, |angle| world.needed(angle))
        };
        let tops = (0..=last).filter(is_top).map(narrow);
        tops.fold(most, |one, other| if other.1 > one.1 { other } else { one })
    }
}

/// The angles to sample, rising, for a world whose answers are `late` periods late.
fn angles(late: u64) -> Vec<f64> {
    let count = FINE * (late + 4);
    let even = (1..=count).map(|index| PI * index as f64 / count as f64);
    let least = LEAST / (late + 1) as f64;
    let towards_zero = std::iter::successors(Some(least), |angle| Some(angle * RATIO));
    let mut angles: Vec<f64> = even.chain(towards_zero.take_while(|angle| *angle < PI)).collect();
    angles.sort_unstable_by(f64::total_cmp);
    angles
}

/// Place and value of a maximum between two places, by the golden section.
fn narrowed([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> (f64, f64) {
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let [mut left, mut right] = inner(low, high).map(|place| (place, of(place)));
    for _ in 0..SECTIONS {
        if left.1 >= right.1 {
            (high, right) = (right.0, left);
            let place = inner(low, high)[0];
            left = (place, of(place));
        } else {
            (low, left) = (left.0, right);
            let place = inner(low, high)[1];
            right = (place, of(place));
        }
    }
    if left.1 >= right.1 { left } else { right }
}

/// The world of a scene over one environment period, which is the unit of `z`.
#[derive(Clone, Copy, Debug)]
struct World {
    stiffness: f64,
    damping: f64,
    /// `M` over the environment's period, N·s/m.
    inertia: f64,
    period: f64,
    ratio: f64,
    /// Whole periods by which an answer is late, and servo ticks beyond.
    late: u64,
    ticks: f64,
    /// The low pass: its share, and `(1 − share)` to the powers `ratio`, `ratio − ticks`, `ticks` and `2 ratio`.
    share: f64,
    kept: [f64; 4],
}

impl World {
    fn of(part: &LinearPart, stiffness: f64) -> Self {
        let share = match part.velocity {
            VelocitySource::Exact => 1.0,
            VelocitySource::Difference { share } => share,
        };
        let (ratio, ticks) = (part.ratio as f64, (part.delay % part.ratio) as f64);
        let kept = [ratio, ratio - ticks, ticks, 2.0 * ratio].map(|power| match power {
            0.0 => 1.0,
            _ => libm::exp(power * libm::log1p(-share)),
        });
        Self {
            stiffness,
            damping: part.environment.damping,
            inertia: part.environment.mass / part.environment_period(),
            period: part.period,
            ratio,
            late: part.delay / part.ratio,
            ticks,
            share,
            kept,
        }
    }

    /// The damping needed against a motion of this phase per period.
    ///
    /// `cᵀ = κ 1ᵀ + gᵀ`, with `κ = K / (z − 1)` and `g` the part of the velocity; `cᵀ e = r κ + σ`. `κ` grows without
    /// bound towards 0 and is split: its real part is `−K / 2`, its imaginary part multiplies only terms that are as
    /// small.
    fn needed(&self, angle: f64) -> f64 {
        let Self { stiffness, ratio, late, ticks, share, period, .. } = *self;
        let back = Complex::new(libm::cos(angle), -libm::sin(angle));
        let one = Complex::from(1.0);
        // 1 − z⁻¹, with its digits where the angle is small.
        let half = libm::sin(0.5 * angle);
        let change = Complex::new(2.0 * half * half, libm::sin(angle));
        let [all, early, first, squared] = self.kept;
        let weight = (change * self.inertia + self.damping) / period * back / (one - back * all);
        let late_by =
            |periods: f64| Complex::new(libm::cos(periods * angle), -libm::sin(periods * angle));
        let (older, newer) = (late_by(late as f64 + 1.0), late_by(late as f64));
        let given = weight * (1.0 - all);
        let met = weight * (newer * (1.0 - early) + older * (early * (1.0 - first)));
        let sums = sums(late, angle);
        let sigma = met - (sums * ratio + older * ticks) * stiffness;
        if ratio == 1.0 {
            return period * (0.5 * stiffness - sigma.re);
        }
        let length = weight.norm_sqr() * share * (1.0 - squared) / (2.0 - share);
        let imaginary = -0.5 * stiffness / libm::tan(0.5 * angle);
        let square = (0.5 * ratio * stiffness).powi(2) - ratio * stiffness * given.re
            + 2.0 * ratio * imaginary * (given.im - sigma.im)
            - sigma.im * sigma.im
            + ratio * length;
        0.5 * period * (square.max(0.0).sqrt() + 0.5 * ratio * stiffness - sigma.re)
    }
}

/// `Σ z^(−i)`, `i` from 1 to `late`.
fn sums(late: u64, angle: f64) -> Complex<f64> {
    let (count, half) = (late as f64, libm::sin(0.5 * angle));
    let cosine = libm::sin(0.5 * count * angle) * libm::cos(0.5 * (count + 1.0) * angle) / half;
    let sine = libm::sin(0.5 * count * angle) * libm::sin(0.5 * (count + 1.0) * angle) / half;
    Complex::new(cosine, -sine)
}
