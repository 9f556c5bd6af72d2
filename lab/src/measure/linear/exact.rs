//! Exact stiffness limit: the stiffness at which the loop's own map begins to grow.

use std::ops::{Add, Div, Mul, Sub};

use nalgebra::Complex;

use super::LinearPart;
use super::loop_map::LoopMap;
use super::polynomial::Polynomial;
use super::roots::settle;
use lyapunov::accumulators::DoubleDouble;

/// A crossing below this share of `m / T²` is one at 0, off by rounding.
const NOTHING: f64 = 1e-24;

/// A root whose imaginary part is below this share of it may be real: where two roots meet, half of the digits are
/// lost.
const NEARLY_REAL: f64 = 1e-4;

/// Steps that give a crossing the rest of its digits.
const STEPS: usize = 8;

impl LinearPart {
    /// The spectral radius of the closed loop's map over one period of the environment, at its own stiffness.
    ///
    /// Below 1 every motion decays, above 1 nearly every one grows. A part that nothing pulls back can rest anywhere:
    /// with no stiffness at all the radius is 1. NaN where the loop is out of the range of the numbers.
    pub fn spectral_radius(&self) -> f64 {
        let map = LoopMap::of(self);
        let growth = map.growth(self.environment.stiffness / map.unit);
        1.0 + growth / (1.0 + (1.0 + growth).sqrt())
    }

    /// The stiffnesses, N/m, between which the loop is stable, the lowest such range: every stiffness inside has a
    /// spectral radius below 1, and the ends do not belong to it. None if no stiffness from 0 on has.
    ///
    /// The characteristic polynomial is affine in the stiffness, `P(z) = p(z) + K q(z)`, so that a root is on the unit
    /// circle only where `−p / q` is real there. With `Y = tan²(θ / 2)`, `z = e^(jθ)`, this is a polynomial equation in
    /// `Y`: all its roots are found, and each gives the one stiffness of its crossing, to all digits. Between
    /// neighbours nothing crosses, so the radius at one stiffness decides for all. A crossing below 10⁻²⁴ m/T² counts
    /// as 0.
    pub fn stable_stiffness(&self) -> Option<[f64; 2]> {
        let map = LoopMap::of(self);
        let mut edges = Crossings::of(&map).stiffnesses();
        edges.push(0.0);
        edges.sort_unstable_by(f64::total_cmp);
        let stable = |index: usize| {
            let (low, high) = (edges[index], edges.get(index + 1));
            let inside = match high {
                Some(high) => 0.5 * (low + high),
                None => 2.0 * low + 1.0,
            };
            map.growth(inside) < 0.0
        };
        let first = (0..edges.len()).find(|index| stable(*index))?;
        // Where two roots only touch the circle the range continues.
        let last = (first + 1..edges.len()).find(|index| !stable(*index));
        let end = last.map_or(f64::INFINITY, |index| edges[index]);
        Some([edges[first] * map.unit, end * map.unit])
    }
}

/// Stiffnesses at which roots of `(1 + w)^D a + r + κ k` are on the unit circle.
///
/// With `z = (1 + s) / (1 − s)` the circle is `s = j tan(θ / 2)`. With `U(s) = a(s) k(−s)`, `V(s) = r(s) k(−s)` and
/// `Q(s) = k(s) k(−s)`, `z^D U + V + κ Q = 0`. Its even and odd parts in `s`, with `e` and `o` for those of `U` and
/// `V`, are real equations in `Y = −s²`:
///
/// ```text
/// κ Q + C e_U − Y S o_U + e_V = 0,        C o_U + S e_U + o_V = 0,
/// C = cos(D θ),    S = sin(D θ) / tan(θ / 2).
/// ```
struct Crossings<'a> {
    map: &'a LoopMap,
    plant: [Polynomial; 2],
    rest: [Polynomial; 2],
    square: Polynomial,
}

impl<'a> Crossings<'a> {
    fn of(map: &'a LoopMap) -> Self {
        let n = [&map.plant, &map.rest, &map.stiffness].map(Polynomial::degree);
        let n = n.into_iter().fold(0, usize::max);
        let answer = map.stiffness.turned(n);
        let mirrored = answer.mirrored();
        let parts = |it: &Polynomial| it.turned(n).times(&mirrored).parts();
        let [square, _] = answer.times(&mirrored).parts();
        Self { map, plant: parts(&map.plant), rest: parts(&map.rest), square }
    }

    /// All stiffnesses above 0 at which a root is on the unit circle, and perhaps some at which one is only near.
    fn stiffnesses(&self) -> Vec<f64> {
        let mut places = self.starts();
        settle(&mut places, |place| self.step(place));
        let real = places.into_iter().filter(|it| it.im.abs() <= NEARLY_REAL * it.re);
        let inside = real.map(|it| self.stiffness(self.polished(it.re)));
        let ends = [0.0, -2.0].map(|w| {
            // At z = 1 and z = −1 everything is real.
            let turn = if self.map.delay % 2 == 1 && w != 0.0 { -1.0 } else { 1.0 };
            let value = |it: &Polynomial| it.value(DoubleDouble::from(w));
            let others = value(&self.map.plant) * DoubleDouble::from(turn) + value(&self.map.rest);
            f64::from(-others / value(&self.map.stiffness))
        });
        let all = inside.chain(ends);
        all.filter(|kappa| *kappa > NOTHING && kappa.is_finite()).collect()
    }

    /// One start for each root, near the axis on which the roots are sought.
    fn starts(&self) -> Vec<Complex<f64>> {
        let [even, odd] = self.plant.each_ref().map(Polynomial::degree);
        let degree = odd.max(even.saturating_sub(1)).max(self.rest[1].degree());
        let count = degree + self.map.delay as usize;
        let place = |index: usize| {
            let half = std::f64::consts::FRAC_PI_2 * (index as f64 + 0.5) / count as f64;
            let tangent = libm::tan(half);
            let sign = if index.is_multiple_of(2) { 0.2 } else { -0.2 };
            Complex::new(tangent * tangent, sign * tangent * tangent)
        };
        (0..count).map(place).collect()
    }

    /// The value divided by the derivative of `(1 + Y)^D (C o_U + S e_U + o_V)`.
    fn step(&self, place: Complex<f64>) -> Complex<f64> {
        let [value, slope] = self.balance(place);
        let late = Complex::from(f64::from(self.map.delay));
        (slope / value + late / (Complex::from(1.0) + place)).inv()
    }

    /// `C o_U + S e_U + o_V`, and its derivative.
    fn balance(&self, place: Complex<f64>) -> [Complex<f64>; 2] {
        let one = Complex::from(1.0);
        let late = Complex::from(f64::from(self.map.delay));
        let [cosine, sine] = turns(self.map.delay, place);
        let ([even, even_slope], [odd, odd_slope]) =
            (self.plant[0].at(place), self.plant[1].at(place));
        let [rest, rest_slope] = self.rest[1].at(place);
        let cosine_slope = -late * sine / (one + place);
        let half = Complex::from(0.5);
        let sine_slope = (late * cosine / (one + place) - half * sine) / place;
        let slope = cosine_slope * odd + cosine * odd_slope + sine_slope * even + sine * even_slope;
        [cosine * odd + sine * even + rest, slope + rest_slope]
    }

    /// `C o_U + S e_U + o_V`, to all digits.
    fn long_balance(&self, place: DoubleDouble) -> DoubleDouble {
        let [cosine, sine] = turns(self.map.delay, place);
        let [even, odd] = self.plant.each_ref().map(|it| it.value(place));
        cosine * odd + sine * even + self.rest[1].value(place)
    }

    /// A real root near `start`, by Newton's steps for as long as they shrink.
    fn polished(&self, start: f64) -> DoubleDouble {
        let mut place = DoubleDouble::from(start);
        let mut least = f64::INFINITY;
        for _ in 0..STEPS {
            let [_, slope] = self.balance(Complex::from(f64::from(place)));
            let step = self.long_balance(place) / DoubleDouble::from(slope.re);
            let size = f64::from(step).abs();
            if size >= least || size.is_nan() {
                break;
            }
            (place, least) = (place - step, size);
        }
        place
    }

    /// The `κ` of a crossing at `Y`.
    fn stiffness(&self, place: DoubleDouble) -> f64 {
        let [cosine, sine] = turns(self.map.delay, place);
        let [even, odd] = self.plant.each_ref().map(|it| it.value(place));
        let others = cosine * even - place * sine * odd + self.rest[0].value(place);
        f64::from(-others / self.square.value(place))
    }
}

/// `cos(D θ)` and `sin(D θ) / tan(θ / 2)` as functions of `Y = tan²(θ / 2)`, by doubling: no digit is lost where `θ` is
/// small.
fn turns<T>(delay: u32, place: T) -> [T; 2]
where
    T: Copy + From<f64> + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    let one = T::from(1.0);
    let sum = one + place;
    let (once, first) = ((one - place) / sum, T::from(2.0) / sum);
    let (mut cosine, mut sine) = (one, T::from(0.0));
    for bit in (0..u32::BITS - delay.leading_zeros()).rev() {
        let product = cosine * sine;
        (cosine, sine) = (one - T::from(2.0) * place * sine * sine, product + product);
        if delay >> bit & 1 == 1 {
            (cosine, sine) = (cosine * once - place * sine * first, sine * once + cosine * first);
        }
    }
    [cosine, sine]
}
