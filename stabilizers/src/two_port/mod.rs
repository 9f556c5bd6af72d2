//! Two loops joined by a channel.

mod drift;
mod one_way;

pub use drift::DriftCompensated;

use lyapunov_core::{Accumulator, Correction, Held, Plain, PortSample, Scalar, Signal, Stabilizer};

use crate::{DampingLimit, LimitCredit, Lolc, StabilizerExt};
use one_way::OneWay;

/// One side of a two-port passivity controller for teleoperation over a channel with delay.
///
/// Neither side knows in time what crosses the other port, so their energies must not be added up. Each side splits
/// its own by direction, `in(n) = Σ max(f_act Δx, 0)` and `out(n) = Σ max(−f_act Δx, 0)`, sends `in` along with its
/// signals, and may give only what it has been told that the other absorbed: `L(n) = received(n) − out(n)`. The sums never
/// fall, so a late, old or lost message tells too little and never too much: whatever the channel does,
/// `in₁ + in₂ − out₁ − out₂ ≥ L₁ + L₂`. A debt is served as in [`Lolc`], with the same limit and the same shortfall. (Ryu,
/// Artigas and Preusche, Mechatronics 20(7), 2010, split the energies and compare them so; Artigas, Ryu and
/// Preusche, IROS 2010, treat architectures with delay.)
///
/// At the master motion comes in and a force goes out, and a sample is a sample. At the slave a force comes in and a
/// velocity goes out to its controller: give it a [`AdmittanceSample`](lyapunov_core::AdmittanceSample), and it adds a velocity, which leaves a
/// position error behind; [`DriftCompensated`] takes it back. Energies that only grow need digits: in `f32` they stop
/// growing after a while, which is safe and useless, so take `f64`.
///
/// ```
/// use lyapunov_core::{PortSample, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, TwoPortSide};
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?;
/// let (mut master, mut slave) = (TwoPortSide::new(limit), TwoPortSide::new(limit));
/// let pushed = PortSample::new(1e-3, 0.0, 0.1, 1e-4, 3.0); // absorbs 0.3 mJ
/// let pushes = PortSample::new(1e-3, 0.0, -0.1, -1e-4, 2.0); // gives 0.2 mJ
/// master.stabilize(&pushed, 3.0);
/// assert!({ slave }.stabilize(&pushes, 2.0).alpha > 0.0); // not told yet: a debt
/// slave.receive(master.absorbed());
/// assert_eq!(slave.stabilize(&pushes, 2.0).alpha, 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TwoPortSide<T, A = Plain<T>> {
    controller: Lolc<T, OneWay<T>, Held, A>,
}

impl<T: Scalar> TwoPortSide<T> {
    /// A side that injects at most `limit`, and has absorbed and received nothing yet.
    pub fn new(limit: DampingLimit<T>) -> Self {
        Self { controller: Lolc::new(OneWay::new(), limit) }
    }
}

impl<T: Scalar, A: Accumulator<T>> TwoPortSide<T, A> {
    /// The same side with its energies summed in a `B`.
    pub fn summed_in<B: Accumulator<T>>(self) -> TwoPortSide<T, B> {
        TwoPortSide { controller: self.controller.summed_in() }
    }

    /// Receives the [`absorbed`](Self::absorbed) energy that the other side reports, J; to be called before a tick.
    #[inline]
    pub fn receive(&mut self, energy: T) {
        self.controller.candidate_mut().receive(energy);
    }

    /// Energy that this port has absorbed up to now, J: to be sent to the other side.
    #[inline]
    pub fn absorbed(&self) -> T {
        self.controller.candidate().absorbed()
    }
}

impl<T, A> StabilizerExt for TwoPortSide<T, A> {}

impl<T: Scalar, A: Accumulator<T>> LimitCredit<T> for TwoPortSide<T, A> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        self.controller.limit_credit(most);
    }
}

impl<V: Signal, A: Accumulator<V::Scalar>> Stabilizer<V> for TwoPortSide<V::Scalar, A> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.controller.stabilize(sample, effort)
    }
}
