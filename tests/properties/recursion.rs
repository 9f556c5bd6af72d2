//! Ledger against the recursion of the tick contract in straight code, carried in double-double.

use approx::abs_diff_eq;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    Dissipation, Lolc, LyapunovCandidate, PortEnergy, Scalar, Stabilizer,
    accumulators::{Accumulator, Compensated, Plain, Wide},
};

use crate::support::{Book, Credit, Ledger, Port, Real, Stream};

/// Every output of a stabilizer is the recursion's, up to the roundings that the recursion counts.
fn follows<V: Port>(
    mut stabilizer: impl Stabilizer<V>,
    book: Book,
    credit: Credit<V::Scalar>,
    stream: &Stream<V>,
) -> TestCaseResult {
    let mut ledger = Ledger::new(book, credit, stream.limit);
    let unit = V::Scalar::unit();
    for &(sample, effort) in &stream.samples {
        let correction = stabilizer.stabilize(&sample, effort);
        let tick = ledger.tick(&sample, effort);
        let accepted = tick.accepted.unwrap_or(correction.accepted);
        prop_assert!(correction.accepted == accepted, "accepted {} {tick:?}", correction.accepted);
        let (sum, alpha) = (correction.observed_energy.f64(), correction.alpha.f64());
        prop_assert!(
            abs_diff_eq!(sum, tick.sum, epsilon = tick.error),
            "sum {sum} is not {tick:?}"
        );
        let short = (correction.shortfall.f64() - tick.shortfall).abs();
        if !accepted {
            ledger.rejected();
            prop_assert!(short <= tick.error, "shortfall {short} off {tick:?}");
            continue;
        }
        // α is as accurate as the debt, and rounded to within a few units.
        let square = tick.square.f64();
        let slack = tick.error + 16.0 * unit * sum.abs();
        let least = V::Scalar::smallest_positive().f64() * square;
        let off = (alpha - tick.alpha).abs() * square;
        prop_assert!(off <= slack + least, "alpha {alpha} is not {tick:?}");
        prop_assert!(short <= 2.0 * slack + least, "shortfall {short} off {tick:?}");
        for axis in 0..V::AXES {
            let flow = sample.velocity.axis(axis).f64();
            let expected = effort.axis(axis).f64() + alpha * flow;
            let size = effort.axis(axis).f64().abs() + (alpha * flow).abs();
            let off = (correction.effort.axis(axis).f64() - expected).abs();
            let bound = 8.0 * unit * size + V::Scalar::smallest_positive().f64();
            prop_assert!(off <= bound || size > V::Scalar::largest().f64(), "effort off {off}");
        }
    }
    Ok(())
}

fn each_work<V, C, A>(candidate: C, credit: Credit<V::Scalar>, stream: &Stream<V>) -> TestCaseResult
where
    V: Port,
    C: LyapunovCandidate<V> + Copy,
    A: Accumulator<V::Scalar>,
{
    let lolc = Lolc::new(candidate, stream.limit).summed_in::<A>();
    follows(lolc, Book::Held, credit, stream)?;
    follows::<V>(lolc.sampled(), Book::Sampled, credit, stream)
}

fn each_candidate<V: Port, A: Accumulator<V::Scalar>>(stream: &Stream<V>) -> TestCaseResult {
    let Stream { damping, surface, .. } = *stream;
    let damper = Dissipation::of(damping).expect("a damping");
    let contact = V::contact(damping, surface);
    each_work::<V, _, A>(PortEnergy, Credit::None, stream)?;
    each_work::<V, _, A>((PortEnergy, damper), Credit::Always(damping), stream)?;
    each_work::<V, _, A>((PortEnergy, contact), Credit::InContact(damping, surface), stream)
}

mod check {
    use super::*;
    use crate::support::{CASES, hold, stream};

    pub(super) fn plain<V: Port>() {
        hold(CASES, stream::<V>(true), |stream| each_candidate::<V, Plain<V::Scalar>>(&stream));
    }

    pub(super) fn compensated<V: Port>() {
        hold(CASES, stream::<V>(true), |stream| {
            each_candidate::<V, Compensated<V::Scalar>>(&stream)
        });
    }

    pub(super) fn wide<V: Port<Scalar = f32>>() {
        hold(CASES, stream::<V>(true), |stream| each_candidate::<V, Wide<f32>>(&stream));
    }
}

crate::support::every_port!(plain, compensated);
crate::support::each_type!(wide: f32_scalar = f32, f32_vector = nalgebra::Vector3<f32>);
