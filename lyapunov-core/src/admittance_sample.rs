//! Admittance sample: a sample where force comes in and motion goes out.

use crate::{PortSample, Scalar, Signal};

/// Sample at an admittance port, where effort comes in and motion goes out: the dual of a [`PortSample`].
///
/// An admittance device measures a force and follows a commanded motion. Over one period under one held flow `v` the
/// work is `v · ∫ f dt`; under a held effort it is `f · ∫ v dt`. Effort and flow change places, and the impulse takes
/// the place of the displacement. Nothing else differs, so every [`Stabilizer`] and every adaptor of a port works on
/// admittance samples too. Only the names of the fields, and the unit of the damping, are read the other way round;
/// `PortSample::from` does that:
///
/// | `PortSample` | `AdmittanceSample` |
/// |---|---|
/// | `velocity`, m/s | `effort`, N: the force measured now, positive where it moves the port into the environment |
/// | `displacement`, m | `impulse`, N·s |
/// | `position`, m | `momentum`, N·s: the sum of the impulses |
/// | `applied`, N | `flow`, m/s: the velocity that was really applied |
/// | damping `α`, N·s/m | mobility `β`, m/(N·s): the controller adds the velocity `β f` |
///
/// [`Stabilizer`]: crate::Stabilizer
///
/// ```
/// use lyapunov_core::{PortSample, HeldFlow, AdmittanceSample};
/// // −2 N over 1 ms while it moves with 0.1 m/s
/// let load = HeldFlow { period: 1e-3, momentum: 0.0, effort: -2.0, impulse: -2e-3, flow: 0.1 }.sample();
/// assert_eq!(PortSample::from(load).work, -2e-4); // the port gave 0.2 mJ away
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "V: serde::Serialize, V::Scalar: serde::Serialize",
        deserialize = "V: serde::Deserialize<'de>, V::Scalar: serde::Deserialize<'de>"
    ))
)]
pub struct AdmittanceSample<V: Signal> {
    /// Time since the last call, s.
    pub period: V::Scalar,
    /// The sum of the impulses, N·s.
    pub momentum: V,
    /// The effort now, N: the best available estimate.
    pub effort: V,
    /// The impulse of the effort since the last call, N·s.
    pub impulse: V,
    /// The flow applied last, m/s.
    pub flow: V,
    /// Work that crossed the port since the last call, on each axis, J.
    pub work: V,
}

/// The sample of no time at all: all numbers are 0.
impl<V: Signal> Default for AdmittanceSample<V> {
    fn default() -> Self {
        Self::starting(V::Scalar::of(0.0), V::zero())
    }
}

/// One period under one held flow, of which [`sample`](Self::sample) makes an [`AdmittanceSample`] with its work.
///
/// ```
/// use lyapunov_core::HeldFlow;
/// let tick = HeldFlow { period: 1e-3, momentum: 0.0, effort: -2.0, impulse: -0.25, flow: 0.5 };
/// assert_eq!(tick.sample().work, -0.125);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldFlow<V: Signal> {
    /// The period, s.
    pub period: V::Scalar,
    /// The sum of the impulses at its end, N·s.
    pub momentum: V,
    /// The effort at its end, N.
    pub effort: V,
    /// The impulse of the effort over it, N·s.
    pub impulse: V,
    /// The flow held over it, m/s.
    pub flow: V,
}

impl<V: Signal> HeldFlow<V> {
    /// Its sample: `work = flow · impulse`.
    #[inline]
    pub fn sample(self) -> AdmittanceSample<V> {
        let Self { period, momentum, effort, impulse, flow } = self;
        AdmittanceSample { period, momentum, effort, impulse, flow, work: flow.times(impulse) }
    }
}

impl<V: Signal> AdmittanceSample<V> {
    /// The sample of the first tick: nothing was applied yet.
    #[inline]
    pub fn starting(period: V::Scalar, effort: V) -> Self {
        let zero = V::zero();
        HeldFlow { period, momentum: zero, effort, impulse: zero, flow: zero }.sample()
    }
}

impl<V: Signal> From<AdmittanceSample<V>> for PortSample<V> {
    #[inline]
    fn from(load: AdmittanceSample<V>) -> Self {
        let AdmittanceSample { period, momentum, effort, impulse, flow, work } = load;
        Self {
            period,
            position: momentum,
            velocity: effort,
            displacement: impulse,
            applied: flow,
            work,
        }
    }
}
