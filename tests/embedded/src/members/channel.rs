//! Members at the ends of a channel, on one axis.

use lyapunov_core::ParameterError;
use lyapunov_stabilizers::{
    DriftCompensated, Sharing, TwoLayer, TwoPortSide, WaveFilter, WaveFollower, WaveTransform,
};

use super::{Number, Visit, limit};
use crate::port::{Looped, Waves};

/// Ends that send energies.
#[inline(never)]
pub(super) fn ends<T: Number>(visit: &mut impl Visit<T>) -> Result<(), ParameterError> {
    let of = T::of;
    let side: TwoPortSide<T> = TwoPortSide::new(limit()?);
    visit.member::<T, _>("two-port", Looped(side));
    visit.member::<T, _>("two-port-sampled", side.sampled());
    let compensated: DriftCompensated<_, T> = DriftCompensated::new(side, of(0.1))?;
    visit.member::<T, _>("drift-compensated", compensated);
    let sharing = Sharing { start: of(1e-3), share: of(0.1) };
    let master: TwoLayer<T> = TwoLayer::master(sharing, of(5e-3), of(200.0))?;
    visit.member::<T, _>("two-layer", Looped(master));
    Ok(())
}

/// Ends that send waves.
#[inline(never)]
pub(super) fn waves<T: Number>(visit: &mut impl Visit<T>) -> Result<(), ParameterError> {
    let transform = WaveTransform::new(T::of(0.7))?;
    let follower = WaveFollower::matched(transform, T::of(50.0))?;
    let filter: WaveFilter<T> = WaveFilter::new(T::of(0.3))?;
    visit.member::<T, _>("waves", Waves { transform, filter, follower });
    Ok(())
}
