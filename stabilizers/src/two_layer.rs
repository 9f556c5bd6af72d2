//! Two-layer architecture: a layer of energy below a layer of performance.

use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Requirement, Scalar, Signal,
    Snapshot, Stabilizer,
};

use crate::account::account_in_sum;
use crate::limiting::payable;
use crate::{LimitCredit, StabilizerExt};

/// Energy that an end of a two-layer teleoperator keeps and shares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sharing<T> {
    /// Energy in its tank at the start, J.
    pub start: T,
    /// The share of its tank that it sends on each tick, in 0…1.
    pub share: T,
}

/// One end of the two-layer architecture, after Franken, Stramigioli, Misra, Secchi and Macchelli (IEEE Transactions on
/// Robotics 27(4), 2011): whatever force is wished for above, only what is in this end's tank is given.
///
/// ```text
/// H += received + F(n−1) · Δx;     packet = share · max(H, 0);     H −= packet
/// |F_wished| ≤ max(H, 0) / (|v| T);     master only:  F += d v,  d = gain · max(0, level − H)
/// ```
///
/// `H` in J is the observed energy, `F` the force against the motion as everywhere. Both ends exert forces; the
/// master's damper `d` fills the tanks from the hand, and everything is paid by it.
///
/// **Guarantee** (equations derived here; the paper's own text was not at hand): both tanks and what is under way never
/// hold more than the hands put in. `H ≥ 0` up to one tick's wrong guess of the displacement, which is reported as
/// shortfall. **Assumed** are true measurements and a velocity that predicts the next displacement. The paper sends
/// packets; here the [sum](Self::sent) of them is sent, so that a message that is lost, old or repeated cannot make
/// energy, and one that comes later makes up for a loss. The sum grows as long as there is anything to share, and where
/// it has no more digits for a packet none is sent: in `f32` that is after a while, so take `f64`.
///
/// Parameters of a public course: level 1 J, gain 2 (N·s/m)/J, share 0.1, 0.5 to 5 J at the start, at 1 kHz with 10
/// ticks of delay. Choose `gain · level` well below the mass over the period, as for any held damper.
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, Stabilizer};
/// use lyapunov_stabilizers::{Sharing, TwoLayer};
/// let sharing = Sharing { start: 0.5e-3, share: 0.1 };
/// let (mut master, mut slave) = (TwoLayer::master(sharing, 1e-3, 2000.0)?, TwoLayer::slave(sharing)?);
/// // absorbs 0.1 mJ
/// let pushed = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: 1.0 }.sample();
/// let correction = master.stabilize(&pushed, 2.0);
/// slave.receive(master.sent()); // a tenth of 0.6 mJ
/// let sum: f64 = slave.stabilize(&PortSample::starting(1e-3, 0.0, 0.0), 0.0).observed_energy;
/// assert!((sum - 0.9 * 0.56e-3).abs() < 1e-12 && correction.alpha > 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TwoLayer<T, A = Plain<T>> {
    tank: A,
    share: T,
    level: T,
    gain: T,
    received: T,
    booked: T,
    sent: T,
}

impl<T: Scalar> TwoLayer<T> {
    /// The end without a damper.
    ///
    /// # Errors
    /// `start` below 0, infinite or NaN; `share` below 0, above 1 or NaN.
    pub fn slave(sharing: Sharing<T>) -> Result<Self, ParameterError> {
        Self::master(sharing, T::of(0.0), T::of(0.0))
    }

    /// The end that fills its tank up to `level` J by a damper of `gain` (N·s/m) for each joule that is missing.
    ///
    /// # Errors
    /// As [`slave`](Self::slave); `level` or `gain` below 0, infinite or NaN.
    pub fn master(sharing: Sharing<T>, level: T, gain: T) -> Result<Self, ParameterError> {
        let start = Requirement::NonNegative.check("tank start", sharing.start)?;
        let share = shared(sharing.share)?;
        let level = Requirement::NonNegative.check("tank level", level)?;
        let gain = Requirement::NonNegative.check("tank gain", gain)?;
        let (mut tank, zero) = (Plain::zero(), T::of(0.0));
        tank.add(start);
        Ok(Self { tank, share, level, gain, received: zero, booked: zero, sent: zero })
    }
}

impl<T: Scalar, A: Accumulator<T>> TwoLayer<T, A> {
    /// The same end with the energy of its tank summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> TwoLayer<T, B> {
        let Self { tank, share, level, gain, received, booked, sent } = self;
        TwoLayer { tank: B::holding(tank.value()), share, level, gain, received, booked, sent }
    }

    /// Takes the other end's [`sent`](Self::sent) energy, J; to be called before a tick.
    #[inline]
    pub fn receive(&mut self, energy: T) {
        let newer = energy.above(self.received) & energy.finite();
        self.received = T::choose(newer, energy, self.received);
    }

    /// The sum of the packets up to now, J: to be sent to the other end.
    #[inline]
    pub fn sent(&self) -> T {
        self.sent
    }
}

impl<T, A> StabilizerExt for TwoLayer<T, A> {}

impl<T: Scalar, A: Accumulator<T>> LimitCredit<T> for TwoLayer<T, A> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        self.tank.lower(most);
    }
}

impl<V: Signal, A: Accumulator<V::Scalar>> Stabilizer<V> for TwoLayer<V::Scalar, A> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let came = self.received - self.booked;
        let booked = self.tank.book(came + sample.work.sum());
        self.booked = V::Scalar::choose(booked, self.received, self.booked);
        // What the sum of the packets rounds to leaves the tank, or rounding would make energy on every tick.
        let sent = self.sent + self.share * self.tank.value().larger(zero);
        // At the end of the scalar's range nothing more is sent.
        let sent = V::Scalar::choose(sent.finite(), sent, self.sent);
        self.tank.add(self.sent - sent);
        self.sent = sent;
        let sum = self.tank.value();

        let speed = sample.velocity.inner(sample.velocity).sqrt();
        let size = effort.inner(effort).sqrt();
        let asked = size * speed * sample.period;
        let most = payable(sum);
        let factor = V::Scalar::choose(asked.above(most), most / asked, one);
        let factor = V::Scalar::choose(most.above(zero), factor, zero);
        // Finite, so that at rest it is no force.
        let damping = (self.gain * (self.level - sum).larger(zero)).smaller(V::Scalar::largest());
        let felt = effort.scale(factor) + sample.velocity.scale(damping);
        let accepted = booked & asked.finite() & felt.finite() & sample.timed();
        let alpha = V::Scalar::choose(accepted, damping, zero);
        let effort = V::choose(accepted, felt, V::zero());
        Correction { effort, observed_energy: sum, alpha, shortfall: (-sum).larger(zero), accepted }
    }
}

account_in_sum!(impl[T: Scalar, A: Accumulator<T>] TwoLayer<T, A>, in T, is tank);

impl<T: Scalar, A> TwoLayer<T, A> {
    /// The part of the tank's energy that is sent on each tick.
    pub fn share(&self) -> T {
        self.share
    }

    /// Changes the part that is sent, between ticks; the tank stays.
    ///
    /// # Errors
    /// `share` below 0, above 1 or NaN; the old one stays.
    pub fn set_share(&mut self, share: T) -> Result<(), ParameterError> {
        self.share = shared(share)?;
        Ok(())
    }

    /// The level, J, below which the damper of a master fills the tank, and its gain, N·s/(m·J).
    pub fn filling(&self) -> (T, T) {
        (self.level, self.gain)
    }

    /// Changes level and gain between ticks, as in [`master`](TwoLayer::master).
    ///
    /// # Errors
    /// Either below 0, infinite or NaN; the old ones stay.
    pub fn set_filling(&mut self, level: T, gain: T) -> Result<(), ParameterError> {
        let level = Requirement::NonNegative.check("tank level", level)?;
        self.gain = Requirement::NonNegative.check("tank gain", gain)?;
        self.level = level;
        Ok(())
    }
}

fn shared<T: Scalar>(share: T) -> Result<T, ParameterError> {
    let share = Requirement::NonNegative.check("shared part", share)?;
    Requirement::AtMost(1.0).check("shared part", share)
}

impl<T: Scalar, A: Snapshot> Snapshot for TwoLayer<T, A> {
    /// The tank, and the energies received, booked and sent, J.
    type State = (A::State, T, T, T);

    fn state(&self) -> Self::State {
        (self.tank.state(), self.received, self.booked, self.sent)
    }

    fn restored(self, (tank, received, booked, sent): Self::State) -> Result<Self, ParameterError> {
        for energy in [received, booked, sent] {
            Requirement::NonNegative.check("stored exchange", energy)?;
        }
        Ok(Self { tank: self.tank.restored(tank)?, received, booked, sent, ..self })
    }
}
