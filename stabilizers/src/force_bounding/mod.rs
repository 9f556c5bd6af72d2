//! Force bounding: forces no larger than the device's own damper can pay for.

mod damping;
mod force_bound;
mod pipe;
mod reset;

pub use damping::{DampingMatrix, DeviceDamping, EveryAxis};
pub use force_bound::ForceBound;
pub use reset::{FreshContact, KeptCredit};

use core::marker::PhantomData;

use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Scalar, Signal, Snapshot,
    Stabilizer,
};
use nalgebra::{SMatrix, SVector};

use crate::account::{account_in_sum, booked};
use crate::limiting::limiting;
use crate::{LimitCredit, StabilizerExt};
use pipe::Pipe;
use reset::Reset;

/// The force-bounding approach, as in Kim, Baek and Ryu (IEEE/ASME Transactions on Mechatronics 20(3), 2015): a force
/// is bounded by what the device's damping has dissipated in this contact.
///
/// ```text
/// F(n−1) = 0:  E(n−1) = min(E(n−1), 0)
/// E(n) = E(n−1) + F(n−1) · Δx + Δxᵀ (D / T) Δx
/// |F(n)| ≤ √(4 E(n) / (uᵀ (D / T)⁻¹ u)),   u = f / |f|;      on one axis √(4 b E / T)
/// ```
///
/// `E` in J, `D` the damping in N·s/m, the direction of the effort is kept and nothing is added. (Equations as in a
/// public implementation of the law for several degrees of freedom.) Free motion buys nothing: a first touch at `v` is
/// bounded by `2 b |v|`.
///
/// **Guarantee**: port and damper together, `E`, are at least 0 for every motion, and where the force is at its bound
/// the displacement `Δx = −F T / (2 b)` leaves exactly 0; so no larger force would do, of what was dissipated since the
/// last tick without a force. **Assumed** are a viscous damping that is surely there, `b ∫ v² dt ≥ b Δx² / T`, and a
/// force that acts as it was given, over a next period that is no longer than this one.
///
/// A force that acts `d` ticks late is in the pipe, and what it may take, `F² T / (4 b)` at most, is set aside first
/// ([`delayed`](Self::delayed); derived here). Then the guarantee holds at any `d`. Without it `E` may fall below 0,
/// which is reported as shortfall.
///
/// It needs no velocity and adds no damping: it bounds a swing and need not end it.
///
/// ```
/// use lyapunov_core::{HeldTick, PortSample, Stabilizer};
/// use lyapunov_stabilizers::ForceBounding;
/// let mut bounding = ForceBounding::of_damping(0.5)?; // N·s/m
/// bounding.stabilize(&PortSample::starting(1e-3, 0.0, 0.1), 0.0);
/// let touched = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: 0.0 }.sample();
/// let effort: f64 = bounding.stabilize(&touched, 5.0).effort;
/// assert!((effort - 0.1).abs() < 1e-12); // 2 b v
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ForceBounding<T, D = EveryAxis<T>, R = FreshContact, A = Plain<T>, const N: usize = 0> {
    damping: D,
    energy: A,
    pipe: Pipe<T, N>,
    reset: PhantomData<R>,
}

impl<T: Scalar, D, R> ForceBounding<T, D, R> {
    fn over(damping: D) -> Result<Self, ParameterError> {
        Ok(Self { damping, energy: Plain::zero(), pipe: Pipe::new(0)?, reset: PhantomData })
    }
}

impl<T: Scalar> ForceBounding<T> {
    /// For a device that surely has the viscous `damping` on every axis, N·s/m.
    ///
    /// # Errors
    /// `damping` below 0, infinite or NaN.
    pub fn of_damping(damping: T) -> Result<Self, ParameterError> {
        Self::over(EveryAxis::new(damping)?)
    }
}

impl<T: Scalar, const M: usize> ForceBounding<T, DampingMatrix<T, M>> {
    /// For a device with the symmetric `damping` matrix, N·s/m, whose lower triangle is read.
    ///
    /// # Errors
    /// A matrix that is not finite or not above 0 in every direction: a pivot `dᵢ` of `D = L diag(d) Lᵀ` that is not
    /// above 0.
    pub fn of_matrix(damping: SMatrix<T, M, M>) -> Result<Self, ParameterError> {
        Self::over(DampingMatrix::new(damping)?)
    }
}

impl<T: Scalar, D, R, A: Accumulator<T>, const N: usize> ForceBounding<T, D, R, A, N> {
    /// The same bound for forces that act `ticks` periods late, at most `M`.
    ///
    /// # Errors
    /// `ticks` above `M`.
    pub fn delayed<const M: usize>(
        self,
        ticks: u32,
    ) -> Result<ForceBounding<T, D, R, A, M>, ParameterError> {
        let Self { damping, energy, reset, .. } = self;
        Ok(ForceBounding { damping, energy, pipe: Pipe::new(ticks)?, reset })
    }

    /// The same bound without the reset: what free motion dissipates is kept, and may buy a burst.
    #[must_use]
    pub fn keeping(self) -> ForceBounding<T, D, KeptCredit, A, N> {
        let Self { damping, energy, pipe, .. } = self;
        ForceBounding { damping, energy, pipe, reset: PhantomData }
    }

    /// The same bound with its energies summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> ForceBounding<T, D, R, B, N> {
        let Self { damping, energy, pipe, reset } = self;
        ForceBounding { damping, energy: B::holding(energy.value()), pipe, reset }
    }
}

impl<T, D, A, const N: usize> ForceBounding<T, D, KeptCredit, A, N>
where
    T: Scalar,
    A: Accumulator<T>,
{
    /// The same bound with `energy` more joules on its account.
    ///
    /// # Errors
    /// `energy` below 0, infinite or NaN, or more than the sum has room for.
    pub fn budgeted(mut self, energy: T) -> Result<Self, ParameterError> {
        self.energy = booked("budget", energy, self.energy, A::book)?;
        Ok(self)
    }
}

impl<T, D, R, A, const N: usize> StabilizerExt for ForceBounding<T, D, R, A, N> {}

/// The energy set aside for forces under way stays.
impl<T, D, R, A, const N: usize> LimitCredit<T> for ForceBounding<T, D, R, A, N>
where
    T: Scalar,
    A: Accumulator<T>,
{
    #[inline]
    fn limit_credit(&mut self, most: T) {
        self.energy.lower(most + self.pipe.committed());
    }
}

impl<V, D, R, A, const N: usize> Stabilizer<V> for ForceBounding<V::Scalar, D, R, A, N>
where
    V: Signal,
    D: DeviceDamping<V>,
    R: Reset,
    A: Accumulator<V::Scalar>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let committed = self.pipe.committed();
        if R::FORGETS {
            let applied = sample.applied.map(Scalar::magnitude).sum();
            let free = applied.finite() & !applied.above(zero);
            self.energy.lower(V::Scalar::choose(free, committed, V::Scalar::largest()));
        }
        let burnt = self.damping.burnt(sample.displacement, sample.period);
        // What the damper dissipates over an unknown time is unknown, and with it the tick's change.
        let unknown = V::Scalar::of(f64::NAN);
        let change = V::Scalar::choose(sample.timed(), sample.work.sum() + burnt, unknown);
        let booked = self.energy.book(change);
        let sum = self.energy.value();
        let free = (sum - committed).larger(zero);
        // A little less than the bound: with the rounding of what follows the account stays at or above 0.
        let share = V::Scalar::of(4.0) - V::Scalar::of(64.0) * V::Scalar::epsilon();
        let (size, gain) = self.damping.size(effort);
        // Out of range it is the largest number, a smaller bound; and 0 where it is 0 times an infinity.
        let square = share * gain * (free / sample.period);
        let most = square.larger(zero).smaller(V::Scalar::largest()).sqrt();
        let factor = V::Scalar::choose(size.above(most), most / size, one);
        let accepted = booked & size.finite() & effort.finite();
        // `size² T / (4 g)`, and never more than there is, which is what it is at the bound.
        let given = size.smaller(most);
        let cost = V::Scalar::of(0.25) * sample.period * (given * given / gain);
        self.pipe.push(V::Scalar::choose(accepted, cost.larger(zero), zero));
        limiting(effort.scale(factor), sum, accepted)
    }
}

account_in_sum!(
    impl[T: Scalar, D, R, A: Accumulator<T>, const N: usize] ForceBounding<T, D, R, A, N>, in T, is energy
);

impl<T: Scalar, D, R, A: Snapshot, const N: usize> Snapshot for ForceBounding<T, D, R, A, N> {
    /// The energy, and what the forces under way may take.
    type State = (A::State, SVector<T, N>);

    fn state(&self) -> Self::State {
        (self.energy.state(), self.pipe.costs())
    }

    fn restored(self, (energy, costs): Self::State) -> Result<Self, ParameterError> {
        Ok(Self { energy: self.energy.restored(energy)?, pipe: self.pipe.carrying(costs)?, ..self })
    }
}
