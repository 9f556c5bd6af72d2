//! The laws of a stabilizer.

use super::tick::spread;
use crate::laws::{Law, Tick, Violation, quantity};
use crate::{Correction, Mask, PortSample, Scalar, Signal, Stabilizer};

/// Check of a `stabilizer` over `samples`: the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NoNegativeDamping`](Law::NoNegativeDamping), [`Opposes`](Law::Opposes), [`Served`](Law::Served),
/// [`Rejects`](Law::Rejects) and [`Recovers`](Law::Recovers); on lanes also [`LaneByLane`](Law::LaneByLane).
///
/// A period that is not above 0 is no time ([`PortSample::timed`]); whatever is answered to it is finite and keeps
/// [`Opposes`](Law::Opposes), and the next sample is answered.
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
///
/// ```
/// use lyapunov_core::{Correction, PortSample, Stabilizer, laws};
/// /// Half of every effort.
/// #[derive(Clone)]
/// struct Half;
/// impl Stabilizer<f64> for Half {
///     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
///         let sound = sample.sound() && effort.is_finite();
///         Correction { accepted: sound, ..Correction::none(if sound { 0.5 * effort } else { 0.0 }) }
///     }
/// }
/// laws::limiter(&Half, laws::Samples::new(1e-3))?;
/// # Ok::<(), laws::Violation>(())
/// ```
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
    Tick::each(samples, |now, sample, effort| {
        let before = one.clone();
        let correction = one.stabilize(sample, effort);
        finite(now, &correction)?;
        keeps_its_word(now, sample, &correction)?;
        manner(now, sample, effort, &correction)?;
        alike(now, Law::Repeatable, &correction, &other.stabilize(sample, effort))?;
        lane_by_lane(now, &before, sample, effort, &correction)?;
        keeps_to_its_lane(now, &before, sample, effort)?;
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            rejects(now, one.clone(), sample, effort, bad)?;
            survives(now, &one, sample, effort, bad)?;
        }
        for period in [-1e-3, -0.0, 0.0] {
            outlives(now, one.clone(), sample, effort, period, manner)?;
        }
        Ok(())
    })
}

fn finite<V: Signal>(now: Tick, correction: &Correction<V>) -> Result<(), Violation> {
    let Correction { effort, observed_energy, alpha, shortfall, accepted } = *correction;
    now.told(quantity::EFFORT).finite(Law::Finite, effort)?;
    now.told(quantity::OBSERVED_ENERGY).finite(Law::Finite, observed_energy)?;
    now.told(quantity::DAMPING).finite(Law::Finite, alpha)?;
    now.told(quantity::SHORTFALL).finite(Law::Finite, shortfall)?;
    now.told(quantity::ACCEPTANCE).holds::<V::Scalar>(Law::Finite, accepted)
}

/// Comparison of all that two corrections tell.
pub(super) fn alike<V: Signal>(
    now: Tick,
    law: Law,
    one: &Correction<V>,
    other: &Correction<V>,
) -> Result<(), Violation> {
    now.told(quantity::EFFORT).same(law, one.effort, other.effort)?;
    let [energy, again] = [one, other].map(|it| it.observed_energy);
    now.told(quantity::OBSERVED_ENERGY).same(law, energy, again)?;
    now.told(quantity::DAMPING).same(law, one.alpha, other.alpha)?;
    now.told(quantity::SHORTFALL).same(law, one.shortfall, other.shortfall)?;
    let [accepted, again] = [one, other].map(accepted::<V>);
    now.told(quantity::ACCEPTANCE).same(law, accepted, again)
}

/// 1 where a correction comes of an accepted sample, else 0.
fn accepted<V: Signal>(correction: &Correction<V>) -> V::Scalar {
    V::Scalar::choose(correction.accepted, V::Scalar::of(1.0), V::Scalar::of(0.0))
}

/// Check of each lane against the same stabilizer with that lane's numbers in all lanes.
fn lane_by_lane<V: Signal, S: Stabilizer<V> + Clone>(
    now: Tick,
    before: &S,
    sample: &PortSample<V>,
    effort: V,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    if V::Scalar::LANES == 1 {
        return Ok(());
    }
    for lane in 0..V::Scalar::LANES {
        let alone = sample.map(spread(sample.period, lane), |signal| spread(signal, lane));
        let own = before.clone().stabilize(&alone, spread(effort, lane));
        let told = alike(now, Law::LaneByLane, &of_lane(correction, lane), &of_lane(&own, lane));
        told.map_err(|broken| Violation { lane: lane as u32, ..broken })?;
    }
    Ok(())
}

/// Check that a NaN in one lane changes no other lane.
fn keeps_to_its_lane<V: Signal, S: Stabilizer<V> + Clone>(
    now: Tick,
    before: &S,
    sample: &PortSample<V>,
    effort: V,
) -> Result<(), Violation> {
    if V::Scalar::LANES == 1 {
        return Ok(());
    }
    let bad = f64::NAN;
    let first = !V::Scalar::from_lanes(|lane| lane as f64).above(V::Scalar::of(0.0));
    for (field, flawed) in flawed(sample, bad, first) {
        let correction = before.clone().stabilize(&flawed, effort);
        lane_by_lane(now, before, &flawed, effort, &correction)
            .map_err(|broken| broken.after(field, bad))?;
    }
    Ok(())
}

/// The sample with one field each that is `bad` in the lanes of `spoilt`.
fn flawed<V: Signal>(
    sample: &PortSample<V>,
    bad: f64,
    spoilt: <V::Scalar as Scalar>::Mask,
) -> [(&'static str, PortSample<V>); 6] {
    let lanes = |own| V::Scalar::choose(spoilt, V::Scalar::of(bad), own);
    let axes = |own: V| own.map(lanes);
    let PortSample { period, position, velocity, displacement, applied, work } = *sample;
    [
        ("period", PortSample { period: lanes(period), ..*sample }),
        ("position", PortSample { position: axes(position), ..*sample }),
        ("velocity", PortSample { velocity: axes(velocity), ..*sample }),
        ("displacement", PortSample { displacement: axes(displacement), ..*sample }),
        ("applied effort", PortSample { applied: axes(applied), ..*sample }),
        ("work", PortSample { work: axes(work), ..*sample }),
    ]
}

fn of_lane<V: Signal>(correction: &Correction<V>, lane: usize) -> Correction<V> {
    Correction {
        effort: spread(correction.effort, lane),
        observed_energy: spread(correction.observed_energy, lane),
        alpha: spread(correction.alpha, lane),
        shortfall: spread(correction.shortfall, lane),
        accepted: spread(accepted(correction), lane).above(V::Scalar::of(0.0)),
    }
}

fn keeps_its_word<V: Signal>(
    now: Tick,
    sample: &PortSample<V>,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    let zero = V::Scalar::of(0.0);
    let law = Law::NoNegativeDamping;
    now.told(quantity::DAMPING).not_below_zero(law, correction.alpha, zero)?;
    now.told(quantity::SHORTFALL).not_below_zero(law, correction.shortfall, zero)?;
    let burnt = correction.alpha * (sample.velocity.inner(sample.velocity) * sample.period);
    let served = correction.observed_energy + burnt + correction.shortfall;
    now.told(quantity::SERVED).not_below_zero(
        Law::Served,
        served,
        correction.observed_energy.magnitude(),
    )
}

fn opposes<V: Signal>(
    now: Tick,
    sample: &PortSample<V>,
    effort: V,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    let power = (correction.effort - effort).inner(sample.velocity);
    let size = correction.effort.map(Scalar::magnitude) + effort.map(Scalar::magnitude);
    let size = size.inner(sample.velocity.map(Scalar::magnitude));
    now.told(quantity::POWER_TAKEN).not_below_zero(Law::Opposes, power, size)
}

/// Check that the effort is between 0 and the given effort on every axis.
fn no_larger<V: Signal>(
    now: Tick,
    _sample: &PortSample<V>,
    effort: V,
    correction: &Correction<V>,
) -> Result<(), Violation> {
    let zero = V::Scalar::of(0.0);
    let beyond = correction.effort.zip(effort, |out, given| {
        let (least, most) = (given.smaller(zero), given.larger(zero));
        (out - most).larger(zero) + (least - out).larger(zero)
    });
    let size = effort.map(Scalar::magnitude).sum();
    now.told(quantity::ROOM_IN_EFFORT).not_below_zero(Law::NoLarger, -beyond.sum(), size)
}

/// Check of samples with one bad field each, every one followed by a sound sample.
fn survives<V: Signal, S: Stabilizer<V> + Clone>(
    now: Tick,
    stabilizer: &S,
    sample: &PortSample<V>,
    effort: V,
    bad: f64,
) -> Result<(), Violation> {
    for (field, flawed) in flawed(sample, bad, Mask::of(true)) {
        let mut stabilizer = stabilizer.clone();
        let effort_then = stabilizer.stabilize(&flawed, effort).effort;
        now.told(quantity::EFFORT)
            .finite(Law::Rejects, effort_then)
            .and_then(|()| recovers(now, &mut stabilizer, sample, effort))
            .map_err(|broken| broken.after(field, bad))?;
    }
    Ok(())
}

/// Check of one sample with a `period` that is not above 0, followed by a sound sample.
fn outlives<V: Signal>(
    now: Tick,
    mut stabilizer: impl Stabilizer<V>,
    sample: &PortSample<V>,
    effort: V,
    period: f64,
    manner: Manner<V>,
) -> Result<(), Violation> {
    let untimed = PortSample { period: V::Scalar::of(period), ..*sample };
    let correction = stabilizer.stabilize(&untimed, effort);
    let accepted = V::choose(correction.accepted, correction.effort, effort);
    now.told(quantity::EFFORT)
        .finite(Law::Rejects, correction.effort)
        .and_then(|()| {
            manner(now, &untimed, effort, &Correction { effort: accepted, ..correction })
        })
        .and_then(|()| recovers(now, &mut stabilizer, sample, effort))
        .map_err(|broken| broken.after("period", period))
}

/// Check of one bad effort, followed by the same sample with a sound one.
fn rejects<V: Signal>(
    now: Tick,
    mut stabilizer: impl Stabilizer<V>,
    sample: &PortSample<V>,
    effort: V,
    bad: f64,
) -> Result<(), Violation> {
    let rejected = stabilizer.stabilize(sample, V::splat(V::Scalar::of(bad)));
    now.told(quantity::EFFORT)
        .finite(Law::Rejects, rejected.effort)
        .and_then(|()| {
            now.told(quantity::REJECTION).holds::<V::Scalar>(Law::Rejects, !rejected.accepted)
        })
        .and_then(|()| recovers(now, &mut stabilizer, sample, effort))
        .map_err(|broken| broken.after("effort", bad))
}

/// Check of the sound sample that follows.
fn recovers<V: Signal>(
    now: Tick,
    stabilizer: &mut impl Stabilizer<V>,
    sample: &PortSample<V>,
    effort: V,
) -> Result<(), Violation> {
    let next = stabilizer.stabilize(sample, effort);
    now.told(quantity::NEXT_EFFORT).finite(Law::Recovers, next.effort)?;
    now.told(quantity::NEXT_ACCEPTANCE).holds::<V::Scalar>(Law::Recovers, next.accepted)
}
