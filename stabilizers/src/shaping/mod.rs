//! Shaping of corrections: not at every velocity, not at once, not faster than a motor follows.
//!
//! Each shaper owns a stabilizer and lets a share of its correction through. Under held work the ledger books the
//! applied effort, not the requested one, so the part held back stays in `L`: a shaper delays the dissipation and
//! changes no sum. Under sampled work the ledger books every correction in full, so the part held back is lost.

mod inertia_limit;
mod rate_limit;
mod soft_start;
mod spread;
mod velocity_threshold;

pub use inertia_limit::InertiaLimit;
pub use rate_limit::RateLimit;
pub use soft_start::SoftStart;
pub use spread::Spread;
pub use velocity_threshold::VelocityThreshold;

use lyapunov_core::{Correction, ParameterError, PortSample, Requirement, Scalar, Signal};

/// A number of ticks that is not 0.
fn whole<T: Scalar>(name: &'static str, ticks: u32) -> Result<T, ParameterError> {
    Requirement::AtLeast(1.0).check(name, T::of(ticks.into()))
}

/// Correction with `share` of what `correction` adds to `effort`, if the share is below 1; it must not be below 0.
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

/// Effort that `correction` adds to `effort`; 0 where it is not accepted.
#[inline]
fn added<V: Signal>(correction: &Correction<V>, effort: V) -> V {
    V::choose(correction.accepted, correction.effort - effort, V::zero())
}
