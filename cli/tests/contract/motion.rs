//! Exact motion of m x'' + b x' + k y = -f over one period of constant f, with y = x - rest.
//!
//! Everything follows from the impulse response h (h(0) = 0, h'(0) = 1), its derivative and its integral. Their Taylor
//! series are summed in double-double, so that one form serves every damping, k = 0 and short periods alike: the closed
//! forms in f64 cancel near critical damping and in 1 - A11.

use std::ops::{Add, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug)]
struct Double {
    high: f64,
    low: f64,
}

impl Double {
    fn of(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    fn over(self, divisor: f64) -> Self {
        let high = self.high / divisor;
        let rest = (-high).mul_add(divisor, self.high) + self.low;
        Self::normalized(high, rest / divisor)
    }

    fn value(self) -> f64 {
        self.high + self.low
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = self.high + other.high;
        let back = high - self.high;
        let error = (self.high - (high - back)) + (other.high - back);
        Self::normalized(high, error + self.low + other.low)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        Self::normalized(high, error + self.high * other.low + self.low * other.high)
    }
}

/// Coefficients of one period: x(n+1) = x + position_y y + position_v v - position_f f, v(n+1) = v + velocity_y y +
/// velocity_v v - velocity_f f, and the same without v: dx(n+1) = decay dx(n) - pull y(n) - now f(n) - before f(n-1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion {
    pub(crate) position_y: f64,
    pub(crate) position_v: f64,
    pub(crate) position_f: f64,
    pub(crate) velocity_y: f64,
    pub(crate) velocity_v: f64,
    pub(crate) velocity_f: f64,
    pub(crate) decay: f64,
    pub(crate) pull: f64,
    pub(crate) now: f64,
    pub(crate) before: f64,
}

impl Motion {
    pub(crate) fn new(mass: f64, damping: f64, stiffness: f64, period: f64) -> Self {
        let friction = Double::of(damping).over(mass);
        let spring = Double::of(stiffness).over(mass);
        let (h, slope, area) = impulse_response(friction, spring, Double::of(period));

        let one = Double::of(1.0);
        let a11 = one - spring * area;
        let a21 = -(spring * h);
        let decay = a11 * slope - h * a21;
        Self {
            position_y: (-(spring * area)).value(),
            position_v: h.value(),
            position_f: area.over(mass).value(),
            velocity_y: a21.value(),
            velocity_v: (slope - one).value(),
            velocity_f: h.over(mass).value(),
            decay: decay.value(),
            pull: (one - a11 - slope + decay).value(),
            now: area.over(mass).value(),
            before: (h * h - slope * area).over(mass).value(),
        }
    }
}

fn impulse_response(friction: Double, spring: Double, period: Double) -> (Double, Double, Double) {
    let size = friction.high * period.high + spring.high * period.high * period.high;
    assert!(size < 18.0, "the series would cancel: {size} is too far for one period");

    let zero = Double::of(0.0);
    let (mut last, mut term) = (zero, period);
    let (mut h, mut slope, mut area) = (zero, zero, zero);
    for order in 1..=120 {
        let j = f64::from(order);
        h = h + term;
        slope = slope + term * Double::of(j);
        area = area + term.over(j + 1.0);
        let next = friction * period * term * Double::of(j) + spring * period * period * last;
        (last, term) = (term, (-next).over((j + 1.0) * j));
    }
    (h, slope.over(period.high), area * period)
}

/// Tests against the textbook solution in f64, which is coarser than the series and shares nothing with it.
#[cfg(test)]
mod tests {
    use approx::{abs_diff_eq, assert_abs_diff_eq};

    use super::Motion;

    fn textbook(mass: f64, damping: f64, stiffness: f64, t: f64) -> (f64, f64, f64) {
        let half = damping / (2.0 * mass);
        let square = half * half - stiffness / mass;
        let envelope = (-half * t).exp();
        let (c, s) = if square == 0.0 {
            (1.0, t)
        } else if square > 0.0 {
            let w = square.sqrt();
            ((w * t).cosh(), (w * t).sinh() / w)
        } else {
            let w = (-square).sqrt();
            ((w * t).cos(), (w * t).sin() / w)
        };
        let (h, slope) = (envelope * s, envelope * (c - half * s));
        let area = if stiffness > 0.0 {
            (1.0 - envelope * (c + half * s)) / (stiffness / mass)
        } else if damping > 0.0 {
            let rate = damping / mass;
            (t + (-rate * t).exp_m1() / rate) / rate
        } else {
            t * t / 2.0
        };
        (h, slope, area)
    }

    #[test]
    fn series_equals_textbook_solution() {
        for (mass, damping, stiffness) in [
            (0.3, 0.201, 50.0),
            (0.3, 0.0, 50.0),
            (0.3, 0.0, 0.0),
            (0.3, 1.5, 0.0),
            (0.25, 4.0, 16.0),
            (0.25, 9.0, 16.0),
            (0.05, 40.0, 1500.0),
        ] {
            for period in [1e-4, 1e-3, 0.01] {
                let map = Motion::new(mass, damping, stiffness, period);
                let (h, slope, area) = textbook(mass, damping, stiffness, period);
                let spring = stiffness / mass;
                let near = |got: f64, want: f64, terms: f64| {
                    assert!(
                        abs_diff_eq!(got, want, epsilon = 8.0 * f64::EPSILON * terms),
                        "{got:e} is not {want:e} for {mass} {damping} {stiffness} {period}"
                    );
                };
                near(map.position_v, h, h);
                near(1.0 + map.velocity_v, slope, 1.0);
                near(map.velocity_f, h / mass, h / mass);
                near(map.velocity_y, -spring * h, spring * h);
                near(map.decay, (-damping / mass * period).exp(), 1.0);
                let cancelled = if spring > 0.0 {
                    1.0 / spring
                } else if damping > 0.0 {
                    period * mass / damping
                } else {
                    area
                };
                near(map.position_f, area / mass, cancelled / mass);
                near(map.position_y, -spring * area, 1.0);
            }
        }
    }

    /// Sums of positive numbers only: exact to rounding in f64 even for a period that the textbook form cannot resolve.
    #[test]
    fn short_periods_keep_every_digit() {
        let period = 1e-6;
        let map = Motion::new(2.0, 0.0, 0.0, period);
        assert_eq!(map.position_f, period * period / 4.0);
        assert_eq!(map.before, period * period / 4.0);
        assert_eq!(map.decay, 1.0);
        assert_eq!(map.pull, 0.0);

        let spring = 50.0 / 0.3 * period * period;
        let map = Motion::new(0.3, 0.0, 50.0, period);
        let want = spring * (1.0 - spring / 12.0);
        assert_abs_diff_eq!(map.pull, want, epsilon = 4.0 * f64::EPSILON * want);
    }

    #[test]
    fn two_half_periods_make_one() {
        let (whole, half) =
            (Motion::new(0.3, 1.7, 400.0, 0.02), Motion::new(0.3, 1.7, 400.0, 0.01));
        let step = |map: &Motion, (y, v): (f64, f64), f: f64| {
            (
                y + map.position_y * y + map.position_v * v - map.position_f * f,
                v + map.velocity_y * y + map.velocity_v * v - map.velocity_f * f,
            )
        };
        let start = (-0.004, 0.3);
        let (y, v) = step(&whole, start, 2.5);
        let (y2, v2) = step(&half, step(&half, start, 2.5), 2.5);
        assert!(abs_diff_eq!(y, y2, epsilon = 1e-17) && abs_diff_eq!(v, v2, epsilon = 1e-15));
    }
}
