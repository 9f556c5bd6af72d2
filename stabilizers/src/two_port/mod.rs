//! Two-port control: two loops joined by a channel.

mod booking;
mod drift;
mod one_way;

pub use drift::DriftCompensated;

use lyapunov_core::{
    Accumulator, Correction, Held, ParameterError, Plain, PortSample, Sampled, Signal, Snapshot,
    Stabilizer, Work,
};

use crate::account::account;
use crate::credit::limits_credit;
use crate::{DampingLimit, Lolc, StabilizerExt};
use booking::Booking;
use one_way::OneWay;

/// One side of the two-port time-domain passivity controller of Ryu, Artigas and Preusche, for teleoperation over a
/// channel with delay.
///
/// Neither side knows in time what crosses the other port, so their energies must not be added up. Each side splits
/// what the effort of its channel does before it is corrected, `p(n) = f_asked Δx`, by direction, keeps what the
/// correction does beside it, and sends `in` along with its signals:
///
/// ```text
/// in(n) = Σ max(p, 0),   out(n) = Σ max(−p, 0),   burnt(n) = Σ (f_act − f_asked) Δx
/// W(n) = in of the other side as received − out(n) + burnt(n)
/// ```
///
/// `W` is the observed energy, and where it is below 0 the debt is served as in [`Lolc`], with the same limit and the
/// same shortfall. What a side dissipates pays its own debt, once, and is not sent to the other side: that one may give
/// what came in, and nothing twice. A correction that pushes, as the damper of the last tick does where the motion
/// turns round, counts against its own side.
///
/// **Guarantee**: `in₁ + in₂ − out₁ − out₂ + burnt₁ + burnt₂ ≥ W₁ + W₂`, the left being the work of both ports, for any
/// delay, jitter or loss: the sums that are sent never fall, so a late, old or lost message reports too little and
/// never too much. **Assumed** is only that both report the truth. And `W` of a side, what the tick's correction is
/// about to dissipate, `α v² T`, and the shortfall sum to 0 at least. This is no bound of the work: where the motion
/// turns round, the correction pushes instead, and a port whose hand turns on every tick gives away twice as much from
/// tick to tick.
///
/// The paper (Mechatronics 20(7), 2010) books sampled power, and so does [`sampled`](Self::sampled), as in public code
/// that implements it; the held account above is derived here from the same split.
///
/// At the master motion comes in and a force goes out, and a sample is a sample. At the slave a force comes in and a
/// velocity goes out to its controller: give it an [`AdmittanceSample`](lyapunov_core::AdmittanceSample), and it adds a
/// velocity, which leaves a position error behind; [`DriftCompensated`] takes it back. Energies that only grow need
/// digits: what the sum of a side rounds off is not told and stays in its own `W`, so that in `f32` after a while nothing crosses
/// any more, which is safe and useless: take `f64`.
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, TwoPortSide};
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?;
/// let (mut master, mut slave) = (TwoPortSide::new(limit), TwoPortSide::new(limit));
/// master.stabilize(&PortSample::starting(1e-3, 0.0, 0.1), 3.0);
/// // absorbs 0.3 mJ
/// master.stabilize(&HeldTick {
///     period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied: 3.0
/// }.sample(), 3.0);
/// slave.stabilize(&PortSample::starting(1e-3, 0.0, -0.1), 2.0);
/// // gives 0.2 mJ
/// let pushes = HeldTick { period: 1e-3, position: 0.0, velocity: -0.1, displacement: -1e-4, applied: 2.0 }.sample();
/// assert!({ slave }.stabilize(&pushes, 2.0).alpha > 0.0); // not received yet: a debt
/// slave.receive(master.absorbed());
/// assert_eq!(slave.stabilize(&pushes, 2.0).alpha, 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TwoPortSide<V: Signal, W = Held, A = Plain<<V as Signal>::Scalar>> {
    controller: Lolc<V::Scalar, OneWay<V>, W, A>,
}

impl<V: Signal> TwoPortSide<V> {
    /// A side that injects at most `limit`, and has absorbed and received nothing yet.
    pub fn new(limit: DampingLimit<V::Scalar>) -> Self {
        Self { controller: Lolc::new(OneWay::new(), limit) }
    }
}

impl<V: Signal, W: Work, A: Accumulator<V::Scalar>> TwoPortSide<V, W, A> {
    /// The same side over the published, sampled work, `p(n) = f v T`, whose correction is taken to dissipate `α v² T`
    /// at once.
    #[must_use]
    pub fn sampled(self) -> TwoPortSide<V, Sampled, A> {
        TwoPortSide { controller: self.controller.sampled() }
    }

    /// The same side with its account summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<V::Scalar>>(self) -> TwoPortSide<V, W, B> {
        TwoPortSide { controller: self.controller.summed_in() }
    }

    /// Takes the other side's [`absorbed`](Self::absorbed) energy, J; to be called before a tick.
    #[inline]
    pub fn receive(&mut self, energy: V::Scalar) {
        self.controller.candidate_mut().receive(energy);
    }

    /// Energy that came in at this port up to now, J, before any correction: to be sent to the other side.
    #[inline]
    pub fn absorbed(&self) -> V::Scalar {
        self.controller.candidate().absorbed()
    }
}

impl<V: Signal, W, A> TwoPortSide<V, W, A> {
    /// The largest damping.
    pub fn limit(&self) -> DampingLimit<V::Scalar> {
        self.controller.limit()
    }

    /// Changes the limit between ticks, as [`Lolc::set_limit`].
    pub fn set_limit(&mut self, limit: DampingLimit<V::Scalar>) {
        self.controller.set_limit(limit);
    }
}

impl<V: Signal, W, A> StabilizerExt for TwoPortSide<V, W, A> {}

limits_credit!(
    impl[V: Signal, W: Work, A: Accumulator<V::Scalar>] TwoPortSide<V, W, A>, in V::Scalar, of controller
);

impl<V: Signal, W: Booking, A: Accumulator<V::Scalar>> Stabilizer<V> for TwoPortSide<V, W, A> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        if W::AT_ONCE {
            self.controller.candidate_mut().ask(effort);
        }
        let correction = self.controller.stabilize(sample, effort);
        if !W::AT_ONCE {
            let asked = V::choose(correction.accepted, effort, V::zero());
            self.controller.candidate_mut().ask(asked);
        }
        correction
    }
}

account!(
    impl[V: Signal, W: Work, A: Accumulator<V::Scalar>] TwoPortSide<V, W, A>, in V::Scalar, is controller
);

impl<V: Signal, W: Work, A: Snapshot> Snapshot for TwoPortSide<V, W, A> {
    /// The energies received, booked and absorbed, J, the effort asked for, N, and the account.
    type State = ((V::Scalar, V::Scalar, V::Scalar, V), A::State);

    fn state(&self) -> Self::State {
        self.controller.state()
    }

    fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
        Ok(Self { controller: self.controller.restored(state)? })
    }
}
