//! Bounded credit: a largest stored credit.

use lyapunov_core::{
    Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::LimitCredit;
use crate::account::lends;
use crate::credit::limits_credit;

/// Stabilizer that carries at most `most` joules of credit from tick to tick: `L(n) = min(L(n−1), most) − ΔV(n)`.
///
/// However much was dissipated before, the port can give at most `most` joules more than it absorbs before the
/// controller acts. An infinite bound changes no bit.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut bounded = popc.bounded(1e-4)?;
/// // 1 mJ, of which 0.1 mJ is kept
/// let absorbed = HeldTick { period: 1e-3, position: 0.01, velocity: 0.1, displacement: 1e-4, applied: 10.0 }.sample();
/// // 0.2 mJ
/// let given = HeldTick { period: 1e-3, position: 0.0, velocity: -0.1, displacement: -1e-4, applied: 2.0 }.sample();
/// bounded.stabilize(&absorbed, 2.0);
/// let sum: f64 = bounded.stabilize(&given, 2.0).observed_energy;
/// assert_abs_diff_eq!(sum, -1e-4, epsilon = 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BoundedCredit<S, T> {
    stabilizer: S,
    most: T,
}

impl<S, T: Scalar> BoundedCredit<S, T> {
    pub(crate) fn new(stabilizer: S, most: T) -> Result<Self, ParameterError> {
        Ok(Self { stabilizer, most: Requirement::Limit.check("most stored credit", most)? })
    }
}

limits_credit!(impl[T: Scalar, S: LimitCredit<T>] BoundedCredit<S, T>, in T, of stabilizer);

impl<V: Signal, S: Stabilizer<V> + LimitCredit<V::Scalar>> Stabilizer<V>
    for BoundedCredit<S, V::Scalar>
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.stabilizer.limit_credit(self.most);
        self.stabilizer.stabilize(sample, effort)
    }
}

lends!(impl[S, T: Scalar] BoundedCredit<S, T>, of S, in T);

impl<S, T: Scalar> BoundedCredit<S, T> {
    /// The largest credit that is carried from tick to tick, J.
    pub fn most(&self) -> T {
        self.most
    }

    /// Changes the largest credit between ticks. What is above a smaller one is forfeited on the next tick; a larger one
    /// weakens the bound to itself.
    ///
    /// # Errors
    /// `most` below 0 or NaN; the old one stays.
    pub fn set_most(&mut self, most: T) -> Result<(), ParameterError> {
        self.most = Requirement::Limit.check("most stored credit", most)?;
        Ok(())
    }
}

lyapunov_core::snapshot!(impl[S: Snapshot, T: Scalar] BoundedCredit<S, T>, is stabilizer, of S::State);
