//! Limits of efforts to what a store of energy pays for.

use lyapunov_core::{Correction, Scalar, Signal};

/// The part of `energy` joules that a step may hand out; none of a debt. It is less than all of it by 4 ε, more than the step and
/// the work that follows round on one axis.
#[inline(always)]
pub(crate) fn payable<T: Scalar>(energy: T) -> T {
    // 1 − 4 ε to the bit, written so that it is above 0 for whatever knows of ε only that it is small.
    let kept = T::of(4.0) * (T::of(0.25) - T::epsilon());
    energy.larger(T::of(0.0)) * kept
}

/// The correction of a stabilizer that limits efforts and adds no damping: the `limited` effort where it is accepted, else none. A
/// debt in `energy` is all shortfall.
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
