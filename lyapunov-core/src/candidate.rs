//! Lyapunov candidates: the functions whose decrease an observer sums.

use crate::{ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot};

/// Lyapunov candidate `V`, given by its decrease over each sample.
///
/// The observed energy of a candidate is `L(n) = Σ −ΔV`, in joules: what the port absorbed plus what the
/// candidate credits. `L ≥ 0` is good, `L < 0` a debt. (The paper's equation 7 wants the sum of `V̇` not
/// positive, its step 4 sums the negative of that and wants it not negative; this is step 4's sign. The
/// paper's sums leave out the period; here it is always in, so that a sum is an energy.)
///
/// A candidate is a sum of terms, written as a tuple: `(PortEnergy, wall.dissipation())` is the candidate that the
/// paper's example 2 prints in its step 4. A term of your own is one struct and one method:
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, LyapunovCandidate};
/// /// The port's energy, credited with what quadratic drag must have dissipated.
/// struct Drag { coefficient: f64 } // N·s²/m²
/// impl LyapunovCandidate<f64> for Drag {
///     fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
///         let v = sample.velocity;
///         sample.work + self.coefficient * v.abs() * v * v * sample.period
///     }
/// }
/// ```
pub trait LyapunovCandidate<V: Signal> {
    /// `−ΔV` over the sample, J: positive where the port absorbed or a damper dissipated energy.
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar;
}

impl<V: Signal, C: LyapunovCandidate<V> + ?Sized> LyapunovCandidate<V> for &mut C {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        (**self).decrease(sample)
    }
}

impl<V: Signal, A, B> LyapunovCandidate<V> for (A, B)
where
    A: LyapunovCandidate<V>,
    B: LyapunovCandidate<V>,
{
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        self.0.decrease(sample) + self.1.decrease(sample)
    }
}

impl<V: Signal, A, B, C> LyapunovCandidate<V> for (A, B, C)
where
    A: LyapunovCandidate<V>,
    B: LyapunovCandidate<V>,
    C: LyapunovCandidate<V>,
{
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        self.0.decrease(sample) + self.1.decrease(sample) + self.2.decrease(sample)
    }
}

/// The port's own energy, `−ΔV = Σ fᵢ Δxᵢ`: the candidate of the passivity observer, and of the paper's
/// example 1 (equations 10 to 12), whose spring stores exactly what crosses its port.
///
/// ```
/// use lyapunov_core::{HeldTick, LyapunovCandidate, PortEnergy};
/// let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: -2.0 };
/// assert_eq!(PortEnergy.decrease(&tick.sample()), -2e-4); // the port gave 0.2 mJ
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PortEnergy;

impl<V: Signal> LyapunovCandidate<V> for PortEnergy {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        sample.work.sum()
    }
}

/// Candidate given as the energy `V(position, velocity)` of the side that moves the port, summed by its differences.
///
/// `−ΔV = V(n−1) − V(n)`, which telescopes: the observed energy is `V(start) − V(n)` whatever the period,
/// where a sum of `V̇ T` (the paper's equation 6) gathers a quadrature error on every tick.
///
/// The side is a hand or a robot: when its `V` falls, the port absorbed. It is the other side of [`PortEnergy`], which
/// counts what the environment stores as positive; the energy of a virtual spring at the port therefore goes in with a
/// minus sign. Where `V` or the sample's work is not finite, the decrease is NaN and the last finite value is kept, so that the next
/// finite one spans the gap; in a sum of terms only this term does so. The first finite value, where the one at the start is
/// not, decreases by 0.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortSample, LyapunovCandidate, StorageFunction};
/// // A hand of 0.3 kg with a spring of 50 N/m.
/// let energy = |x: f64, v: f64| 0.5 * (0.3 * v * v + 50.0 * x * x);
/// let mut candidate = StorageFunction::starting(energy, 0.1, 0.0);
/// let sample = HeldTick { period: 1e-3, position: 0.0, velocity: 0.0, displacement: -0.1, applied: 0.0 }.sample();
/// assert_abs_diff_eq!(candidate.decrease(&sample), 0.25, epsilon = 1e-12);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct StorageFunction<F, T> {
    function: F,
    last: T,
}

impl<F, T: Scalar> StorageFunction<F, T> {
    /// The candidate `function`, counted from the state in which the loop starts.
    pub fn starting<V: Signal<Scalar = T>>(function: F, position: V, velocity: V) -> Self
    where
        F: Fn(V, V) -> T,
    {
        let last = function(position, velocity);
        // A function may hide a NaN, as the larger of two numbers does.
        let known = position.finite() & velocity.finite() & last.finite();
        Self { last: T::choose(known, last, T::of(f64::NAN)), function }
    }
}

impl<V, F> LyapunovCandidate<V> for StorageFunction<F, V::Scalar>
where
    V: Signal,
    F: Fn(V, V) -> V::Scalar,
{
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let now = (self.function)(sample.position, sample.velocity);
        // A missed reading, whose work is NaN, stands still at the last position: no state that the side was in.
        let now = V::Scalar::choose(sample.work.finite(), now, V::Scalar::of(f64::NAN));
        let decrease = V::Scalar::choose(self.last.finite(), self.last, now) - now;
        self.last = V::Scalar::choose(now.finite(), now, self.last);
        decrease
    }
}

impl<F, T: Scalar> Snapshot for StorageFunction<F, T> {
    type State = T;

    fn state(&self) -> T {
        self.last
    }

    fn restored(self, last: T) -> Result<Self, ParameterError> {
        Ok(Self { last: Requirement::Finite.check_known("stored energy", last)?, ..self })
    }
}
