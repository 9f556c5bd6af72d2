//! Port sample: motion, applied effort and work at a port since the last call.

use crate::{Scalar, Signal};

/// Sample at a port: what its other side did since the last call, and the effort that was really applied meanwhile.
///
/// Only the program that owns the motors and closes the loop knows what was measured and which force was really
/// applied, after saturation, delay or an emergency stop. A sample carries those facts to every part of the loop, so
/// that no part has to assume what became of its output.
///
/// A port carries an effort (N) and a flow (m/s); power `effort · flow > 0` flows into the environment.
/// Over one period under one held effort the work is `applied · displacement` exactly, axis by axis
/// ([`HeldTick`]). Over several periods it is the sum of theirs ([`PortSample::spanning`]), which is why it
/// is a field: a round trip displaces nothing and still does work.
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
pub struct PortSample<V: Signal> {
    /// Time since the last call, s: above 0 and finite. A sample with another period is rejected
    /// ([`timed`](Self::timed)).
    pub period: V::Scalar,
    /// Position now, m.
    pub position: V,
    /// Velocity now, m/s: the best available estimate.
    pub velocity: V,
    /// Displacement since the last call, m.
    pub displacement: V,
    /// The effort applied last, N.
    pub applied: V,
    /// Work of the applied efforts since the last call, on each axis, J.
    pub work: V,
}

/// The sample of no time at all: all numbers are 0. Joined to another one it changes nothing.
impl<V: Signal> Default for PortSample<V> {
    fn default() -> Self {
        Self::starting(V::Scalar::of(0.0), V::zero(), V::zero())
    }
}

/// One period under one held effort, of which [`sample`](Self::sample) makes a [`PortSample`] with its work.
///
/// Five numbers of one type: they are given by name.
///
/// ```
/// use lyapunov_core::HeldTick;
/// let tick = HeldTick { period: 1e-3, position: 0.5, velocity: 0.25, displacement: 0.25, applied: -2.0 };
/// assert_eq!(tick.sample().work, -0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldTick<V: Signal> {
    /// The period, s.
    pub period: V::Scalar,
    /// Position at its end, m.
    pub position: V,
    /// Velocity at its end, m/s.
    pub velocity: V,
    /// Displacement over it, m.
    pub displacement: V,
    /// The effort held over it, N.
    pub applied: V,
}

impl<V: Signal> HeldTick<V> {
    /// Its sample: `work = applied · displacement`.
    #[inline(always)]
    pub fn sample(self) -> PortSample<V> {
        let Self { period, position, velocity, displacement, applied } = self;
        let work = applied.times(displacement);
        PortSample { period, position, velocity, displacement, applied, work }
    }
}

impl<V: Signal> PortSample<V> {
    /// The sample of the first tick: nothing has moved and no effort was applied yet.
    #[inline(always)]
    pub fn starting(period: V::Scalar, position: V, velocity: V) -> Self {
        HeldTick { period, position, velocity, displacement: V::zero(), applied: V::zero() }
            .sample()
    }

    /// This sample joined to the `earlier` one: periods, displacements and works of both, the rest from this one.
    #[inline(always)]
    #[must_use]
    pub fn spanning(self, earlier: &Self) -> Self {
        Self {
            period: earlier.period + self.period,
            displacement: earlier.displacement + self.displacement,
            work: earlier.work + self.work,
            ..self
        }
    }

    /// The sample over `period` s whose other numbers `of` makes of those of this one: that of an axis, or of a lane.
    ///
    /// ```
    /// use lyapunov_core::PortSample;
    /// use nalgebra::Vector2;
    /// let both = PortSample::starting(1e-3, Vector2::new(0.1, 0.2), Vector2::zeros());
    /// assert_eq!(both.map(both.period, |axes| axes[1]), PortSample::starting(1e-3, 0.2, 0.0));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn map<W: Signal>(&self, period: W::Scalar, of: impl Fn(V) -> W) -> PortSample<W> {
        PortSample {
            period,
            position: of(self.position),
            velocity: of(self.velocity),
            displacement: of(self.displacement),
            applied: of(self.applied),
            work: of(self.work),
        }
    }

    /// Whether the period is a time, above 0 and finite, lane by lane.
    ///
    /// The contract of time: a clock that stands, steps back or fails tells no period, and nothing that is per time, a
    /// power or the dissipation of a damper, is known. Every stabilizer, guard and law treats such a sample as one with
    /// a NaN: it is rejected, its work is booked if the account does not need the period, and no credit is.
    ///
    /// ```
    /// use lyapunov_core::PortSample;
    /// for period in [-1e-3, -0.0, 0.0, f64::NAN, f64::INFINITY] {
    ///     assert!(!PortSample::<f64>::starting(period, 0.01, 0.0).timed());
    /// }
    /// ```
    #[inline(always)]
    pub fn timed(&self) -> <V::Scalar as Scalar>::Mask {
        self.period.above(V::Scalar::of(0.0)) & self.period.finite()
    }

    /// Whether the sample can be used: every field is finite, and the period is a [time](Self::timed), lane by lane.
    #[inline(always)]
    pub fn sound(&self) -> <V::Scalar as Scalar>::Mask {
        self.finite() & self.timed()
    }

    /// Whether every field is finite, lane by lane.
    #[inline(always)]
    pub fn finite(&self) -> <V::Scalar as Scalar>::Mask {
        self.period.finite()
            & self.position.finite()
            & self.velocity.finite()
            & self.displacement.finite()
            & self.applied.finite()
            & self.work.finite()
    }
}
