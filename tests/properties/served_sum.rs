//! Laws of the served energy, `L + α v² T`, recomputed from what a stabilizer reports.

use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    Correction, Dissipation, HeldTick, Lolc, LyapunovCandidate, PortEnergy, PortSample, Scalar,
    Stabilizer,
    accumulators::{Accumulator, Compensated, Plain, Wide},
};

use crate::support::{Port, Real, Stream, power};

/// The quantities of the laws, on one tick.
struct Seen<V: Port> {
    sample: PortSample<V>,
    effort: V,
    limit: V::Scalar,
    correction: Correction<V>,
}

impl<V: Port> Seen<V> {
    /// `α` is rounded to a few units in the last place only where it and the energy it dissipates are normal numbers.
    fn roundable(&self) -> bool {
        let tiny = V::Scalar::smallest_normal();
        self.correction.alpha >= tiny && self.correction.alpha * self.square() >= tiny
    }

    fn square(&self) -> V::Scalar {
        power(self.sample.velocity) * self.sample.period
    }

    /// The bounds that hold for every sample, sound or not.
    fn bounds(&self) -> TestCaseResult {
        let Correction { effort, observed_energy: sum, alpha, shortfall, accepted } =
            self.correction;
        let zero = V::Scalar::of(0.0);
        prop_assert!(effort.all_finite(), "effort {effort:?}");
        prop_assert!(sum.f64().is_finite(), "sum {sum:?}");
        prop_assert!(shortfall.f64().is_finite() && shortfall >= zero, "shortfall {shortfall:?}");
        prop_assert!(alpha >= zero && alpha <= self.limit, "alpha {alpha:?}");
        if !accepted {
            prop_assert!(effort == V::zero() && alpha == zero, "a correction of a bad sample");
            prop_assert!(
                shortfall == -sum || (sum >= zero && shortfall == zero),
                "of a bad sample"
            );
        }
        Ok(())
    }

    /// The contract for an accepted sample.
    fn served(&self) -> TestCaseResult {
        let Correction { observed_energy: sum, alpha, shortfall, .. } = self.correction;
        let (zero, tiny) = (V::Scalar::of(0.0), V::Scalar::smallest_normal());
        let square = self.square();
        let burnt = alpha * square;
        if sum >= zero {
            prop_assert!(alpha == zero && shortfall == zero, "nothing is owed");
        } else if square <= tiny {
            prop_assert!(alpha == zero && shortfall == -sum, "nothing can be served");
        } else {
            let served = sum + burnt;
            prop_assert!(served + shortfall >= zero, "served {served:?}, short {shortfall:?}");
            if alpha < self.limit && self.roundable() {
                prop_assert!(served >= zero, "served {served:?}");
                prop_assert!(shortfall == zero, "short of {shortfall:?} below the limit");
                self.in_any_order()?;
            }
        }
        Ok(())
    }

    /// Readers who multiply in another order also find the served energy not negative, as long as none of their
    /// products is too small to be rounded to a unit in the last place.
    fn in_any_order(&self) -> TestCaseResult {
        let (alpha, period) = (self.correction.alpha, self.sample.period);
        let square = power(self.sample.velocity);
        let tiny = V::Scalar::smallest_normal();
        for (first, then) in [(alpha * square, period), (alpha * period, square)] {
            let served = self.correction.observed_energy + first * then;
            let rounded = first >= tiny && first * then >= tiny && square >= tiny;
            prop_assert!(!rounded || served >= V::Scalar::of(0.0), "{served:?} in another order");
        }
        Ok(())
    }

    /// The correction pushes no axis in the direction of its motion.
    fn opposes(&self) -> TestCaseResult {
        for axis in 0..V::AXES {
            let (before, after) = (self.effort.axis(axis), self.correction.effort.axis(axis));
            let flow = self.sample.velocity.axis(axis);
            let zero = Scalar::of(0.0);
            prop_assert!(flow < zero || after >= before, "axis {axis} is pushed on");
            prop_assert!(flow > zero || after <= before, "axis {axis} is pushed on");
        }
        Ok(())
    }
}

fn laws<V: Port>(mut stabilizer: impl Stabilizer<V>, stream: &Stream<V>) -> TestCaseResult {
    for &(sample, effort) in &stream.samples {
        let correction = stabilizer.stabilize(&sample, effort);
        let seen = Seen { sample, effort, limit: stream.limit.most(), correction };
        seen.bounds()?;
        if correction.accepted {
            seen.served()?;
            seen.opposes()?;
        }
    }
    Ok(())
}

fn each_work<V, C, A>(candidate: C, stream: &Stream<V>) -> TestCaseResult
where
    V: Port,
    C: LyapunovCandidate<V> + Copy,
    A: Accumulator<V::Scalar>,
{
    let lolc = Lolc::new(candidate, stream.limit).summed_in::<A>();
    laws(lolc, stream)?;
    laws::<V>(lolc.sampled(), stream)
}

/// POPC and LOLC with each candidate, over held and sampled work.
fn each_candidate<V: Port, A: Accumulator<V::Scalar>>(stream: &Stream<V>) -> TestCaseResult {
    let damper = Dissipation::of(stream.damping).expect("a damping");
    let contact = V::contact(stream.damping, stream.surface);
    each_work::<V, _, A>(PortEnergy, stream)?;
    each_work::<V, _, A>((PortEnergy, damper), stream)?;
    each_work::<V, _, A>((PortEnergy, contact), stream)?;
    each_work::<V, _, A>((PortEnergy, damper, contact), stream)
}

fn each_sum<V: Port>(stream: &Stream<V>) -> TestCaseResult {
    each_candidate::<V, Plain<V::Scalar>>(stream)?;
    each_candidate::<V, Compensated<V::Scalar>>(stream)
}

mod check {
    use proptest::array::{uniform8, uniform16};
    use proptest::collection::vec;

    use super::*;
    use crate::support::{Bits, CASES, hold, stream, unit, wild};
    use lyapunov::DampingLimit;

    pub(super) fn sound<V: Port>() {
        hold(CASES, stream::<V>(false), |stream| each_sum(&stream));
    }

    pub(super) fn with_bad_samples<V: Port>() {
        hold(CASES, stream::<V>(true), |stream| each_sum(&stream));
    }

    /// Near the end of the scalar's range: values that fit are accepted as they are.
    pub(super) fn fits_the_range<V: Port>() {
        hold(CASES, uniform8(any::<Bits>()), |bits| {
            let of = |value: f64| V::Scalar::of(value);
            // Sum, v² T and efforts, together not above 0.96 of the largest number.
            let largest = V::Scalar::largest().f64();
            let share = |at: usize, most: f64| most * unit(bits[at]) * largest;
            let applied = V::from_axes(|axis| of(share(axis, 0.08)));
            let velocity = V::from_axes(|axis| of(share(3 + axis % 2, 0.08).sqrt()));
            let effort = V::from_axes(|axis| of(-share(5 + axis, 0.16)));
            let limit = DampingLimit::at(of(1.0)).expect("a limit");
            let mut popc = Lolc::new(PortEnergy, limit);
            let sample = HeldTick {
                period: of(1.0),
                position: V::zero(),
                velocity,
                displacement: V::splat(of(1.0)),
                applied,
            }
            .sample();
            let correction = popc.stabilize(&sample, effort);
            prop_assert!(correction.accepted && correction.effort == effort, "{correction:?}");
            Ok(())
        });
    }

    pub(super) fn wide<V: Port<Scalar = f32>>() {
        hold(CASES, stream::<V>(true), |stream| each_candidate::<V, Wide<f32>>(&stream));
    }

    /// Debts and motions at the ends of the range: where α or its reciprocal underflows, what is missing is told in full.
    pub(super) fn at_the_ends<V: Port>() {
        let of = |value: f64| V::Scalar::of(value);
        let (least, most) = (V::Scalar::smallest_positive(), V::Scalar::largest());
        let tiny = V::Scalar::smallest_normal();
        let sizes = [1.0, 1.5, 3.0, 1e3, 1e10, 1e25].map(of);
        let ends = |from: V::Scalar| sizes.map(|size| from * size);
        let inverse = [1.0, 2.0, 4.0, 1e3].map(|size| most / of(size));
        let debts = [ends(least), ends(tiny), sizes].concat();
        let squares = [&ends(tiny)[..], &sizes, &inverse].concat();
        for limit in [0.0, 1.0, f64::INFINITY].map(of) {
            for (debt, square) in
                debts.iter().flat_map(|debt| squares.iter().map(move |s| (*debt, *s)))
            {
                let mut popc = Lolc::new(PortEnergy, DampingLimit::at(limit).expect("a limit"));
                let one = V::from_axes(|axis| of(if axis == 0 { 1.0 } else { 0.0 }));
                let still = PortSample::starting(square, V::zero(), one);
                let sample = PortSample { work: one.scale(-debt), ..still };
                let correction = popc.stabilize(&sample, V::zero());
                let Correction { alpha, shortfall, observed_energy, .. } = correction;
                told(correction.accepted, &correction);
                told(observed_energy + alpha * square + shortfall >= of(0.0), &correction);
                told(alpha >= of(0.0) && alpha <= limit.smaller(most), &correction);
                told(alpha > of(0.0) || shortfall == debt, &correction);
            }
        }
    }

    #[track_caller]
    fn told<V: Port>(kept: bool, correction: &Correction<V>) {
        assert!(kept, "{correction:?}");
    }

    fn finite<V: Port>(
        mut lolc: impl Stabilizer<V>,
        limit: V::Scalar,
        samples: &[[Bits; 16]],
    ) -> TestCaseResult {
        for bits in samples {
            let signal = |at: usize| V::from_axes(|axis| wild(bits[at + axis]));
            let sample = HeldTick {
                period: wild(bits[15]),
                position: V::zero(),
                velocity: signal(0),
                displacement: signal(3),
                applied: signal(6),
            }
            .sample();
            let effort = signal(9);
            let correction = lolc.stabilize(&sample, effort);
            Seen { sample, effort, limit, correction }.bounds()?;
        }
        Ok(())
    }

    /// Numbers of every bit pattern: every result is finite.
    pub(super) fn any_bits<V: Port>() {
        hold(CASES, vec(uniform16(any::<Bits>()), 1..16), |samples| {
            for limit in [0.0, 15.0, f64::INFINITY] {
                let limit = DampingLimit::at(V::Scalar::of(limit)).expect("a limit");
                let credit = Dissipation::of(V::Scalar::of(0.2)).expect("a damping");
                let lolc = Lolc::new((PortEnergy, credit), limit);
                finite::<V>(lolc, limit.most(), &samples)?;
                finite::<V>(lolc.sampled(), limit.most(), &samples)?;
                let lolc = lolc.summed_in::<Compensated<V::Scalar>>();
                finite::<V>(lolc, limit.most(), &samples)?;
                finite::<V>(lolc.sampled(), limit.most(), &samples)?;
            }
            Ok(())
        });
    }
}

crate::support::every_port!(sound, with_bad_samples, fits_the_range, at_the_ends, any_bits);
crate::support::each_type!(wide: f32_scalar = f32, f32_vector = nalgebra::Vector3<f32>);
