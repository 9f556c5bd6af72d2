//! Velocity over an adaptive window of samples.

use nalgebra::SVector;

use crate::{ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, VelocityEstimator};

/// Velocity taken over a window that is as long as the motion is straight:
/// `v(n) = (x(n) − x(n−i)) / (i T)`, `v(0) = 0`.
///
/// `i` grows from 1 and stops before the first one whose line through `x(n)` and `x(n−i)` passes farther than `band`
/// (m, an encoder's resolution) from a sample between them, or at `ticks`, or at the first sample. Slow motion gets the
/// long window that a coarse encoder needs, fast motion the short one. This is the first-order adaptive windowing of
/// Janabi-Sharifi, Hayward and Chen, in its end-fit form (Discrete-time adaptive windowing for velocity estimation,
/// IEEE Transactions on Control Systems Technology 8(6), 2000). Each axis has its own window. A window of one tick is
/// the backward difference, to the bit. `T` is the sample's period; samples are taken to be equally spaced.
///
/// Instead of testing every line against every sample, it keeps the interval of slopes that fit all samples so
/// far. A sample just `band` away from the line is within: the band is widened by
/// `4 ε (|x(n)| + |x(n) − x(n−j)| + band)`, with `ε` the distance from one to the next number, which covers the
/// rounding of the positions and of the test. Without it, rounding would decide whether samples one count off a line,
/// which are common, are in or out.
///
/// A position that is not finite ends the windows that would reach it; it affects the later ones in no other way.
///
/// ```
/// use lyapunov_core::{Reading, Readings};
/// let mut readings = Readings::every(1e-3)?.windowed::<16>(16, 1e-5)?; // counts of 10 µm
/// let mut velocity: f64 = 0.0;
/// for tick in 0..100 {
///     let position = 1e-5 * f64::from(tick / 4); // a count every fourth tick: 2.5 mm/s
///     velocity = readings.read(Reading { position, applied: 0.0 }).sample.velocity;
/// }
/// assert!((velocity - 2.5e-3).abs() < 0.4e-3); // a difference says 0 or 10 mm/s
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Windowed<V: Signal, const N: usize> {
    ticks: usize,
    band: V::Scalar,
    /// The earlier positions, latest first.
    past: [V; N],
    known: usize,
}

impl<V: Signal, const N: usize> Windowed<V, N> {
    /// A window of up to `ticks` samples, as long as positions lie within `band`, m, of a line; `N` is the capacity.
    ///
    /// # Errors
    /// `ticks` is 0 or above `N`; `band` below 0, infinite or NaN.
    pub fn new(ticks: u32, band: V::Scalar) -> Result<Self, ParameterError> {
        Requirement::AtLeast(1.0).check("window ticks", f64::from(ticks))?;
        Requirement::AtMost(N as f64).check("window ticks", f64::from(ticks))?;
        let band = Requirement::NonNegative.check("window band", band)?;
        Ok(Self { ticks: ticks as usize, band, past: [V::zero(); N], known: 0 })
    }

    /// The slope of the longest line that fits, m per tick.
    #[inline(always)]
    fn slope(&self, sample: &PortSample<V>) -> V {
        let choose = <V::Scalar as Signal>::choose;
        let endless = V::Scalar::of(f64::INFINITY);
        let none = V::Scalar::of(f64::NAN);
        let mut slope = if self.known == 0 { V::zero() } else { sample.displacement };
        let (mut least, mut most) = (V::splat(-endless), V::splat(endless));
        for (index, &past) in self.past[..self.known].iter().enumerate() {
            let ticks = V::Scalar::of((index + 1) as f64);
            let moved = sample.position - past;
            if index > 0 {
                // NaN marks an axis whose line does not fit, or did not before.
                let line = moved
                    .zip(least, |moved, least| {
                        let line = moved / ticks;
                        choose(line.above(least), line, none)
                    })
                    .zip(most, |line, most| choose(line.below(most), line, none));
                slope = line.zip(slope, |line, slope| choose(line.finite(), line, slope));
                least = line.zip(least, |line, least| choose(line.finite(), least, endless));
            }
            let band = sample.position.zip(moved, |position, moved| self.widened(position, moved));
            least =
                least.zip(moved.zip(band, |moved, band| (moved - band) / ticks), Scalar::larger);
            most = most.zip(moved.zip(band, |moved, band| (moved + band) / ticks), Scalar::smaller);
        }
        slope
    }

    /// The band, widened by what rounding may add.
    #[inline(always)]
    fn widened(&self, position: V::Scalar, moved: V::Scalar) -> V::Scalar {
        let size = position.magnitude() + moved.magnitude() + self.band;
        // The smallest normal number keeps the interval open around a rest at zero.
        self.band
            + (V::Scalar::of(4.0) * V::Scalar::epsilon() * size + V::Scalar::smallest_normal())
    }
}

impl<V: Signal, const N: usize> VelocityEstimator<V> for Windowed<V, N> {
    #[inline(always)]
    fn velocity(&mut self, sample: &PortSample<V>) -> V {
        let velocity = self.slope(sample).map(|slope| slope / sample.period);
        let window = &mut self.past[..self.ticks];
        window.rotate_right(1);
        window[0] = sample.position;
        self.known = (self.known + 1).min(self.ticks);
        velocity
    }

    fn interrupt(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        let unknown = V::splat(V::Scalar::of(f64::NAN));
        for past in &mut self.past {
            *past = V::choose(lanes, unknown, *past);
        }
    }

    fn restart(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        self.interrupt(lanes);
    }
}

impl<V: Signal, const N: usize> Snapshot for Windowed<V, N> {
    /// The earlier positions, latest first and NaN where a window ends, and how many there are.
    type State = (SVector<V, N>, u32);

    fn state(&self) -> Self::State {
        (SVector::from(self.past), self.known as u32)
    }

    fn restored(self, (past, known): Self::State) -> Result<Self, ParameterError> {
        Requirement::AtMost(self.ticks as f64).check("stored positions", f64::from(known))?;
        Ok(Self { past: past.into(), known: known as usize, ..self })
    }
}
