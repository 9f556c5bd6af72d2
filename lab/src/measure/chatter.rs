//! Chatter of a force.

use std::f64::consts::TAU;

use lyapunov::{Scalar, Signal, lanes::apart};

/// The band, Hz: the hand feels it as buzzing.
const BAND: (f64, f64) = (5.0, 50.0);

/// Watches a force's root mean square between 5 and 50 Hz by Welch's method: the mean over segments of one
/// second, overlapping by half, of the power in the band under a Hann window; in several dimensions the power of all axes.
///
/// The window keeps a force that merely stays or drifts from leaking into the band. It acts on the sums and not on the
/// samples: under it, a line is half of itself less a quarter of each of its neighbours. So one set of sums of half a
/// segment serves both segments that share it. The sums run along with the ticks and keep no more than a block of them:
/// a transform of the whole run would need memory in proportion to its length.
#[derive(Clone, Debug)]
pub(crate) struct Chatter<V: Signal> {
    length: i64,
    hop: i64,
    /// The place of the tick in its half of a segment.
    place: i64,
    /// Those of the band, and one more at each end.
    lines: Vec<Line<V>>,
    /// The half segment before in each line, apart from what every block reads: two groups of lanes then fit the nearest cache.
    befores: Vec<Before<V>>,
    /// The forces of ticks that the lines do not have yet.
    waiting: [V; BLOCK],
    count: usize,
    is_first: bool,
    power: V::Scalar,
    segments: u64,
}

/// Ticks that the sums of a line take at once. With phases counted from the middle of a block, its ticks pair up.
const BLOCK: usize = 16;

/// Half of them: the pairs.
const PAIRS: usize = BLOCK / 2;

/// A complex number.
type Complex<T> = (T, T);

/// One frequency, by its sum over a half segment.
#[derive(Clone, Copy, Debug)]
struct Line<V> {
    sum: Complex<V>,
    /// The cosine and the sine of the angle from the middle of a block to each pair's later tick.
    pairs: [Complex<f64>; PAIRS],
    /// The phase of the middle of the block, and its change from block to block.
    now: Complex<f64>,
    turn: Complex<f64>,
}

/// The half segment before of a line.
#[derive(Clone, Copy, Debug)]
struct Before<V> {
    sum: Complex<V>,
    /// The phase of the middle of a half segment's first block.
    first: Complex<f64>,
    /// The change of phase over a half segment.
    half: Complex<f64>,
    /// 2 for a line that also stands for its mirror image.
    weight: f64,
}

/// `e^(−i angle)`.
fn phase(angle: f64) -> Complex<f64> {
    (libm::cos(angle), -libm::sin(angle))
}

/// `sum` with `by · to` added to it.
#[inline(always)]
fn turned<V: Signal>(sum: Complex<V>, by: Complex<f64>, to: Complex<V>) -> Complex<V> {
    let [cos, sin] = [V::Scalar::of(by.0), V::Scalar::of(by.1)];
    let real = to.0.scale(cos) - to.1.scale(sin);
    let imaginary = to.0.scale(sin) + to.1.scale(cos);
    (sum.0 + real, sum.1 + imaginary)
}

impl<V: Signal> Line<V> {
    /// The line of `index` turns in a segment of `length` ticks, of which `hop` are its first half.
    fn new(index: f64, length: f64, hop: f64) -> (Self, Before<V>) {
        let angle = TAU * index / length;
        let none = (V::zero(), V::zero());
        let pairs = std::array::from_fn(|pair| {
            let (cos, sin) = phase(angle * (pair as f64 + 0.5));
            (cos, -sin)
        });
        let first = phase(angle * (BLOCK - 1) as f64 / 2.0);
        let turn = phase(angle * BLOCK as f64);
        let half = phase(angle * hop);
        let weight = if 2.0 * index == length { 1.0 } else { 2.0 };
        let line = Self { sum: none, pairs, now: first, turn };
        (line, Before { sum: none, first, half, weight })
    }

    /// Adds a block by the sums and the differences of its pairs.
    #[inline(always)]
    fn add(&mut self, pairs: &[Complex<V>; PAIRS]) {
        let mut block = (V::zero(), V::zero());
        for (pair, (sum, difference)) in pairs.iter().enumerate() {
            let (cos, sin) = self.pairs[pair];
            block.0 = block.0 + sum.scale(V::Scalar::of(cos));
            block.1 = block.1 - difference.scale(V::Scalar::of(sin));
        }
        self.sum = turned(self.sum, self.now, block);
        self.now = turned((0.0, 0.0), self.turn, self.now);
    }

    /// The sum over the half segment `before`, this one as far as it is there, and a block more if there is one.
    #[inline(always)]
    fn segment(mut self, before: &Before<V>, more: Option<&[Complex<V>; PAIRS]>) -> Complex<V> {
        if let Some(pairs) = more {
            self.add(pairs);
        }
        turned(before.sum, before.half, self.sum)
    }

    /// Begins the next half segment. The phases start anew there, so that their roundings do not add up.
    #[inline(always)]
    fn begin(&mut self, before: &mut Before<V>) {
        before.sum = std::mem::replace(&mut self.sum, (V::zero(), V::zero()));
        self.now = before.first;
    }
}

/// A line's share of the window, which takes from those beside it.
#[inline(always)]
fn part<V: Signal>(of: V, beside: V) -> V {
    of.scale(V::Scalar::of(0.5)) - beside.scale(V::Scalar::of(0.25))
}

impl<V: Signal> Chatter<V> {
    /// A meter of a force at `rate` samples per second; none below 100, where the samples do not hold the band.
    pub(crate) fn new(rate: f64) -> Option<Self> {
        // Above 1e9 no scene lasts a second.
        if !(2.0 * BAND.1..=1e9).contains(&rate) {
            return None;
        }
        let length = rate.round();
        let within = 1e-9;
        let first = (BAND.0 * length / rate - within).ceil() as u64;
        let last = ((BAND.1 * length / rate + within).floor() as u64).min(length as u64 / 2);
        let hop = length - (length / 2.0).floor();
        let line = |index: u64| Line::new(index as f64, length, hop);
        let (lines, befores) = (first - 1..=last + 1).map(line).unzip();
        Some(Self {
            length: length as i64,
            hop: hop as i64,
            place: 0,
            lines,
            befores,
            waiting: [V::zero(); BLOCK],
            count: 0,
            is_first: true,
            power: V::Scalar::of(0.0),
            segments: 0,
        })
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, force: V) {
        self.waiting[self.count] = force;
        self.count += 1;
        self.place += 1;
        let ends = self.place == self.hop;
        if self.count == BLOCK || ends {
            let pairs = self.pairs();
            // A loop, as closures are not always inlined on lanes.
            for line in &mut self.lines {
                line.add(&pairs);
            }
            self.count = 0;
        }
        // A segment of an odd number of ticks ends a tick before its second half.
        if self.place == self.length - self.hop && !self.is_first {
            self.close();
        }
        if ends {
            for (line, before) in self.lines.iter_mut().zip(&mut self.befores) {
                line.begin(before);
            }
            (self.place, self.is_first) = (0, false);
        }
    }

    /// The sums and the differences of the pairs that wait, from the middle out.
    #[inline(always)]
    fn pairs(&mut self) -> [Complex<V>; PAIRS] {
        self.waiting[self.count..].fill(V::zero());
        let mut pairs = [(V::zero(), V::zero()); PAIRS];
        for (pair, both) in pairs.iter_mut().enumerate() {
            apart::<V::Scalar>();
            let (early, late) = (self.waiting[PAIRS - 1 - pair], self.waiting[PAIRS + pair]);
            *both = (late + early, late - early);
        }
        pairs
    }

    #[inline(always)]
    fn close(&mut self) {
        let more = (self.count > 0).then(|| self.pairs());
        let none = (V::zero(), V::zero());
        let (mut below, mut line, mut weight) = (none, none, 0.0);
        for (index, (next, before)) in self.lines.iter().zip(&self.befores).enumerate() {
            let above = next.segment(before, more.as_ref());
            // The first of all stands between no two.
            if index > 1 {
                let (re, im) = (part(line.0, below.0 + above.0), part(line.1, below.1 + above.1));
                self.power += V::Scalar::of(weight) * (re.inner(re) + im.inner(im));
            }
            (below, line, weight) = (line, above, before.weight);
        }
        self.segments += 1;
    }

    /// The root mean square in the band, N; none before a whole second has passed.
    pub(crate) fn root_mean_square(&self) -> Option<V::Scalar> {
        let length = self.length as f64;
        // The squares of a Hann window of this length sum to 3/8 of it.
        let scale = length * 0.375 * length * self.segments as f64;
        (self.segments > 0).then(|| (self.power / V::Scalar::of(scale)).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;

    fn chatter(rate: f64, count: u32, force: impl Fn(f64) -> f64) -> Option<f64> {
        let mut meter = Chatter::<f64>::new(rate)?;
        (0..count).for_each(|n| meter.add(force(f64::from(n) / rate)));
        meter.root_mean_square()
    }

    fn tone(frequency: f64) -> impl Fn(f64) -> f64 {
        move |t| 3.0 * (TAU * frequency * t + 0.7).sin()
    }

    /// Welch's method by its definition, over stored samples.
    fn welch(rate: f64, samples: &[f64]) -> f64 {
        let length = rate.round() as usize;
        let hop = length - length / 2;
        let starts: Vec<usize> =
            (0..).map(|i| i * hop).take_while(|s| s + length <= samples.len()).collect();
        let window = |j: usize| (std::f64::consts::PI * j as f64 / length as f64).sin().powi(2);
        let squares: f64 = (0..length).map(|j| window(j).powi(2)).sum();
        let mut mean_square = 0.0;
        for k in 0..=length / 2 {
            let frequency = k as f64 * rate / length as f64;
            if !(5.0 - 1e-9..=50.0 + 1e-9).contains(&frequency) {
                continue;
            }
            let sides = if 2 * k == length { 1.0 } else { 2.0 };
            for start in &starts {
                let part = |f: fn(f64) -> f64| -> f64 {
                    let angle = |j: usize| TAU * (k * j % length) as f64 / length as f64;
                    (0..length).map(|j| window(j) * samples[start + j] * f(angle(j))).sum()
                };
                let power = part(f64::cos).powi(2) + part(f64::sin).powi(2);
                mean_square += sides * power / (length as f64 * squares * starts.len() as f64);
            }
        }
        mean_square.sqrt()
    }

    #[test]
    fn a_tone_in_the_band_is_its_root_mean_square() {
        for rate in [120.0, 1000.0, 1001.0, 4000.0] {
            for frequency in [7.0, 20.5, 48.0] {
                let measured = chatter(rate, 3 * rate as u32, tone(frequency)).unwrap();
                let expected = 3.0 / 2.0_f64.sqrt();
                assert_relative_eq!(measured, expected, epsilon = 0.0, max_relative = 1e-3);
            }
        }
    }

    #[test]
    fn a_tone_outside_the_band_and_a_constant_force_do_not_count() {
        for frequency in [1.0, 3.0, 60.0, 200.0] {
            assert!(chatter(1000.0, 3000, tone(frequency)).unwrap() < 1e-9, "{frequency}");
        }
        assert!(chatter(1000.0, 3000, |_| 100.0).unwrap() < 1e-9);
        // A drift of 1 N/s leaks less than a hundredth of a newton.
        assert!(chatter(1000.0, 3000, |t| t).unwrap() < 1e-2);
    }

    #[test]
    fn at_a_hundred_hertz_the_fastest_tone_counts_once() {
        // +3, −3, +3, ... at 50 Hz: its mean square is 9, all of it at 50 Hz and the lines beside.
        let measured = chatter(100.0, 300, |t| 3.0 * (TAU * 50.0 * t).cos()).unwrap();
        assert_abs_diff_eq!(measured, 3.0, epsilon = 1e-9);
    }

    #[test]
    fn the_meter_agrees_with_welch_s_method() {
        let noise = |n: u32| f64::from(n.wrapping_mul(2_654_435_761) >> 8) / 1e7;
        for (rate, count) in [(100.0, 350), (100.4, 350), (101.0, 420), (333.3, 1500)] {
            let samples: Vec<f64> = (0..count).map(noise).collect();
            let mut meter = Chatter::<f64>::new(rate).unwrap();
            samples.iter().for_each(|&sample| meter.add(sample));
            let (ours, expected) = (meter.root_mean_square().unwrap(), welch(rate, &samples));
            assert_relative_eq!(ours, expected, epsilon = 0.0, max_relative = 1e-9);
        }
    }

    #[test]
    fn slow_and_short_runs_have_none() {
        assert_eq!(chatter(99.0, 1000, |_| 1.0), None);
        assert_eq!(chatter(100.0, 99, |_| 1.0), None);
        assert_eq!(chatter(100.0, 100, |_| 0.0), Some(0.0));
        assert!(Chatter::<f64>::new(1e300).is_none() && Chatter::<f64>::new(1e9).is_some());
    }
}
