//! Reference energy following.

mod reference_damper;

pub use reference_damper::ReferenceDamper;

use lyapunov_core::{Held, Plain, PortEnergy};

use crate::Lolc;

/// POPC with reference energy following, after Ryu, Preusche, Hannaford and Hirzinger (IEEE Transactions on Control
/// Systems Technology 13(5), 2005): it acts as soon as the port's energy leaves what an ideal environment would have
/// taken in, and does not wait for 0.
///
/// ```text
/// L(n) = Σ f_act Δx − (S(x(n)) − S(x(0))) − R(n),   α = −L / (v² T) where L < 0, as in Lolc
/// ```
///
/// in joules, with `S` what the ideal environment stores, a [`StorageFunction`](lyapunov_core::StorageFunction), and
/// `R` what it dissipates, a [`ReferenceDamper`]; a wall with damping needs both, as `(PortEnergy, (storage, damper))`.
/// A held spring gives back more than it took from the turning point on. POPC sees that when the whole of what was
/// absorbed is used up, at the end of the contact, and serves it there at once; with the reference it is seen on the
/// tick on which it happens.
///
/// **Guarantee** (derived here; the paper's own text was not at hand): what the port gives above what the ideal
/// environment would have given is reported as debt and served up to the limit, after the fact. On a held spring `K`,
/// which lacks `K Δx² / 2` a tick, at a constant speed `α = K T / 2` from the second tick on: the law is the damper
/// that pays the hold. **Assumed** is that the reference is what an ideal environment stores and dissipates: one that
/// is too large makes the controller act without need.
///
/// ```
/// use lyapunov_core::{PortEnergy, StorageFunction};
/// use lyapunov_stabilizers::{DampingLimit, ReferenceDamper, ReferenceFollowing};
/// let depth = |x: f64| x.max(0.0);
/// let stored = move |x: f64, _v: f64| 0.5 * 1000.0 * depth(x) * depth(x); // a wall of 1 kN/m and 2 N·s/m
/// let reference = (StorageFunction::starting(stored, -0.01, 0.0), ReferenceDamper::starting(2.0, depth, -0.01)?);
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?;
/// let following: ReferenceFollowing<f64, _> = ReferenceFollowing::new((PortEnergy, reference), limit);
/// # let _ = following;
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub type ReferenceFollowing<T, R, A = Plain<T>> = Lolc<T, (PortEnergy, R), Held, A>;
