//! The laws of a stabilizer.

use crate::laws::{Law, Tick, Violation};
use crate::{Correction, PortSample, Scalar, Signal, Stabilizer};

/// Check of a `stabilizer` over `samples`: the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NoNegativeDamping`](Law::NoNegativeDamping), [`Opposes`](Law::Opposes), [`Served`](Law::Served),
/// [`Rejects`](Law::Rejects) and [`Recovers`](Law::Recovers).
///
/// The laws check honesty (finite, passive, with debts reported), not that a loop becomes stable: run a scene for that.
/// They take the reported damping on trust. A limit of the actuator belongs outside the stabilizer, where the next
/// sample reports the applied effort: an effort clipped inside may feed power into the motion by what it cuts off.
///
/// # Errors
/// The first law that is broken.
pub fn stabilizer<V: Signal, S: Stabilizer<V> + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    check(stabilizer, samples, opposes)
}

/// Check of a `stabilizer` that makes efforts smaller and adds no damping: the laws of [`stabilizer()`] over
/// `samples`, with [`NoLarger`](Law::NoLarger) in the place of [`Opposes`](Law::Opposes).
///
/// Where such a stabilizer cuts off an effort that opposed the motion, it takes away braking, so it cannot keep
/// [`Opposes`](Law::Opposes); it keeps its ledger instead.
///
/// # Errors
/// The first law that is broken.
pub fn limiter<V: Signal, S: Stabilizer<V> + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    check(stabilizer, samples, no_larger)
}

/// Requirement on a correction.
type Manner<V> = fn(Tick, &PortSample<V>, V, &Correction<V>) -> Result<(), Violation>;

fn check<V: Signal, S: Stabilizer<V> + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
    manner: Manner<V>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (stabilizer.clone(), stabilizer.clone());
    for (tick, (sample, effort)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let correction = one.stabilize(&sample, effort);
        now.finite(Law::Finite, correction.effort)?;
        now.finite(
            Law::Finite,
            correction.observed_energy + correction.alpha + correction.shortfall,
        )?;
        now.require(Law::Finite, correction.accepted, effort.sum())?;
        keeps_its_word(now, &sample, &correction)?;
        manner(now, &sample, effort, &correction)?;

        let again = other.stabilize(&sample, effort);
        now.same(Law::Repeatable, correction.effort, again.effort)?;
        now.same(Law::Repeatable, correction.observed_energy, again.observed_energy)?;
        now.same(Law::Repeatable, correction.alpha, again.alpha)?;

        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            rejects(now, one.clone(), &sample, effort, V::Scalar::of(bad))?;
            survives(now, &one, &sample, effort, V::Scalar::of(bad))?;
        }
    }
    Ok(())
}

fn keeps_its_word<V: Signal>(
    now: Tick,
    sample: &PortSample<V>,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    let zero = V::Scalar::of(0.0);
    now.not_below_zero(Law::NoNegativeDamping, correction.alpha, zero)?;
    now.not_below_zero(Law::NoNegativeDamping, correction.shortfall, zero)?;
    let burnt = correction.alpha * (sample.velocity.inner(sample.velocity) * sample.period);
    let served = correction.observed_energy + burnt + correction.shortfall;
    now.not_below_zero(Law::Served, served, correction.observed_energy.magnitude())
}

fn opposes<V: Signal>(
    now: Tick,
    sample: &PortSample<V>,
    effort: V,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    let power = (correction.effort - effort).inner(sample.velocity);
    let size = correction.effort.map(Scalar::magnitude) + effort.map(Scalar::magnitude);
    now.not_below_zero(Law::Opposes, power, size.inner(sample.velocity.map(Scalar::magnitude)))
}

/// Check that the effort is between 0 and the given effort on every axis.
fn no_larger<V: Signal>(
    now: Tick,
    _drive: &PortSample<V>,
    effort: V,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    let zero = V::Scalar::of(0.0);
    let beyond = correction.effort.zip(effort, |out, given| {
        let (least, most) = (given.smaller(zero), given.larger(zero));
        (out - most).larger(zero) + (least - out).larger(zero)
    });
    let size = effort.map(Scalar::magnitude).sum();
    now.not_below_zero(Law::NoLarger, -beyond.sum(), size)
}

/// Check of samples with one bad field each, every one followed by a sound sample.
fn survives<V: Signal, S: Stabilizer<V> + Clone>(
    now: Tick,
    stabilizer: &S,
    sample: &PortSample<V>,
    effort: V,
    bad: V::Scalar,
) -> Result<(), Violation> {
    let spoilt = V::splat(bad);
    for flawed in [
        PortSample { period: bad, ..*sample },
        PortSample { position: spoilt, ..*sample },
        PortSample { velocity: spoilt, ..*sample },
        PortSample { displacement: spoilt, ..*sample },
        PortSample { applied: spoilt, ..*sample },
        PortSample { work: spoilt, ..*sample },
    ] {
        let mut stabilizer = stabilizer.clone();
        now.finite(Law::Rejects, stabilizer.stabilize(&flawed, effort).effort)?;
        let accepted = stabilizer.stabilize(sample, effort);
        now.finite(Law::Recovers, accepted.effort)?;
        now.require(Law::Recovers, accepted.accepted, bad)?;
    }
    Ok(())
}

/// Check of one bad effort, followed by the same sample with a sound one.
fn rejects<V: Signal>(
    now: Tick,
    mut stabilizer: impl Stabilizer<V>,
    sample: &PortSample<V>,
    effort: V,
    bad: V::Scalar,
) -> Result<(), Violation> {
    let rejected = stabilizer.stabilize(sample, V::splat(bad));
    now.finite(Law::Rejects, rejected.effort)?;
    now.require(Law::Rejects, !rejected.accepted, bad)?;
    let accepted = stabilizer.stabilize(sample, effort);
    now.finite(Law::Recovers, accepted.effort)?;
    now.require(Law::Recovers, accepted.accepted, bad)
}
