//! Characteristic polynomial of a loop over one environment period.

use nalgebra::{Complex, DMatrix, DVector, RowDVector};
use num_traits::Zero;

use super::LinearPart;
use super::linear_part::VelocitySource;
use super::pair::Pair;
use super::polynomial::Polynomial;
use super::roots::{circle, settle};
use lyapunov::accumulators::DoubleDouble;

/// Terms of the exponential's series: `0.5²⁸ / 28!` is far below a rounding.
const DEGREE: u32 = 28;

/// A root moves by less than this share of itself, squared, while its last digits are computed.
const POLISH: f64 = 1e-8;

/// The largest value of the polynomial at what counts as a root, as a share of the sum of the sizes of its terms: rounding and
/// a high order leave less at a root, so that a place with more is none.
const NEAR: f64 = 1e-3;

/// Characteristic polynomial of the map that takes a loop from one tick of the environment to the next,
///
/// ```text
/// P(w) = (1 + w)^D a(w) + r(w) + κ k(w),    w = z − 1,    κ = K T² / m,
/// ```
///
/// with `m` the device's mass, `r` of the environment's damper and mass, and `D` the delay of its answer in periods.
///
/// The plant moves exactly over every servo tick by the increments `exp(A T) − I` (those of
/// [`held_input`](lyapunov::bodies::held_input), in twice the digits), and the ticks of a period are combined in the
/// same form, `(I + E)(I + F) − I = E + F + E F`. Nothing is ever added to the identity, and the polynomials are in
/// `w`, so that a damping of `b T / m = 10⁻⁸` keeps all its digits.
#[derive(Clone, Debug)]
pub(super) struct LoopMap {
    /// `D`, environment periods.
    pub(super) delay: u32,
    /// `a`: the plant.
    pub(super) plant: Polynomial,
    /// `r`: the part of the environment's damper and mass.
    pub(super) rest: Polynomial,
    /// `k`: the part of each unit of its stiffness.
    pub(super) stiffness: Polynomial,
    /// `m / T²`, N/m.
    pub(super) unit: f64,
}

impl LoopMap {
    pub(super) fn of(part: &LinearPart) -> Self {
        let states = States::of(part);
        let (late, whole) = (part.delay % part.ratio, part.delay / part.ratio);
        let tick = states.tick(part);
        let (before, after) = (ticks(&tick, late), ticks(&tick, part.ratio - late));
        let n = states.count();
        let block =
            |map: &DMatrix<DoubleDouble>| (map.view((0, 0), (n, n)).into_owned(), column(map, n));
        let ((first, old), (second, new)) = (block(&before), block(&after));
        let moved = &first + &second + &second * &first;
        let old = &old + &second * &old;
        // An answer of the period before the last acts until the last one arrives.
        let inputs = if late > 0 { vec![old, new] } else { vec![new] };
        let (plant, adjoint) = resolvent(&moved);
        let seen = |row: RowDVector<DoubleDouble>| {
            let of = |input: &DVector<DoubleDouble>| {
                let entry = |term: &DMatrix<DoubleDouble>| (&row * term * input)[0];
                Polynomial::new(adjoint.iter().rev().map(entry).collect())
            };
            let parts: Vec<_> = inputs.iter().map(of).collect();
            match parts.as_slice() {
                [old, new] => old.plus(&new.times(&z())),
                one => one[0].clone(),
            }
        };
        let delay = whole + u64::from(late > 0);
        Self::closed(part, delay as u32, plant, &seen(states.device(0)), &seen(states.velocity()))
    }

    /// The loop about a plant whose position and velocity answer an effort by `x / plant` and `v / plant`.
    fn closed(
        part: &LinearPart,
        delay: u32,
        plant: Polynomial,
        x: &Polynomial,
        v: &Polynomial,
    ) -> Self {
        let (period, mass) = (part.period, part.device.mass);
        let damping = DoubleDouble::from(part.environment.damping) * DoubleDouble::from(period)
            / DoubleDouble::from(mass);
        let inertia = DoubleDouble::from(part.environment.mass)
            / (DoubleDouble::from(mass) * DoubleDouble::from(part.ratio as f64));
        let minus = DoubleDouble::from(-1.0);
        let unit = mass / (period * period);
        if part.environment.mass == 0.0 {
            let (rest, stiffness) = (v.scaled(damping * minus), x.scaled(minus));
            return Self { delay, plant, rest, stiffness, unit };
        }
        // The velocity before the last is one more state, which is a factor z.
        let difference = Polynomial::new(vec![DoubleDouble::from(0.0), inertia]);
        let rest = v.times(&z().scaled(damping).plus(&difference)).scaled(minus);
        let stiffness = x.times(&z()).scaled(minus);
        Self { delay, plant: plant.times(&z()), rest, stiffness, unit }
    }

    /// The roots `w` of `P` at a stiffness of `kappa`; NaN for those out of the range of the numbers.
    pub(super) fn roots(&self, kappa: f64) -> Vec<Complex<f64>> {
        let answer = self.rest.plus(&self.stiffness.scaled(kappa.into()));
        let is_open = answer.coefficients().iter().all(|it| it.is_zero());
        let delay = if is_open { 0 } else { self.delay };
        let count = self.plant.degree() + delay as usize;
        let one = Complex::from(1.0);
        let step = |w: Complex<f64>| {
            let z = one + w;
            let [a, slope] = self.plant.at(w);
            let [r, slant] = answer.at(w);
            let late = Complex::from(f64::from(delay));
            // Large values are divided out.
            let (value, derivative) = if z.norm_sqr() > 1.0 {
                let back = z.inv().powu(delay);
                (a + r * back, slope + late * a / z + slant * back)
            } else if delay == 0 {
                (a + r, slope + slant)
            } else {
                let ahead = z.powu(delay - 1);
                (ahead * z * a + r, ahead * (z * slope + late * a) + slant)
            };
            ratio(value, derivative)
        };
        let mut places: Vec<_> = circle(count).map(|z| z - one).collect();
        settle(&mut places, step);
        let polished = places.into_iter().map(|w| {
            // The value to all digits; its derivative needs few.
            let value = self.long_value(&answer, delay, w);
            let size = self.size(&answer, delay, w);
            if !(size.is_finite() && (value.re.abs() + value.im.abs()) <= NEAR * size) {
                return Complex::from(f64::NAN);
            }
            let change = ratio(value, ratio(self.value(&answer, delay, w), step(w)));
            if change.norm_sqr() < POLISH * w.norm_sqr() { w - change } else { w }
        });
        polished.collect()
    }

    fn value(&self, answer: &Polynomial, delay: u32, w: Complex<f64>) -> Complex<f64> {
        let z = Complex::from(1.0) + w;
        z.powu(delay) * self.plant.at(w)[0] + answer.at(w)[0]
    }

    /// The sum of the sizes of all terms of the value, a little further from 0 than `w`: at a root there only one is left.
    fn size(&self, answer: &Polynomial, delay: u32, w: Complex<f64>) -> f64 {
        let z = (Complex::from(1.0) + w).norm_sqr().sqrt();
        let w = w.norm_sqr().sqrt() + NEAR;
        let sum = |it: &Polynomial| {
            let sizes = it.coefficients().iter().map(|it| f64::from(*it).abs());
            sizes.rev().fold(0.0, |sum, size| sum * w + size)
        };
        num_traits::pow(z, delay as usize) * sum(&self.plant) + sum(answer)
    }

    fn long_value(&self, answer: &Polynomial, delay: u32, w: Complex<f64>) -> Complex<f64> {
        let w = Pair::from(w);
        let z = Pair { re: w.re + DoubleDouble::from(1.0), im: w.im };
        let late = (0..u32::BITS - delay.leading_zeros()).rev().fold(Pair::one(), |power, bit| {
            let square = power.times(power);
            if delay >> bit & 1 == 1 { square.times(z) } else { square }
        });
        late.times(self.plant.long_at(w)).plus(answer.long_at(w)).into()
    }

    /// The largest distance of a root beyond the unit circle: `|z|² − 1 = 2 Re w + |w|²`, the largest of all roots; NaN
    /// where the loop is out of the range of the numbers.
    pub(super) fn growth(&self, kappa: f64) -> f64 {
        let roots = self.roots(kappa).into_iter();
        let growths = roots.map(|w| 2.0 * w.re + w.norm_sqr());
        let is_lost = |most: f64, it: f64| most.is_nan() || !it.is_finite();
        growths.fold(-1.0, |most, it| if is_lost(most, it) { f64::NAN } else { most.max(it) })
    }
}

/// `one / other`, whose squares may be out of range.
fn ratio(one: Complex<f64>, other: Complex<f64>) -> Complex<f64> {
    let size = other.re.abs().max(other.im.abs());
    // A power of two, which changes no digit.
    let exponent = size.to_bits() >> 52;
    let by = f64::from_bits(0x7fe_u64.saturating_sub(exponent).max(1) << 52);
    one * by / (other * by)
}

/// `z = 1 + w`.
fn z() -> Polynomial {
    Polynomial::new(vec![DoubleDouble::from(1.0), DoubleDouble::from(1.0)])
}

fn column(map: &DMatrix<DoubleDouble>, n: usize) -> DVector<DoubleDouble> {
    map.view((0, n), (n, 1)).column(0).into_owned()
}

/// `det(w I − E)`, and the terms of its adjoint from the highest power down (Faddeev and Le Verrier; Gantmacher, The
/// Theory of Matrices, 1959, chapter IV).
fn resolvent(map: &DMatrix<DoubleDouble>) -> (Polynomial, Vec<DMatrix<DoubleDouble>>) {
    let n = map.nrows();
    let identity = DMatrix::<DoubleDouble>::identity(n, n);
    let (mut coefficients, mut adjoint) = (vec![DoubleDouble::from(1.0)], vec![identity.clone()]);
    for power in 1..=n {
        let product = map * &adjoint[power - 1];
        let coefficient = -product.diagonal().sum() / DoubleDouble::from(power as f64);
        coefficients.push(coefficient);
        if power < n {
            adjoint.push(product + &identity * coefficient);
        }
    }
    coefficients.reverse();
    (Polynomial::new(coefficients), adjoint)
}

/// Increment over `count` ticks, from the increment over one.
fn ticks(tick: &DMatrix<DoubleDouble>, mut count: u64) -> DMatrix<DoubleDouble> {
    let mut all = DMatrix::zeros(tick.nrows(), tick.ncols());
    let mut base = tick.clone();
    while count > 0 {
        if count % 2 == 1 {
            all = &all + &base + &base * &all;
        }
        base = &base * DoubleDouble::from(2.0) + &base * &base;
        count /= 2;
    }
    all
}

/// Entries of a tick's state: place and velocity of the centre of mass, with a link its stretch and how fast that grows, and the
/// estimated velocity where it is a state.
///
/// As the difference of two places a stiff link's stretch would have only the digits that its stiffness leaves of theirs.
#[derive(Clone, Copy, Debug)]
struct States {
    /// `m_o / M`, by which share of the stretch the device is behind the centre; none without a link.
    behind: Option<DoubleDouble>,
    share: Option<f64>,
}

impl States {
    fn of(part: &LinearPart) -> Self {
        let operator = DoubleDouble::from(part.operator.mass);
        let behind = part.link.map(|_| operator / (operator + part.device.mass.into()));
        let share = match part.velocity {
            VelocitySource::Difference { share } if part.needs_velocity() => Some(share),
            _ => None,
        };
        Self { behind, share }
    }

    /// Entries that move by themselves.
    fn moving(self) -> usize {
        if self.behind.is_some() { 4 } else { 2 }
    }

    fn count(self) -> usize {
        self.moving() + usize::from(self.share.is_some())
    }

    /// The device's position, or with an `order` of 1 its velocity, as a sum of the entries.
    fn device(self, order: usize) -> RowDVector<DoubleDouble> {
        let mut sum = RowDVector::zeros(self.count());
        sum[order] = 1.0.into();
        if let Some(behind) = self.behind {
            sum[2 + order] = -behind;
        }
        sum
    }

    fn velocity(self) -> RowDVector<DoubleDouble> {
        if self.share.is_none() {
            return self.device(1);
        }
        let mut sum = RowDVector::zeros(self.count());
        sum[self.moving()] = 1.0.into();
        sum
    }

    /// Increment of the state over one servo tick, with the held effort as its last entry.
    fn tick(self, part: &LinearPart) -> DMatrix<DoubleDouble> {
        let (moving, n) = (self.moving(), self.count());
        let gained = increments(&rates(part));
        let mut tick = DMatrix::zeros(n + 1, n + 1);
        let to = |column: usize| if column == moving { n } else { column };
        for row in 0..moving {
            for column in 0..=moving {
                tick[(row, to(column))] = gained[(row, column)];
            }
        }
        if let Some(share) = self.share.map(DoubleDouble::from) {
            let way: RowDVector<DoubleDouble> = self.device(0) * tick.rows(0, n) * share;
            tick.row_mut(moving).copy_from(&way);
            tick[(moving, moving)] -= share;
        }
        tick
    }
}

/// Time derivatives of the state's moving entries and of the held effort, with respect to these, in units of `T`, of the device's
/// mass and of any length.
fn rates(part: &LinearPart) -> DMatrix<DoubleDouble> {
    let of = |value: f64| DoubleDouble::from(value);
    let (period, device, hand) = (of(part.period), of(part.device.mass), of(part.operator.mass));
    let (pull, held) = (of(part.operator.stiffness), of(part.operator.damping));
    let own = of(part.device.damping);
    let damped = |value: DoubleDouble, mass: DoubleDouble| value * period / mass;
    let sprung = |value: DoubleDouble, mass: DoubleDouble| value * period * period / mass;
    let (zero, one) = (of(0.0), of(1.0));
    let both = device + hand;
    let (to_hand, to_device) = (device / both, hand / both);
    let centre = [-sprung(pull, both), -damped(held + own, both)];
    let Some(link) = part.link else {
        let row = [centre[0], centre[1], -to_hand];
        return DMatrix::from_row_slice(3, 3, &[[zero, one, zero], row, [zero; 3]].concat());
    };
    let (kl, bl) = (of(link.stiffness), of(link.damping));
    let spring = sprung(pull * to_hand + kl, hand) + sprung(kl, device);
    let damper = damped(held * to_hand + bl, hand) + damped(own * to_device + bl, device);
    let rows = [
        [zero, one, zero, zero, zero],
        [
            centre[0],
            centre[1],
            -sprung(pull * to_hand, both),
            damped(own * to_device - held * to_hand, both),
            -to_hand,
        ],
        [zero, zero, zero, one, zero],
        [-sprung(pull, hand), damped(own, device) - damped(held, hand), -spring, -damper, one],
        [zero; 5],
    ];
    DMatrix::from_row_slice(5, 5, &rows.concat())
}

/// `exp(A) − I` by scaling and squaring, as in [`held_input`](lyapunov::bodies::held_input).
fn increments(rates: &DMatrix<DoubleDouble>) -> DMatrix<DoubleDouble> {
    let n = rates.nrows();
    let identity = DMatrix::<DoubleDouble>::identity(n, n);
    let size = |matrix: &DMatrix<DoubleDouble>| {
        let row = |row: usize| (0..n).map(|at| f64::from(matrix[(row, at)]).abs()).sum::<f64>();
        (0..n).map(row).fold(0.0, f64::max)
    };
    let mut scaled = rates.clone();
    let mut halvings = 0;
    while size(&scaled) > 0.5 && size(&scaled) < f64::INFINITY {
        scaled *= DoubleDouble::from(0.5);
        halvings += 1;
    }
    let mut polynomial = identity.clone();
    for degree in (2..=DEGREE).rev() {
        polynomial = &identity
            + (&scaled * &polynomial)
                * (DoubleDouble::from(1.0) / DoubleDouble::from(f64::from(degree)));
    }
    let mut increment = &scaled * &polynomial;
    for _ in 0..halvings {
        increment = &increment * DoubleDouble::from(2.0) + &increment * &increment;
    }
    increment
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn by `angle`, `exp((0, angle; -angle, 0)) = (cos, sin; -sin, cos)`, and a decay beside it.
    #[test]
    fn increments_of_a_fast_swing_are_those_of_a_turn() {
        for angle in [1e-3, 0.4, 3.0, 40.0] {
            let rows =
                [0.0, angle, 0.0, -angle, 0.0, 0.0, 0.0, 0.0, -angle].map(DoubleDouble::from);
            let found = increments(&DMatrix::from_row_slice(3, 3, &rows));
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let want = [cos - 1.0, sin, 0.0, -sin, cos - 1.0, 0.0, 0.0, 0.0, libm::expm1(-angle)];
            for (index, want) in want.into_iter().enumerate() {
                let off = f64::from(found[(index / 3, index % 3)]) - want;
                assert!(off.abs() < 1e-15 * (1.0 + angle), "{angle}: {index} is off by {off}");
            }
        }
    }
}
