//! POPC against the passivity observer and controller of Hannaford and Ryu, and against LOLC without a credit.

use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, LyapunovCandidate, OnePort, Plant, Popc,
    PortEnergy, PortSample, Scalar, Stabilizer,
    bodies::{Body, Impedance},
    environments::Spring,
};

use crate::support::{Bits, Port, Real, Stream, log_between, ordinary, power, same, same_axes};

/// Hannaford and Ryu, IEEE Transactions on Robotics and Automation 18(1), 2002, in impedance causality: the observed
/// energy including what the controller has dissipated so far, and the damping that brings it back to zero.
#[derive(Default)]
struct PassivityController {
    energy: f64,
    alpha: f64,
    flow_squared: f64,
    /// The magnitudes of all energies in the sum, to scale its roundings by.
    size: f64,
}

impl PassivityController {
    fn step(&mut self, force: &[f64], flow: &[f64], flow_squared: f64, period: f64) {
        let burnt = self.alpha * self.flow_squared * period;
        let power: f64 = force.iter().zip(flow).map(|(f, v)| f * v).sum();
        let through: f64 = force.iter().zip(flow).map(|(f, v)| (f * v).abs()).sum();
        self.energy += power * period + burnt;
        self.size += through * period + burnt;
        self.alpha = if self.energy < 0.0 { -self.energy / (flow_squared * period) } else { 0.0 };
        self.flow_squared = flow_squared;
    }
}

/// The energy of a port, summed by hand: the spring candidate of the paper's example 1.
struct SpringCandidate;

impl<V: Port> LyapunovCandidate<V> for SpringCandidate {
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let work = |axis: usize| sample.applied.axis(axis) * sample.displacement.axis(axis);
        match V::AXES {
            1 => work(0),
            _ => (work(0) + work(2)) + work(1),
        }
    }
}

fn equal<V: Port>(a: Correction<V>, b: Correction<V>) -> TestCaseResult {
    let scalars = |a: Correction<V>| [a.observed_energy, a.alpha, a.shortfall].map(Real::f64);
    let (one, other) = (scalars(a), scalars(b));
    prop_assert!(one.iter().zip(other).all(|(a, b)| same(*a, b)), "{one:?} is not {other:?}");
    prop_assert!(same_axes(a.effort, b.effort) && a.accepted == b.accepted, "{a:?} is not {b:?}");
    Ok(())
}

mod check {
    use proptest::array::{uniform8, uniform16};
    use proptest::collection::vec;
    use proptest::prelude::any;

    use super::*;
    use crate::support::{CASES, drive_of, hold, stream};

    /// With sampled work and without a limit, on ordinary numbers.
    pub(super) fn is_hannaford_and_ryu<V: Port>() {
        let samples = vec(uniform16(any::<Bits>()), 1..32);
        hold(CASES, (any::<Bits>(), samples), |(rate, samples)| {
            let no_limit = DampingLimit::at(V::Scalar::of(f64::INFINITY)).expect("no limit");
            let mut popc: Popc<V::Scalar, _> = Lolc::new(PortEnergy, no_limit).sampled();
            let mut reference = PassivityController::default();
            let period = V::Scalar::of(log_between(rate, 1e-4, 0.1));
            for bits in samples {
                let (sample, effort) = drive_of::<V>(bits, true, period);
                let correction = popc.stabilize(&sample, effort);
                let list = |signal: V| signal.axes().map(Real::f64).collect::<Vec<_>>();
                let flow_squared = list(sample.velocity).iter().map(|v| v * v).sum();
                let t = period.f64();
                reference.step(&list(effort), &list(sample.velocity), flow_squared, t);
                let bound = 128.0 * V::Scalar::unit() * reference.size;
                let off = (correction.observed_energy.f64() - reference.energy).abs();
                prop_assert!(off <= bound, "energy off by {off:e}, {bound:e} allowed");
                let off = (correction.alpha.f64() - reference.alpha).abs() * flow_squared * t;
                prop_assert!(off <= bound, "burns {off:e} more or less, {bound:e} allowed");
            }
            Ok(())
        });
    }

    /// A spring candidate, a credit of zero and no credit are the same controller, bit for bit.
    pub(super) fn is_lolc_without_credit<V: Port>() {
        hold(CASES, stream::<V>(true), |Stream { limit, samples, .. }| {
            let nothing = Dissipation::of(V::Scalar::of(0.0)).expect("no damping");
            let mut popc: Popc<V::Scalar> = Popc::new(PortEnergy, limit);
            let mut credited = Lolc::new((PortEnergy, nothing), limit);
            let mut spring = Lolc::new(SpringCandidate, limit);
            let mut sound = true;
            for (sample, effort) in samples {
                let correction = popc.stabilize(&sample, effort);
                // Without a credit a bad velocity does not affect the decrease.
                sound &=
                    power(sample.velocity).f64().is_finite() && sample.period.f64().is_finite();
                if sound {
                    equal(correction, credited.stabilize(&sample, effort))?;
                }
                let whole = PortSample { work: V::zero(), ..sample };
                let told = sample.work == sample.applied.times(sample.displacement);
                if told {
                    equal(correction, spring.stabilize(&whole, effort))?;
                } else {
                    return Ok(());
                }
            }
            Ok(())
        });
    }

    /// The same on closed loops, with the environment of the paper's example 1.
    pub(super) fn closes_the_same_loop<V: Port>() {
        hold(CASES, uniform8(any::<Bits>()), |bits| {
            let of = V::Scalar::of;
            let period = of(log_between(bits[0], 1e-3, 0.01));
            let impedance = Impedance { mass: of(0.3), damping: of(0.201), stiffness: of(50.0) };
            let start = V::from_axes(|axis| ordinary(bits[1 + axis], 0.005));
            let body = Body::new(impedance, period).expect("a body").starting(start, V::zero());
            let limit = DampingLimit::of_mass(of(0.5), of(0.3), period).expect("a limit");
            let spring = Spring::new(of(log_between(bits[4], 1e2, 3e3))).expect("a spring");
            let nothing = Dissipation::of(of(0.0)).expect("no damping");
            let mut popc = spring.stabilized(Popc::new(PortEnergy, limit));
            let mut lolc = spring.stabilized(Lolc::new((PortEnergy, nothing), limit));
            let mut own = spring.stabilized(Lolc::new(SpringCandidate, limit));
            let (mut one, mut two, mut three) = (body, body, body);
            let (mut a, mut b, mut c) = (body.start(), body.start(), body.start());
            let mut applied = false;
            for _ in 0..60 {
                (a, b, c) = (
                    one.advance(popc.respond(&a)),
                    two.advance(lolc.respond(&b)),
                    three.advance(own.respond(&c)),
                );
                equal(popc.correction(), lolc.correction())?;
                equal(popc.correction(), own.correction())?;
                applied |= popc.correction().alpha > of(0.0);
            }
            prop_assert!(
                applied || start == V::zero(),
                "a held spring gains energy, but nothing applied"
            );
            Ok(())
        });
    }
}

crate::support::every_port!(is_hannaford_and_ryu, is_lolc_without_credit, closes_the_same_loop);
