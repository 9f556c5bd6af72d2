//! Credit reset at each contact.

use lyapunov_core::{
    Correction, Gate, Mask, ParameterError, PortSample, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::LimitCredit;
use crate::account::lends;
use crate::credit::limits_credit;

/// Stabilizer that forfeits its stored credit on the tick on which a gate opens, before that tick is booked.
///
/// With the gate of a surface ([`InContact`](lyapunov_core::InContact)) no contact inherits the credit of the free
/// motion or the contact before it, and the controller acts as soon as this contact has given more than it absorbed.
/// Debts stay. A position that is not a number counts as outside. A loop that starts in contact opens the gate on its first
/// tick, so a budget is forfeited there.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{InContact, HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.reset_at(InContact { position: 0.0 });
/// let outside = HeldTick {
///     period: 1e-3, position: -0.001, velocity: 0.1, displacement: 1e-4, applied: 10.0
/// }.sample();
/// let inside = HeldTick { period: 1e-3, position: 0.001, velocity: 0.1, displacement: 1e-4, applied: 2.0 }.sample();
/// let sums: [f64; 3] = [outside, inside, inside].map(|sample| popc.stabilize(&sample, 2.0).observed_energy);
/// for (sum, joules) in sums.into_iter().zip([1e-3, 2e-4, 4e-4]) {
///     assert_abs_diff_eq!(sum, joules, epsilon = 1e-12); // the first in contact holds its own tick only
/// }
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ContactReset<S, G, T: Scalar> {
    stabilizer: S,
    gate: G,
    inside: T::Mask,
}

impl<S, G, T: Scalar> ContactReset<S, G, T> {
    pub(crate) fn new(stabilizer: S, gate: G) -> Self {
        Self { stabilizer, gate, inside: Mask::of(false) }
    }
}

limits_credit!(impl[T: Scalar, S: LimitCredit<T>, G] ContactReset<S, G, T>, in T, of stabilizer);

impl<V, S, G> Stabilizer<V> for ContactReset<S, G, V::Scalar>
where
    V: Signal,
    S: Stabilizer<V> + LimitCredit<V::Scalar>,
    G: Gate<V>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let inside = self.gate.open(sample);
        let begins = inside & !self.inside;
        self.inside = inside;
        let (none, all) = (V::Scalar::of(0.0), V::Scalar::largest());
        self.stabilizer.limit_credit(V::Scalar::choose(begins, none, all));
        self.stabilizer.stabilize(sample, effort)
    }
}

lends!(impl[S, G, T: Scalar] ContactReset<S, G, T>, of S, in T);

/// Where the gate was open is a 1, elsewhere a 0.
impl<S: Snapshot, G, T: Scalar> Snapshot for ContactReset<S, G, T> {
    type State = (S::State, T);

    fn state(&self) -> Self::State {
        (self.stabilizer.state(), T::choose(self.inside, T::of(1.0), T::of(0.0)))
    }

    fn restored(self, (inside, open): Self::State) -> Result<Self, ParameterError> {
        let stabilizer = self.stabilizer.restored(inside)?;
        Ok(Self { stabilizer, inside: open.above(T::of(0.5)), ..self })
    }
}
