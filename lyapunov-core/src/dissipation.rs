//! Dissipation credit: the energy that a damper must have dissipated, as a term of a candidate.

use crate::{LyapunovCandidate, Mask, ParameterError, PortSample, Requirement, Scalar, Signal};

/// Condition under which a term counts.
///
/// ```
/// use lyapunov_core::{Gate, InContact, PortSample, Scalar};
/// /// Open beyond the surface, and only inwards.
/// struct Pressing(InContact<f64>);
/// impl Gate<f64> for Pressing {
///     fn open(&self, sample: &PortSample<f64>) -> bool {
///         self.0.open(sample) & sample.velocity.above(0.0)
///     }
/// }
/// let gate = Pressing(InContact { position: 0.0 });
/// assert!(!gate.open(&PortSample::starting(1e-3, 0.01, -0.1)));
/// ```
pub trait Gate<V: Signal> {
    /// Whether the term counts for this sample, lane by lane.
    fn open(&self, sample: &PortSample<V>) -> <V::Scalar as Scalar>::Mask;
}

/// Gate that is always open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Always;

impl<V: Signal> Gate<V> for Always {
    #[inline(always)]
    fn open(&self, _sample: &PortSample<V>) -> <V::Scalar as Scalar>::Mask {
        Mask::of(true)
    }
}

/// Gate that is open strictly beyond a surface: in contact with a one-sided wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InContact<T> {
    /// Position of the surface, m.
    pub position: T,
}

impl<T: Scalar> Gate<T> for InContact<T> {
    #[inline(always)]
    fn open(&self, sample: &PortSample<T>) -> T::Mask {
        sample.position.above(self.position)
    }
}

/// Credit of a damper `b`: `b v² T` joules while its gate is open.
///
/// Gated by contact and given the wall's own damping it is step 4 of the paper's example 2 (which prints `b v̇²`
/// where its derivation has `b v²`). Such a credit is no decrease of an energy and may be larger than what the damper
/// physically dissipates; then a positive observed energy does not mean a stable loop. Always open and given the
/// device's own viscous damping it is sound: over one tick `b ∫ v² dt ≥ b Δx² / T`, so with backward-difference
/// velocity and no encoder the credit is a lower bound of what was really dissipated.
///
/// A velocity that is not finite credits nothing. The work of that tick did happen and is booked without the credit;
/// a credit of NaN would erase a debt.
///
/// ```
/// use lyapunov_core::{Dissipation, InContact, LyapunovCandidate, PortSample};
/// let mut device = Dissipation::of(0.5)?; // N·s/m
/// let mut wall = Dissipation::of(0.5)?.gated(InContact { position: 0.0 });
/// let outside = PortSample::starting(1e-3, -0.01, 0.2);
/// assert_eq!((device.decrease(&outside), wall.decrease(&outside)), (0.5 * 0.2 * 0.2 * 1e-3, 0.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dissipation<T, G = Always> {
    damping: T,
    gate: G,
}

impl<T: Scalar> Dissipation<T> {
    /// The credit of a damper that always acts, of `damping` N·s/m.
    ///
    /// # Errors
    /// `damping` below 0, infinite or NaN.
    pub fn of(damping: T) -> Result<Self, ParameterError> {
        Ok(Self { damping: Requirement::NonNegative.check("damping", damping)?, gate: Always })
    }
}

impl<T: Copy, G> Dissipation<T, G> {
    /// The credited damping, N·s/m.
    pub fn damping(&self) -> T {
        self.damping
    }

    /// The same credit, counted only while `gate` is open.
    #[must_use]
    pub fn gated<H>(self, gate: H) -> Dissipation<T, H> {
        Dissipation { damping: self.damping, gate }
    }
}

impl<V: Signal, G: Gate<V>> LyapunovCandidate<V> for Dissipation<V::Scalar, G> {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let burnt = self.damping * (sample.velocity.inner(sample.velocity) * sample.period);
        V::Scalar::choose(self.gate.open(sample) & burnt.finite(), burnt, Scalar::of(0.0))
    }
}
