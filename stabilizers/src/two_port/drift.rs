//! Drift compensation of an admittance port.

use lyapunov_core::{
    Accumulator, Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
    Stabilizer,
};

use super::TwoPortSide;
use super::booking::{Booking, Spending};
use crate::account::lends;

/// Stabilizer of an admittance port that compensates the position drift of its corrections.
///
/// The drift is the sum of the corrections, `δ(n) = Σ (v_out − v) T`. On each tick the velocity `u = −δ / T`, at
/// most `speed` on each axis, is added, as far as there is energy for it: what it gives away over the next period,
/// `(−u · f + z |u| (|v_out| + |u|)) T`, may be the credit `C` at most; of a `u` that would give more, the share `C` over
/// that energy is added, and where there is no credit only what absorbs. The impedance `z` is [what the port
/// meets](Self::meeting): a force that answers a velocity within the period gives energy that the last force does not
/// show, and without it compensation makes debts. A speed of 0 changes no bit.
///
/// ```text
/// C = max(0, L)                            sampled work, in which L has the power of v_out already
/// C = max(0, L + min(0, v_out · f) T)      held work: v_out draws on L over the same period, and pays in after it
/// ```
///
/// What it gives is booked, or the same surplus would be spent on every tick: a held account reads it in the next
/// sample, a [sampled](TwoPortSide::sampled) one at once. So the account does not fall below 0 by compensation while
/// the force is as measured: with `z = 0`, the force of the sample over the period that follows.
///
/// With `z = 0` and sampled work this is the compensation of Artigas, Ryu and Preusche (IEEE/RSJ International Conference on Intelligent
/// Robots and Systems, 2010) and of Chawda, Ly Van Quang, O'Malley and Ryu (IEEE Haptics Symposium, 2014), as in public
/// code that implements it; the answer `z` and the credit of held work are derived here.
///
/// The sample is an [`AdmittanceSample`](lyapunov_core::AdmittanceSample): `velocity` is the force, the effort in and
/// out are flows. The reported correction is the stabilizer's alone.
#[derive(Clone, Copy, Debug)]
pub struct DriftCompensated<S, V: Signal> {
    stabilizer: S,
    speed: V::Scalar,
    impedance: V::Scalar,
    drift: V,
}

impl<S, V: Signal> DriftCompensated<S, V> {
    /// `stabilizer` with drift compensated at most at `speed` m/s, against a force that stays the same within a period.
    ///
    /// # Errors
    /// `speed` below 0 or NaN.
    pub fn new(stabilizer: S, speed: V::Scalar) -> Result<Self, ParameterError> {
        let zero = V::Scalar::of(0.0);
        let mut compensated = Self { stabilizer, speed: zero, impedance: zero, drift: V::zero() };
        compensated.set_speed(speed)?;
        Ok(compensated)
    }

    /// The same against a force that answers a velocity by as much as `impedance` N·s/m within a period: `b + k T` of a
    /// damper and a spring.
    ///
    /// # Errors
    /// `impedance` below 0, infinite or NaN.
    pub fn meeting(self, impedance: V::Scalar) -> Result<Self, ParameterError> {
        let mut meeting = self;
        meeting.set_impedance(impedance)?;
        Ok(meeting)
    }

    /// Displacement of the port from its position without corrections, m; a rejected tick, whose flow is 0, is none of it.
    pub fn drift(&self) -> V {
        self.drift
    }
}

impl<V, W, A> DriftCompensated<TwoPortSide<V, W, A>, V>
where
    V: Signal,
    W: Booking,
    A: Accumulator<V::Scalar>,
{
    /// As [`TwoPortSide::receive`].
    #[inline]
    pub fn receive(&mut self, energy: V::Scalar) {
        self.stabilizer.receive(energy);
    }

    /// As [`TwoPortSide::absorbed`].
    #[inline]
    pub fn absorbed(&self) -> V::Scalar {
        self.stabilizer.absorbed()
    }
}

impl<V, S> Stabilizer<V> for DriftCompensated<S, V>
where
    V: Signal,
    S: Stabilizer<V> + Spending<V::Scalar>,
{
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let correction = self.stabilizer.stabilize(sample, effort);
        let back = self.drift.map(|drift| -drift / sample.period).limited(self.speed);
        let sizes = back.map(Scalar::magnitude);
        let answer = sizes.inner(correction.effort.map(Scalar::magnitude) + sizes) * self.impedance;
        let draw = (answer - back.inner(sample.velocity)) * sample.period;
        let due = S::due(correction.effort.inner(sample.velocity) * sample.period);
        let credit = (correction.observed_energy + due.smaller(zero)).larger(zero);
        let share = V::Scalar::choose(draw.above(credit), credit / draw, one);
        let some = sizes.sum().above(zero);
        let moved = correction.effort + back.scale(share);
        let flow = V::choose(some & correction.accepted & moved.finite(), moved, correction.effort);
        let spent = (correction.effort - flow).inner(sample.velocity) * sample.period;
        self.stabilizer.spend(spent);
        let drift = self.drift + (flow - effort).scale(sample.period);
        self.drift = V::choose(correction.accepted & drift.finite(), drift, self.drift);
        Correction { effort: flow, ..correction }.checked()
    }
}

lends!(impl[S, V: Signal] DriftCompensated<S, V>, of S, in V::Scalar);

impl<S, V: Signal> DriftCompensated<S, V> {
    /// The largest speed of the compensation on each axis, m/s.
    pub fn speed(&self) -> V::Scalar {
        self.speed
    }

    /// Changes that speed between ticks; the drift so far stays, and is paid from the same account.
    ///
    /// # Errors
    /// `speed` below 0 or NaN; the old one stays.
    pub fn set_speed(&mut self, speed: V::Scalar) -> Result<(), ParameterError> {
        self.speed = Requirement::Limit.check("compensation speed", speed)?;
        Ok(())
    }

    /// The impedance that the compensation meets, N·s/m.
    pub fn impedance(&self) -> V::Scalar {
        self.impedance
    }

    /// Changes that impedance between ticks: a larger one counts more of the account for the same compensation.
    ///
    /// # Errors
    /// `impedance` below 0, infinite or NaN; the old one stays.
    pub fn set_impedance(&mut self, impedance: V::Scalar) -> Result<(), ParameterError> {
        self.impedance = Requirement::NonNegative.check("impedance", impedance)?;
        Ok(())
    }
}

impl<S: Snapshot, V: Signal> Snapshot for DriftCompensated<S, V> {
    /// The memory of the stabilizer inside, and the drift, m.
    type State = (S::State, V);

    fn state(&self) -> Self::State {
        (self.stabilizer.state(), self.drift)
    }

    fn restored(self, (inside, drift): Self::State) -> Result<Self, ParameterError> {
        let drift = Requirement::Finite.check_axes("stored drift", drift)?;
        Ok(Self { stabilizer: self.stabilizer.restored(inside)?, drift, ..self })
    }
}
