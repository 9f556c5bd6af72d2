//! Credit that no contact inherits.

use lyapunov_core::{Action, Drive, Gate, Mask, Scalar, Signal, Stabilizer};

use crate::Account;

/// A stabilizer that forgets its credit on the tick on which a gate opens, before that tick is booked.
///
/// With the gate of a surface ([`Beyond`](lyapunov_core::Beyond)) every contact starts without what was dissipated on the
/// way to it, or in the contact before, and the controller acts as soon as this contact has given more than it took.
/// Debts stay. A position that is not a number counts as outside.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{Beyond, Drive, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, Popc, Refine};
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let mut popc = popc.reset_at(Beyond { position: 0.0 });
/// let outside = Drive::new(1e-3, -0.001, 0.1, 1e-4, 10.0);
/// let inside = Drive::new(1e-3, 0.001, 0.1, 1e-4, 2.0);
/// let sums: [f64; 3] = [outside, inside, inside].map(|drive| popc.stabilize(&drive, 2.0).sum);
/// for (sum, joules) in sums.into_iter().zip([1e-3, 2e-4, 4e-4]) {
///     assert_abs_diff_eq!(sum, joules, epsilon = 1e-12); // the first in contact is of its own tick only
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

impl<T: Scalar, S: Account<T>, G> Account<T> for ContactReset<S, G, T> {
    #[inline]
    fn forget_above(&mut self, most: T) {
        self.stabilizer.forget_above(most);
    }
}

impl<V, S, G> Stabilizer<V> for ContactReset<S, G, V::Scalar>
where
    V: Signal,
    S: Stabilizer<V> + Account<V::Scalar>,
    G: Gate<V>,
{
    #[inline]
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V> {
        let inside = self.gate.open(drive);
        let begins = inside & !self.inside;
        self.inside = inside;
        let (none, all) = (V::Scalar::of(0.0), V::Scalar::largest());
        self.stabilizer.forget_above(V::Scalar::choose(begins, none, all));
        self.stabilizer.stabilize(drive, effort)
    }
}
