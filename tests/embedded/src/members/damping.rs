//! Members that add damping, on one axis.

use lyapunov_core::{
    Compensated, Dissipation, Held, InContact, ParameterError, Plain, PortEnergy, Readings,
    Sampled, StorageFunction,
};
use lyapunov_stabilizers::{
    BoundedCredit, ContactReset, LeastNorm, Lolc, Member, NoStabilizer, Plausibility, Plausible,
    Popc, RateLimit, ReferenceDamper, ReferenceFollowing, SoftStart, Spread, StabilizerExt,
    VelocityThreshold, Watchdog, WatchdogTimes, WindowedCredit,
};

use super::{Number, Visit, limit, period, popc};
use crate::by_hand::ByHand;
use crate::port::Reads;

type Shown = Result<(), ParameterError>;

/// The controller with its ledgers.
#[inline(never)]
pub(super) fn plain<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let popc = popc::<T>()?;
    visit.member::<T, NoStabilizer>("none", NoStabilizer);
    visit.member::<T, ByHand<T>>("by-hand", ByHand(T::zero()));
    visit.member::<T, Popc<T>>("popc", popc);
    visit.member::<T, Popc<T, Sampled>>("popc-sampled", popc.sampled());
    visit.member::<T, Popc<T, Held, Compensated<T>>>("popc-compensated", popc.summed_in());
    let member: Member<T> = Member::Popc(popc);
    visit.member::<T, Member<T>>("popc-member", member);
    Ok(())
}

/// Limits of the credit.
#[inline(never)]
pub(super) fn credit<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (popc, of) = (popc::<T>()?, T::of);
    visit.member::<T, Popc<T>>("popc-budgeted", popc.budgeted(of(1e-3))?);
    visit.member::<T, BoundedCredit<_, _>>("popc-bounded", popc.bounded(of(1e-3))?);
    let sum: WindowedCredit<T, Plain<T>, 8> = WindowedCredit::of_ticks(5)?;
    visit.member::<T, Popc<T, Held, _>>("popc-windowed", popc.summed_by(sum));
    let contact = InContact { position: T::zero() };
    visit.member::<T, ContactReset<_, _, T>>("popc-contact-reset", popc.reset_at(contact));
    Ok(())
}

/// Shapes of the correction.
#[inline(never)]
pub(super) fn shaping<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (popc, of) = (popc::<T>()?, T::of);
    let threshold: VelocityThreshold<_, T> = popc.above_velocity(of(0.01))?;
    visit.member::<T, _>("popc-threshold", threshold);
    let spread: Spread<_, T> = popc.spread_over(5)?;
    visit.member::<T, _>("popc-spread", spread);
    let limited: RateLimit<_, T> = popc.rate_limited(of(100.0))?;
    visit.member::<T, _>("popc-rate-limited", limited);
    let rising: SoftStart<_, T> = popc.rising_over(5)?;
    visit.member::<T, _>("popc-rising", rising);
    Ok(())
}

/// Candidates of one's own.
#[inline(never)]
pub(super) fn candidates<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (limit, of) = (limit::<T>()?, T::of);
    let damper = Dissipation::of(of(0.3))?;
    visit.member::<T, Lolc<T, _>>("lolc", Lolc::new((PortEnergy, damper), limit));
    let spring = |x: T, _v: T| T::of(25.0) * x * x;
    let stored = StorageFunction::starting(spring, T::zero(), T::zero());
    visit.member::<T, Lolc<T, _>>("lolc-spring", Lolc::new(stored, limit));
    let reference: ReferenceFollowing<T, _> = Lolc::new((PortEnergy, stored), limit);
    visit.member::<T, _>("popc-reference", reference);
    let wall = ReferenceDamper::starting(of(2.0), |x: T| x.larger(T::zero()), T::zero())?;
    let reference: ReferenceFollowing<T, _> = Lolc::new((PortEnergy, (stored, wall)), limit);
    visit.member::<T, _>("reference-following", reference);
    let least: LeastNorm<T, _> = LeastNorm::new(PortEnergy, limit, of(0.3))?;
    visit.member::<T, _>("least-norm", least);
    Ok(())
}

/// What stands around a stabilizer in a loop of one's own.
#[inline(never)]
pub(super) fn guarded<T: Number>(visit: &mut impl Visit<T>) -> Shown {
    let (popc, of) = (popc::<T>()?, T::of);
    let limits = Plausibility { speed: of(20.0), effort: of(500.0) };
    let plausible: Plausible<_, T> = popc.plausible(limits)?;
    visit.member::<T, _>("popc-plausible", plausible);
    let times = WatchdogTimes { hold: of(3e-3), rise: of(0.1) };
    let watched: Watchdog<_, T> = popc.watched(times)?;
    visit.member::<T, _>("popc-watched", watched);
    visit.member::<T, _>("popc-readings", Reads(Readings::every(period())?, popc));
    Ok(())
}
