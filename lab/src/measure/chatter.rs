//! Chatter of a force.

use std::f64::consts::TAU;

use lyapunov::{Scalar, Signal};

/// The band, Hz: the hand feels it as buzzing.
const BAND: (f64, f64) = (5.0, 50.0);

/// Watches a force's root mean square between 5 and 50 Hz by Welch's method: the mean over segments of one
/// second, overlapping by half, of the power in the band under a Hann window; in several dimensions the power of all axes.
///
/// The window keeps a force that merely stays or drifts from leaking into the band. The sums run along with the ticks,
/// one turning phasor per frequency, and keep no sample: a transform of the whole run would need memory in proportion
/// to its length.
#[derive(Clone, Debug)]
pub(crate) struct Chatter<V: Signal> {
    length: i64,
    hop: i64,
    /// The place of the tick in the segments of even and of odd number; not in one below 0, and from `length` on.
    places: [i64; 2],
    /// The place of the tick in the phasors' round.
    turned: i64,
    windows: [Phasor; 2],
    phasors: Phasors,
    lines: Vec<Line<V>>,
    /// The windowed forces of ticks that the lines do not have yet.
    waiting: [[V; 2]; BLOCK],
    count: usize,
    power: V::Scalar,
    segments: u64,
}

/// Ticks that the sums of a line take at once: they are read and written once for all of these.
const BLOCK: usize = 8;

/// One frequency: the sums of the two segments that overlap.
#[derive(Clone, Copy, Debug)]
struct Line<V> {
    sums: [(V, V); 2],
    /// 2 for a line that also stands for its mirror image.
    weight: f64,
}

/// `e^(−i angle n)`, updated by rotation.
#[derive(Clone, Copy, Debug)]
struct Phasor {
    turn: (f64, f64),
    now: (f64, f64),
}

impl Phasor {
    fn new(angle: f64) -> Self {
        Self { turn: (libm::cos(angle), -libm::sin(angle)), now: (1.0, 0.0) }
    }

    /// The phasor's value, or 1 if it starts `anew`; then rotates it.
    #[inline(always)]
    fn next(&mut self, anew: bool) -> (f64, f64) {
        let (cos, sin) = if anew { (1.0, 0.0) } else { self.now };
        let turn = self.turn;
        self.now = (cos * turn.0 - sin * turn.1, cos * turn.1 + sin * turn.0);
        (cos, sin)
    }
}

/// The phasors of all lines, which turn side by side, and their values over the ticks of a block.
#[derive(Clone, Debug)]
struct Phasors {
    each: Vec<Phasor>,
    values: [Vec<(f64, f64)>; BLOCK],
}

impl Phasors {
    fn new(each: Vec<Phasor>) -> Self {
        let values = [(); BLOCK].map(|()| vec![(0.0, 0.0); each.len()]);
        Self { each, values }
    }

    /// Turns the phasors over `count` ticks, from 1 if they start `anew`.
    #[inline(always)]
    fn turn(&mut self, count: usize, anew: bool) {
        for (tick, values) in self.values.iter_mut().take(count).enumerate() {
            for (value, phasor) in values.iter_mut().zip(&mut self.each) {
                *value = phasor.next(anew && tick == 0);
            }
        }
    }
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
        let line = |index: u64| {
            let weight = if 2.0 * index as f64 == length { 1.0 } else { 2.0 };
            Line { sums: [(V::zero(), V::zero()); 2], weight }
        };
        let phasor = |index: u64| Phasor::new(TAU * index as f64 / length);
        let windows = [Phasor::new(TAU / length); 2];
        let length = length as i64;
        let hop = length - length / 2;
        Some(Self {
            length,
            hop,
            places: [0, -hop],
            turned: 0,
            windows,
            phasors: Phasors::new((first..=last).map(phasor).collect()),
            lines: (first..=last).map(line).collect(),
            waiting: [[V::zero(); 2]; BLOCK],
            count: 0,
            power: V::Scalar::of(0.0),
            segments: 0,
        })
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, force: V) {
        self.waiting[self.count] = [self.windowed(0, force), self.windowed(1, force)];
        self.count += 1;
        let closing = self.places.map(|place| place == self.length - 1);
        // Every line comes round within a segment; restarting there keeps rounding from accumulating.
        let comes_round = self.turned == self.length - 1;
        if self.count == BLOCK || comes_round || closing[0] || closing[1] {
            self.sum();
        }
        for which in [0, 1] {
            if closing[which] {
                self.close(which);
            }
            let last = self.places[which] == 2 * self.hop - 1;
            self.places[which] = if last { 0 } else { self.places[which] + 1 };
        }
        self.turned = if comes_round { 0 } else { self.turned + 1 };
    }

    /// The force under the Hann window of the tick's segment of even or odd number.
    #[inline(always)]
    fn windowed(&mut self, which: usize, force: V) -> V {
        let place = self.places[which];
        if !(0..self.length).contains(&place) {
            return V::zero();
        }
        let (cos, _) = self.windows[which].next(place == 0);
        force.scale(V::Scalar::of(0.5 - 0.5 * cos))
    }

    /// Adds the forces that wait to the sums of all lines, tick by tick.
    #[inline(always)]
    fn sum(&mut self) {
        let anew = self.turned + 1 == self.count as i64;
        self.phasors.turn(self.count, anew);
        for (index, line) in self.lines.iter_mut().enumerate() {
            let mut sums = line.sums;
            for (parts, values) in self.waiting.iter().zip(&self.phasors.values).take(self.count) {
                let (cos, sin) = values[index];
                for (sum, part) in sums.iter_mut().zip(parts) {
                    sum.0 = sum.0 + part.scale(V::Scalar::of(cos));
                    sum.1 = sum.1 + part.scale(V::Scalar::of(sin));
                }
            }
            line.sums = sums;
        }
        self.count = 0;
    }

    fn close(&mut self, which: usize) {
        for line in &mut self.lines {
            let (re, im) = std::mem::replace(&mut line.sums[which], (V::zero(), V::zero()));
            self.power += V::Scalar::of(line.weight) * (re.inner(re) + im.inner(im));
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
