//! Effects of adaptors on a port, and none at their neutral values.

use approx::abs_diff_eq;
use proptest::array::{uniform4, uniform16};
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    DampingLimit, HeldTick, Lolc, OnePort, PortEnergy, PortSample, Scalar, effects::OnePortExt,
    environments::Spring,
};

use crate::support::{
    Bits, CASES, Port, Real, Scripted, Spy, bad, drive_of, hold, hostile, ordinary, same, same_axes,
};

type Samples = Vec<[Bits; 16]>;

fn samples() -> impl proptest::strategy::Strategy<Value = Samples> {
    vec(uniform16(any::<Bits>()), 1..24)
}

/// Samples and efforts of ordinary or of hostile numbers, with one period throughout.
fn sequence<V: Port>(samples: &[[Bits; 16]]) -> (Vec<PortSample<V>>, Vec<V>) {
    let period = V::Scalar::of(1e-3);
    samples
        .iter()
        .map(|bits| drive_of::<V>(*bits, samples[0][15].is_multiple_of(2), period))
        .unzip()
}

fn same_drive<V: Port>(a: &PortSample<V>, b: &PortSample<V>) -> bool {
    same(a.period.f64(), b.period.f64())
        && same_axes(a.position, b.position)
        && same_axes(a.velocity, b.velocity)
        && same_axes(a.displacement, b.displacement)
        && same_axes(a.applied, b.applied)
        && same_axes(a.work, b.work)
}

mod check {
    use super::*;

    /// `held(1)`, `delayed(0)` and a saturation above any force change no bit, by themselves or together.
    pub(super) fn neutral_values_change_nothing<V: Port>() {
        hold(CASES, samples(), |samples| {
            let largest = V::Scalar::largest();
            let (drives, efforts) = sequence::<V>(&samples);
            let mut spies: [_; 4] = std::array::from_fn(|_| Spy::on(Scripted::of(efforts.clone())));
            let [one, two, three, four] = &mut spies;
            let mut held = one.held(1).expect("a hold");
            let mut delayed = two.delayed::<3>(0).expect("a delay");
            let mut saturated = three.saturated(largest).expect("a saturation");
            let mut all = four
                .held(1)
                .and_then(|port| port.saturated(largest))
                .and_then(|port| port.delayed::<0>(0))
                .expect("all three");
            for (sample, effort) in drives.iter().zip(&efforts) {
                let answers = [
                    held.respond(sample),
                    delayed.respond(sample),
                    saturated.respond(sample),
                    all.respond(sample),
                ];
                prop_assert!(answers.iter().all(|answer| same_axes(*answer, *effort)));
            }
            for Spy { asked, .. } in spies {
                prop_assert!(asked.len() == drives.len(), "not asked as often");
                prop_assert!(asked.iter().zip(&drives).all(|(a, b)| same_drive(a, b)));
            }
            Ok(())
        });
    }

    /// A hold asks on every n-th call and repeats the answer in between; the sums it passes on add up, axis by axis.
    pub(super) fn hold_hands_on_sums<V: Port>() {
        hold(CASES, (1..6u32, samples()), |(ticks, samples)| {
            let (drives, efforts) = sequence::<V>(&samples);
            let mut spy = Spy::on(Scripted::of(efforts.clone()));
            let mut held = (&mut spy).held(ticks).expect("a hold");
            for (tick, sample) in drives.iter().enumerate() {
                let effort = held.respond(sample);
                prop_assert!(same_axes(effort, efforts[tick / ticks as usize]), "not held");
            }
            prop_assert!(spy.asked.len() == drives.len().div_ceil(ticks as usize));
            for (call, whole) in spy.asked.iter().enumerate() {
                // From the call before, excluded, to this one.
                let now = call * ticks as usize;
                let since = (now + 1).saturating_sub(ticks as usize);
                let part = &drives[since..=now];
                let last = &drives[now];
                prop_assert!(same_axes(whole.position, last.position));
                prop_assert!(same_axes(whole.velocity, last.velocity));
                prop_assert!(same_axes(whole.applied, last.applied));
                let periods = [part.iter().map(|sample| sample.period.f64()).collect::<Vec<_>>()];
                adds_up::<V::Scalar>(whole.period, &periods[0])?;
                for axis in 0..V::AXES {
                    let each = |of: fn(&PortSample<V>) -> V| {
                        part.iter().map(|sample| of(sample).axis(axis).f64()).collect::<Vec<_>>()
                    };
                    adds_up(whole.work.axis(axis), &each(|sample| sample.work))?;
                    adds_up(whole.displacement.axis(axis), &each(|sample| sample.displacement))?;
                }
            }
            Ok(())
        });
    }

    /// The sum of a few terms is exact up to a rounding of each sum on the way, all of which are below `Σ |term|`.
    fn adds_up<T: Real>(sum: T, terms: &[f64]) -> TestCaseResult {
        let exact: f64 = terms.iter().sum();
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let bound = 2.0 * terms.len() as f64 * T::unit() * size;
        prop_assert!(abs_diff_eq!(sum.f64(), exact, epsilon = bound), "{sum:?} is not {exact:e}");
        Ok(())
    }

    /// `f(n − d)`, and 0 for `n < d`, for every d within the capacity.
    pub(super) fn delay_shifts<V: Port>() {
        hold(CASES, (0..6u32, samples()), |(ticks, samples)| {
            let (drives, efforts) = sequence::<V>(&samples);
            let delayed = Scripted::of(efforts.clone()).delayed::<4>(ticks);
            if ticks > 4 {
                prop_assert!(delayed.is_err(), "room for {ticks} in 4");
                return Ok(());
            }
            let mut delayed = delayed.expect("room for it");
            for (tick, sample) in drives.iter().enumerate() {
                let expected =
                    tick.checked_sub(ticks as usize).map_or_else(V::zero, |then| efforts[then]);
                prop_assert!(same_axes(delayed.respond(sample), expected), "at tick {tick}");
            }
            Ok(())
        });
    }

    /// Each axis is clipped by itself; a NaN does not pass for a force.
    pub(super) fn saturation_clips<V: Port>() {
        hold(CASES, (any::<Bits>(), samples()), |(bits, samples)| {
            let force = hostile::<V::Scalar>(bits);
            if force.f64() <= 0.0 {
                prop_assert!(Scripted::of(vec![V::zero()]).saturated(force).is_err());
                return Ok(());
            }
            let (drives, mut efforts) = sequence::<V>(&samples);
            let wrong = V::from_axes(|axis| match axis {
                0 => bad(bits >> 20),
                _ => efforts[0].axis(axis),
            });
            efforts[0] = wrong;
            let mut port = Scripted::of(efforts.clone()).saturated(force).expect("a saturation");
            for (sample, effort) in drives.iter().zip(efforts) {
                let clipped = port.respond(sample);
                for (clipped, effort) in clipped.axes().zip(effort.axes()) {
                    let (clipped, effort, force) = (clipped.f64(), effort.f64(), force.f64());
                    let expected =
                        if effort.is_nan() { effort } else { effort.clamp(-force, force) };
                    prop_assert!(same(clipped, expected), "{effort:e} to {clipped:e}");
                }
            }
            Ok(())
        });
    }

    /// `v = Δx / T` on each axis, rounded once, and no other change.
    pub(super) fn difference_divides<V: Port>() {
        hold(CASES, samples(), |samples| {
            let (drives, efforts) = sequence::<V>(&samples);
            let mut spy = Spy::on(Scripted::of(efforts));
            for sample in &drives {
                (&mut spy).differenced().respond(sample);
            }
            for (told, sample) in spy.asked.iter().zip(&drives) {
                let velocity = V::from_axes(|axis| sample.displacement.axis(axis) / sample.period);
                let expected = PortSample { velocity, ..*sample };
                prop_assert!(same_drive(told, &expected), "{told:?}");
            }
            Ok(())
        });
    }

    /// Counts of the resolution, displacements between them, and the work of the effort over these.
    pub(super) fn encoder_counts<V: Port>() {
        hold(CASES, (any::<Bits>(), samples()), |(bits, samples)| {
            let (drives, efforts) = sequence::<V>(&samples);
            let resolution = V::Scalar::of(2f64.powi(-((bits % 12) as i32)));
            let mut spy = Spy::on(Scripted::of(efforts));
            let mut encoded = (&mut spy).encoded(resolution).expect("an encoder");
            for sample in &drives {
                encoded.respond(sample);
            }
            let mut before = spy.asked[0].position;
            for (told, sample) in spy.asked.iter().zip(&drives) {
                for axis in 0..V::AXES {
                    // A power of two loses nothing, so the standard library rounds the same way.
                    let (x, step) = (sample.position.axis(axis).f64(), resolution.f64());
                    let counted = (x / step).round() * step;
                    prop_assert!(told.position.axis(axis).f64() == counted, "{x:e} at {step:e}");
                }
                let displacement = told.position - before;
                before = told.position;
                let work = sample.applied.times(displacement);
                let position = told.position;
                let expected = PortSample { position, displacement, work, ..*sample };
                prop_assert!(*told == expected, "{told:?}");
            }
            Ok(())
        });
    }

    /// A stabilizer outside of a hold may correct on every tick, one inside only when the environment is asked.
    pub(super) fn order_matters<V: Port>() {
        hold(CASES / 10, uniform4(any::<Bits>()), |bits| {
            let of = |value: f64| V::Scalar::of(value);
            let limit = DampingLimit::at(of(5.0)).expect("a limit");
            let watcher = Lolc::new(PortEnergy, limit);
            let spring = Spring::new(of(100.0)).expect("a spring");
            let hold = 2 + (bits[0] % 9) as u32;
            let mut outside = spring.held(hold).expect("a hold").stabilized(watcher);
            let mut inside = spring.stabilized(watcher).held(hold).expect("a hold");
            let flow = V::from_axes(|axis| ordinary::<V::Scalar>(bits[1 + axis], 0.5) + of(1.0));
            let still = |axis: f64| V::from_axes(|_| of(axis));
            let push = |tick: u32| {
                // The port gives energy away on every tick but the first.
                let applied = if tick == 0 { V::zero() } else { still(-2.0) };
                HeldTick {
                    period: of(1e-3),
                    position: still(0.0),
                    velocity: flow,
                    displacement: flow.scale(of(1e-3)),
                    applied,
                }
                .sample()
            };
            let mut injected = V::zero();
            for tick in 0..40 {
                let (sample, asked) = (push(tick), tick % hold == 0);
                let corrected = outside.respond(&sample);
                prop_assert!((corrected != V::zero()) == (tick > 0), "outside, tick {tick}");
                let later = inside.respond(&sample);
                prop_assert!(
                    asked || same_axes(later, injected),
                    "inside, tick {tick} is not held"
                );
                prop_assert!(!asked || (later != V::zero()) == (tick > 0), "inside, tick {tick}");
                injected = later;
                if asked {
                    // By now both have received the same work.
                    let (a, b) = (
                        outside.correction().observed_energy.f64(),
                        inside.correction().observed_energy.f64(),
                    );
                    prop_assert!(abs_diff_eq!(a, b, epsilon = 200.0 * V::Scalar::unit() * a.abs()));
                }
            }
            Ok(())
        });
    }
}

crate::support::every_port!(
    neutral_values_change_nothing,
    hold_hands_on_sums,
    delay_shifts,
    saturation_clips,
    difference_divides,
    encoder_counts,
    order_matters,
);

/// A round trip has no displacement and still does work; a hold passes that work on.
#[test]
fn hold_keeps_the_work_of_a_round_trip() {
    let mut spy = Spy::on(Scripted::of(vec![1.0; 3]));
    let mut held = (&mut spy).held(2).expect("a hold");
    held.respond(&PortSample::starting(0.5, 0.0, 0.0));
    held.respond(
        &HeldTick { period: 0.5, position: 2.0, velocity: 4.0, displacement: 2.0, applied: 3.0 }
            .sample(),
    );
    held.respond(
        &HeldTick { period: 0.5, position: 0.0, velocity: -4.0, displacement: -2.0, applied: 1.0 }
            .sample(),
    );
    let PortSample { period, displacement, work, .. } = spy.asked[1];
    assert_eq!((period, displacement, work), (1.0, 0.0, 4.0));
}

mod rounding {
    //! Operations on whole numbers, in the library and in the standard library.

    use super::*;
    use crate::support::wild;

    fn check<T: Real>() {
        hold(CASES, uniform4(any::<Bits>()), |bits| {
            let whole = 1.0 / T::epsilon().f64();
            let near_tie = T::of((unit_range(bits[2]) * 4096.0).trunc() + 0.5);
            let beside = T::of_bits(bits_of(near_tie).wrapping_add(bits[3] % 3).wrapping_sub(1));
            let large = T::of((bits[2] % 64) as f64 / 8.0 + whole / 2.0 - 4.0);
            for x in [hostile::<T>(bits[0]), wild(bits[1]), near_tie, beside, large, -large] {
                let (found, exact) = (x.rounded().f64(), x.f64().round());
                prop_assert!(
                    found == exact || (found.is_nan() && exact.is_nan()),
                    "{x:?}: {found:e}"
                );
            }
            Ok(())
        });
    }

    fn unit_range(bits: Bits) -> f64 {
        2.0 * crate::support::unit(bits) - 1.0
    }

    fn bits_of<T: Real>(x: T) -> Bits {
        // The bits of 1 tell `f32` from `f64`.
        let single = T::of_bits(u64::from(1f32.to_bits())).f64() == 1.0;
        if single { u64::from((x.f64() as f32).to_bits()) } else { x.f64().to_bits() }
    }

    #[test]
    fn f32() {
        check::<f32>();
    }

    #[test]
    fn f64() {
        check::<f64>();
        assert_eq!(0.499_999_999_999_999_94.rounded(), 0.0);
        assert_eq!((-2.5f64).rounded(), -3.0);
    }
}
