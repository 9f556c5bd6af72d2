//! Correction of a stabilizer that limits efforts and adds no damping.

use lyapunov_core::{Correction, Scalar, Signal};

/// The `limited` effort where it is accepted, and none elsewhere; without damping a debt in `energy` is all shortfall.
#[inline(always)]
pub(crate) fn limiting<V: Signal>(
    limited: V,
    energy: V::Scalar,
    accepted: <V::Scalar as Scalar>::Mask,
) -> Correction<V> {
    let zero = V::Scalar::of(0.0);
    Correction {
        effort: V::choose(accepted, limited, V::zero()),
        observed_energy: energy,
        alpha: zero,
        shortfall: (-energy).larger(zero),
        accepted,
    }
}
