//! How a correction comes: not at every velocity, not at once, not faster than a motor follows.
//!
//! Each owns a stabilizer and lets a share of its correction through. What is held back stays in the account, for under
//! held work a ledger books what acted and not what was asked for; so each delays the payment and changes no sum. Under
//! sampled work the ledger takes every correction as made in full, so what is held back there is lost.

mod rate_limit;
mod rise;
mod spread;
mod threshold;

pub use rate_limit::RateLimit;
pub use rise::Rise;
pub use spread::Spread;
pub use threshold::Threshold;

use lyapunov_core::{Action, Drive, Scalar, Signal};

/// `action` with `share` of its correction of `effort`, if the share is below 1; it must not be below 0.
#[inline]
fn portion<V: Signal>(
    action: Action<V>,
    drive: &Drive<V>,
    effort: V,
    share: V::Scalar,
) -> Action<V> {
    let zero = V::Scalar::of(0.0);
    let cut = share.below(V::Scalar::of(1.0)) & action.accepted;
    let part = effort + (action.effort - effort).scale(share);
    let alpha = action.alpha * share;
    let burnt = alpha * (drive.velocity.pair(drive.velocity) * drive.period);
    let shortfall = (-(action.sum + burnt)).larger(zero);
    Action {
        effort: V::choose(cut, part, action.effort),
        alpha: V::Scalar::choose(cut, alpha, action.alpha),
        shortfall: V::Scalar::choose(cut, shortfall, action.shortfall),
        ..action
    }
    .checked()
}

/// What `action` adds to `effort`; nothing where it is not accepted.
#[inline]
fn correction<V: Signal>(action: &Action<V>, effort: V) -> V {
    V::choose(action.accepted, action.effort - effort, V::zero())
}
