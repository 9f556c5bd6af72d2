//! The laws of a stabilizer.

use crate::laws::{Law, Tick, Violation};
use crate::{Action, Drive, Scalar, Signal, Stabilizer};

/// Checks that `stabilizer` keeps the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NoNegativeDamping`](Law::NoNegativeDamping), [`Opposes`](Law::Opposes), [`Served`](Law::Served),
/// [`Rejects`](Law::Rejects) and [`Recovers`](Law::Recovers) over `samples`.
///
/// They check honesty (finite, passive, with debts told), not that a loop becomes stable: run a scene for that.
/// What a stabilizer tells of its damping is taken on trust. A limit of the actuator belongs outside of it, where
/// the next drive tells what acted: an effort clipped inside may feed power into the motion by what it cuts off.
///
/// # Errors
/// The first law that is broken.
pub fn stabilizer<V: Signal, S: Stabilizer<V> + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (Drive<V>, V)>,
) -> Result<(), Violation> {
    check(stabilizer, samples, opposes)
}

/// Checks that a `stabilizer` that makes efforts smaller, and adds no damping, keeps the laws of a
/// [`stabilizer`] over `samples`, with [`NoLarger`](Law::NoLarger) in the place of [`Opposes`](Law::Opposes).
///
/// An effort that opposed the motion and was cut off is missed by the motion it would have braked; what such a
/// stabilizer keeps instead is its account.
///
/// # Errors
/// The first law that is broken.
pub fn limiter<V: Signal, S: Stabilizer<V> + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (Drive<V>, V)>,
) -> Result<(), Violation> {
    check(stabilizer, samples, no_larger)
}

/// What a correction has to be like.
type Correction<V> = fn(Tick, &Drive<V>, V, &Action<V>) -> Result<(), Violation>;

fn check<V: Signal, S: Stabilizer<V> + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (Drive<V>, V)>,
    correction: Correction<V>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (stabilizer.clone(), stabilizer.clone());
    for (tick, (drive, effort)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let action = one.stabilize(&drive, effort);
        now.finite(Law::Finite, action.effort)?;
        now.finite(Law::Finite, action.sum + action.alpha + action.shortfall)?;
        now.require(Law::Finite, action.accepted, effort.sum())?;
        keeps_its_word(now, &drive, &action)?;
        correction(now, &drive, effort, &action)?;

        let again = other.stabilize(&drive, effort);
        now.same(Law::Repeatable, action.effort, again.effort)?;
        now.same(Law::Repeatable, action.sum, again.sum)?;
        now.same(Law::Repeatable, action.alpha, again.alpha)?;

        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            rejects(now, one.clone(), &drive, effort, V::Scalar::of(bad))?;
            survives(now, &one, &drive, effort, V::Scalar::of(bad))?;
        }
    }
    Ok(())
}

fn keeps_its_word<V: Signal>(
    now: Tick,
    drive: &Drive<V>,
    action: &Action<V>,
) -> Result<(), Violation> {
    let zero = V::Scalar::of(0.0);
    now.not_below_zero(Law::NoNegativeDamping, action.alpha, zero)?;
    now.not_below_zero(Law::NoNegativeDamping, action.shortfall, zero)?;
    let burnt = action.alpha * (drive.velocity.pair(drive.velocity) * drive.period);
    let served = action.sum + burnt + action.shortfall;
    now.not_below_zero(Law::Served, served, action.sum.magnitude())
}

fn opposes<V: Signal>(
    now: Tick,
    drive: &Drive<V>,
    effort: V,
    action: &Action<V>,
) -> Result<(), Violation> {
    let power = (action.effort - effort).pair(drive.velocity);
    let size = action.effort.map(Scalar::magnitude) + effort.map(Scalar::magnitude);
    now.not_below_zero(Law::Opposes, power, size.pair(drive.velocity.map(Scalar::magnitude)))
}

/// On every axis between 0 and the effort it was given.
fn no_larger<V: Signal>(
    now: Tick,
    _drive: &Drive<V>,
    effort: V,
    action: &Action<V>,
) -> Result<(), Violation> {
    let zero = V::Scalar::of(0.0);
    let beyond = action.effort.zip(effort, |out, given| {
        let (least, most) = (given.smaller(zero), given.larger(zero));
        (out - most).larger(zero) + (least - out).larger(zero)
    });
    let size = effort.map(Scalar::magnitude).sum();
    now.not_below_zero(Law::NoLarger, -beyond.sum(), size)
}

/// Each field of the drive bad, and then a sound sample.
fn survives<V: Signal, S: Stabilizer<V> + Clone>(
    now: Tick,
    stabilizer: &S,
    drive: &Drive<V>,
    effort: V,
    bad: V::Scalar,
) -> Result<(), Violation> {
    let spoilt = V::splat(bad);
    for flawed in [
        Drive { period: bad, ..*drive },
        Drive { position: spoilt, ..*drive },
        Drive { velocity: spoilt, ..*drive },
        Drive { displacement: spoilt, ..*drive },
        Drive { acted: spoilt, ..*drive },
        Drive { work: spoilt, ..*drive },
    ] {
        let mut stabilizer = stabilizer.clone();
        now.finite(Law::Rejects, stabilizer.stabilize(&flawed, effort).effort)?;
        let accepted = stabilizer.stabilize(drive, effort);
        now.finite(Law::Recovers, accepted.effort)?;
        now.require(Law::Recovers, accepted.accepted, bad)?;
    }
    Ok(())
}

/// One bad effort, and then the same sample sound.
fn rejects<V: Signal>(
    now: Tick,
    mut stabilizer: impl Stabilizer<V>,
    drive: &Drive<V>,
    effort: V,
    bad: V::Scalar,
) -> Result<(), Violation> {
    let rejected = stabilizer.stabilize(drive, V::splat(bad));
    now.finite(Law::Rejects, rejected.effort)?;
    now.require(Law::Rejects, !rejected.accepted, bad)?;
    let accepted = stabilizer.stabilize(drive, effort);
    now.finite(Law::Recovers, accepted.effort)?;
    now.require(Law::Recovers, accepted.accepted, bad)
}
