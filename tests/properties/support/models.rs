//! Random streams at a port, and the ledger of the tick contract in straight code.

use proptest::array::{uniform8, uniform16};
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::strategy::Strategy;

use lyapunov::{DampingLimit, HeldTick, PortSample, Scalar};

use crate::support::{Bits, Double, Port, Real, bad, hostile, log_between, ordinary};

/// Limits of `α` as shares of `m / T`.
const CAPS: [f64; 5] = [0.0, 0.25, 0.5, 1.0, f64::INFINITY];

/// The events at a port, sample by sample, and the stabilizer's parameters.
#[derive(Clone, Debug)]
pub(crate) struct Stream<V: Port> {
    pub(crate) limit: DampingLimit<V::Scalar>,
    /// Damping to credit, N·s/m.
    pub(crate) damping: V::Scalar,
    /// Surface of the contact credit on the first axis, m.
    pub(crate) surface: V::Scalar,
    pub(crate) samples: Vec<(PortSample<V>, V)>,
}

/// Streams of ordinary and of hostile numbers; if `faults`, some with NaN and infinities among them.
pub(crate) fn stream<V: Port>(faults: bool) -> impl Strategy<Value = Stream<V>> {
    (uniform8(any::<Bits>()), vec(uniform16(any::<Bits>()), 1..16)).prop_map(
        move |(config, samples)| {
            let of = V::Scalar::of;
            let period = of(log_between(config[0], 1e-4, 0.1));
            let mass = of(log_between(config[1], 1e-5, 10.0));
            let cap = of(CAPS[(config[2] % 5) as usize]);
            let tame = config[3] % 3 == 0;
            let entry = |bits: [Bits; 16]| {
                let (sample, effort) = drive_of(bits, tame, period);
                if faults && bits[14].is_multiple_of(4) {
                    spoil(sample, effort, bits[14] / 4)
                } else {
                    (sample, effort)
                }
            };
            Stream {
                limit: DampingLimit::of_mass(cap, mass, period).expect("a limit"),
                damping: of(log_between(config[4], 1e-3, 1.0)),
                surface: ordinary(config[5], 0.5),
                samples: samples.into_iter().map(entry).collect(),
            }
        },
    )
}

/// One sample, of `period`, or if not `tame` of a period of its own, and the effort behind.
pub(crate) fn drive_of<V: Port>(
    bits: [Bits; 16],
    tame: bool,
    period: V::Scalar,
) -> (PortSample<V>, V) {
    let number = |at: usize, scale: f64| {
        V::from_axes(|axis| match tame {
            true => ordinary(bits[at + axis], scale),
            false => hostile(bits[at + axis]),
        })
    };
    let (velocity, displacement) = (number(0, 1.0), number(3, 1e-3));
    let (applied, effort) = (number(6, 10.0), number(9, 10.0));
    let position = number(12 - 3 * usize::from(bits[15] & 1 == 0), 1.0);
    let period = if tame { period } else { Scalar::of(log_between(bits[15], 1e-6, 1.0)) };
    (HeldTick { period, position, velocity, displacement, applied }.sample(), effort)
}

/// The sample with a value that is not finite in it.
fn spoil<V: Port>(sample: PortSample<V>, effort: V, bits: Bits) -> (PortSample<V>, V) {
    let wrong = bad::<V::Scalar>(bits / 8);
    let axis = (bits / 64) as usize % V::AXES;
    let hit = |signal: V| V::from_axes(|at| if at == axis { wrong } else { signal.axis(at) });
    match bits % 8 {
        0 => (PortSample { period: wrong, ..sample }, effort),
        1 => (PortSample { position: hit(sample.position), ..sample }, effort),
        2 => (PortSample { velocity: hit(sample.velocity), ..sample }, effort),
        3 => (PortSample { displacement: hit(sample.displacement), ..sample }, effort),
        4 => (PortSample { applied: hit(sample.applied), ..sample }, effort),
        5 => (PortSample { work: hit(sample.work), ..sample }, effort),
        6 => (sample, hit(effort)),
        _ => (
            PortSample { work: hit(sample.work), velocity: hit(sample.velocity), ..sample },
            hit(effort),
        ),
    }
}

/// `v · v` with the axes summed as the port documents: the even ones plus the odd ones.
pub(crate) fn power<V: Port>(velocity: V) -> V::Scalar {
    let square = |axis: usize| velocity.axis(axis) * velocity.axis(axis);
    match V::AXES {
        1 => square(0),
        3 => (square(0) + square(2)) + square(1),
        axes => panic!("{axes} axes"),
    }
}

/// The work that is booked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Book {
    Held,
    Sampled,
}

/// The credit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Credit<T> {
    None,
    Always(T),
    /// Damping, and the surface beyond which it counts.
    InContact(T, T),
}

/// The recursion of the tick contract, in double-double, carrying `α(n−1)` and `v(n−1)² T` as the contract writes them.
///
/// A decrease that is not finite is left out; a sample is accepted if the sum, `v² T` and the effort are finite.
#[derive(Clone, Debug)]
pub(crate) struct Ledger<T> {
    book: Book,
    credit: Credit<T>,
    limit: f64,
    sum: Double,
    burnt: Double,
    /// Largest distance of the scalar's sum from this one: a few roundings of everything that went in.
    error: f64,
}

/// The contract for one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tick<T> {
    pub(crate) sum: f64,
    pub(crate) alpha: f64,
    pub(crate) shortfall: f64,
    /// `v² T`, in the scalar.
    pub(crate) square: T,
    /// `None` where rounding decides whether the corrected effort is still in range.
    pub(crate) accepted: Option<bool>,
    /// Largest error of the sum, J.
    pub(crate) error: f64,
}

impl<T: Real> Ledger<T> {
    pub(crate) fn new(book: Book, credit: Credit<T>, limit: DampingLimit<T>) -> Self {
        let (sum, burnt) = (Double::default(), Double::default());
        Self { book, credit, limit: limit.most().f64(), sum, burnt, error: 0.0 }
    }

    pub(crate) fn tick<V: Port<Scalar = T>>(
        &mut self,
        sample: &PortSample<V>,
        effort: V,
    ) -> Tick<T> {
        let square = power(sample.velocity) * sample.period;
        let (decrease, size) = self.decrease(sample, effort);
        let before = self.sum.value().abs();
        self.sum = self.sum + self.burnt;
        let booked = decrease.value().is_finite();
        if booked {
            self.sum = self.sum + decrease;
            self.error += 16.0 * T::unit() * (before + size + self.sum.value().abs());
            self.error += 16.0
                * T::smallest_positive().f64()
                * (1.0 + effort.axes().map(|f| f.f64().abs()).sum::<f64>().min(1e200));
        }
        let sum = self.sum.value();
        let squared = square.f64();
        let moving = squared > T::smallest_normal().f64();
        let alpha = if sum < 0.0 && moving { self.alpha(squared) } else { Double::default() };
        let slack =
            if moving { (self.error + 16.0 * T::unit() * sum.abs()) / squared } else { 0.0 };
        let sound = booked && squared.is_finite();
        let fits = self.fits(sample.velocity, effort, alpha.value(), slack);
        let accepted = if sound { fits } else { Some(false) };
        self.burnt = Double::default();
        let mut tick = Tick {
            sum,
            alpha: 0.0,
            shortfall: (-sum).max(0.0),
            square,
            accepted,
            error: self.error,
        };
        if accepted != Some(false) {
            // In the contract the debt is removed even where α is too small for a number.
            let vanishes = alpha.value() < f64::MIN_POSITIVE && self.limit > 0.0 && moving;
            let burnt = if vanishes { -self.sum } else { alpha * Double::of(squared) };
            let burnt = if sum < 0.0 { burnt } else { Double::default() };
            tick.alpha = alpha.value();
            tick.shortfall = if sum < 0.0 { (-self.sum - burnt).value().max(0.0) } else { 0.0 };
            if self.book == Book::Sampled {
                self.burnt = burnt;
            }
        }
        tick
    }

    /// Takes back this tick's correction: rounding decided against it.
    pub(crate) fn rejected(&mut self) {
        self.burnt = Double::default();
    }

    fn alpha(&self, square: f64) -> Double {
        match -self.sum.value() >= self.limit * square {
            true => Double::of(self.limit),
            false => (-self.sum).over(Double::of(square)),
        }
    }

    /// Work and credit, and the sum of their magnitudes.
    fn decrease<V: Port<Scalar = T>>(&self, sample: &PortSample<V>, effort: V) -> (Double, f64) {
        let (mut decrease, mut size) = (Double::default(), 0.0);
        let mut add = |term: Double| {
            decrease = decrease + term;
            size += term.value().abs();
        };
        let period = Double::of(sample.period.f64());
        for axis in 0..V::AXES {
            add(match self.book {
                Book::Held => Double::of(sample.work.axis(axis).f64()),
                Book::Sampled => {
                    let flow = sample.velocity.axis(axis).f64();
                    Double::product(effort.axis(axis).f64(), flow) * period
                }
            });
        }
        let damping = match self.credit {
            Credit::Always(damping) => Some(damping),
            Credit::InContact(damping, surface) if sample.position.axis(0) > surface => {
                Some(damping)
            }
            _ => None,
        };
        // A dissipation that the scalar cannot represent is not credited.
        let burnt = |damping| damping * (sample.velocity.inner(sample.velocity) * sample.period);
        if let Some(damping) = damping.filter(|&damping| burnt(damping).f64().is_finite()) {
            for axis in 0..V::AXES {
                let flow = sample.velocity.axis(axis).f64();
                add(Double::product(flow, flow) * period * Double::of(damping.f64()));
            }
        }
        (decrease, size)
    }

    /// Whether the corrected effort is finite, if that is certain.
    fn fits<V: Port<Scalar = T>>(
        &self,
        velocity: V,
        effort: V,
        alpha: f64,
        slack: f64,
    ) -> Option<bool> {
        let largest = T::largest().f64() / 8.0;
        let corrected = |alpha: f64, axis: usize| {
            let alpha = alpha.clamp(0.0, self.limit);
            (effort.axis(axis).f64() / 8.0 + alpha * (velocity.axis(axis).f64() / 8.0)).abs()
        };
        if !effort.all_finite() {
            Some(false)
        } else if (0..V::AXES).all(|axis| corrected(alpha + slack, axis) < 0.999 * largest) {
            Some(true)
        } else if (0..V::AXES).any(|axis| corrected(alpha - slack, axis) > 1.001 * largest) {
            Some(false)
        } else {
            None
        }
    }
}
