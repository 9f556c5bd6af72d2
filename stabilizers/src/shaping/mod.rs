//! How a correction comes: not at every velocity, not at once, not faster than a motor follows.
//!
//! Each owns a stabilizer and lets a share of its correction through. What is held back stays in the account, for under
//! held work a ledger books what applied and not what was asked for; so each delays the payment and changes no sum. Under
//! sampled work the ledger takes every correction as made in full, so what is held back there is lost.

mod rate_limit;
mod soft_start;
mod spread;
mod velocity_threshold;

pub use rate_limit::RateLimit;
pub use soft_start::SoftStart;
pub use spread::Spread;
pub use velocity_threshold::VelocityThreshold;

use lyapunov_core::{Correction, PortSample, Scalar, Signal};

/// `correction` with `share` of its correction of `effort`, if the share is below 1; it must not be below 0.
#[inline]
fn portion<V: Signal>(
    correction: Correction<V>,
    sample: &PortSample<V>,
    effort: V,
    share: V::Scalar,
) -> Correction<V> {
    let zero = V::Scalar::of(0.0);
    let cut = share.below(V::Scalar::of(1.0)) & correction.accepted;
    let part = effort + (correction.effort - effort).scale(share);
    let alpha = correction.alpha * share;
    let burnt = alpha * (sample.velocity.inner(sample.velocity) * sample.period);
    let shortfall = (-(correction.observed_energy + burnt)).larger(zero);
    Correction {
        effort: V::choose(cut, part, correction.effort),
        alpha: V::Scalar::choose(cut, alpha, correction.alpha),
        shortfall: V::Scalar::choose(cut, shortfall, correction.shortfall),
        ..correction
    }
    .checked()
}

/// What `correction` adds to `effort`; nothing where it is not accepted.
#[inline]
fn added<V: Signal>(correction: &Correction<V>, effort: V) -> V {
    V::choose(correction.accepted, correction.effort - effort, V::zero())
}
