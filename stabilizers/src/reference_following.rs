//! Reference energy following.

use lyapunov_core::{Held, Plain, PortEnergy, StorageFunction};

use crate::Lolc;

/// POPC with reference energy following: the port's energy is kept above what the rendered environment would hold,
/// `S(x, v)`, and not above 0.
///
/// `L(n) = Σ f_act Δx − (S(n) − S(0))`, and `α` serves `L < 0` as in [`Lolc`]. A held spring gives back more than it took
/// from the turning point on. POPC sees that when the whole of what was absorbed is used up, at the end of the
/// contact, and serves it there at once; with the spring's own energy as the reference it is seen on the tick on which
/// it happens, and many small corrections take the place of one large one. Ryu, Preusche, Hannaford and Hirzinger
/// (IEEE Transactions on Control Systems Technology 13(5), 2005) let the energy follow a reference for this reason.
/// Here the reference is a function of the state, which makes it a [`StorageFunction`] term of the candidate. It must be what an
/// ideal environment stores: one that is too large makes the controller act without need.
///
/// ```
/// use lyapunov_core::{PortEnergy, StorageFunction};
/// use lyapunov_stabilizers::{DampingLimit, ReferenceFollowing};
/// let stored = |x: f64, _v: f64| 0.5 * 1000.0 * x.max(0.0) * x.max(0.0); // a wall of 1 kN/m
/// let candidate = (PortEnergy, StorageFunction::starting(stored, -0.01, 0.0));
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?;
/// let following: ReferenceFollowing<f64, _> = ReferenceFollowing::new(candidate, limit);
/// # let _ = following;
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub type ReferenceFollowing<T, F, A = Plain<T>> =
    Lolc<T, (PortEnergy, StorageFunction<F, T>), Held, A>;
