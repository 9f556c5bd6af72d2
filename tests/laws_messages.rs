//! Messages of the laws: each breach tells its sample, force, number, tolerance, unit and likely cause.

use lyapunov::lanes::AutoF64x4;
use lyapunov::laws::{self, Allowed, Drive, Law, Samples, Violation};
use lyapunov::{
    Correction, DampingLimit, Lolc, LyapunovCandidate, Mask, OnePort, Plant, PortEnergy,
    PortSample, Scalar, Signal, Stabilizer,
    bodies::{Body, Impedance},
    environments::Wall,
    integrators::{Oscillator, SemiImplicitEuler, State},
    models::LyapunovFunction,
};
use nalgebra::{Vector2, Vector3};

const PERIOD: f64 = 1e-3;

fn popc() -> Lolc<f64, PortEnergy> {
    Lolc::new(PortEnergy, DampingLimit::at(100.0).expect("a limit"))
}

/// A stabilizer made of a closure.
#[derive(Clone)]
struct Told<F>(F);

impl<V: Signal, F: Fn(&PortSample<V>, V) -> Correction<V>> Stabilizer<V> for Told<F> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        (self.0)(sample, effort)
    }
}

/// What a stabilizer makes of a right correction.
type Spoil = fn(&PortSample<f64>, f64, Correction<f64>) -> Correction<f64>;

/// A stabilizer that spoils what POPC does.
#[derive(Clone)]
struct Spoilt(Lolc<f64, PortEnergy>, Spoil);

impl Stabilizer<f64> for Spoilt {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let correction = self.0.stabilize(sample, effort);
        (self.1)(sample, effort, correction)
    }
}

/// The sample of that number among those that ship, and its effort.
fn sample_of<V: Signal>(tick: usize) -> (PortSample<V>, V) {
    Samples::new(V::Scalar::of(PERIOD)).nth(tick).expect("a sample")
}

#[track_caller]
fn tells(broken: &Violation, parts: &[&str]) {
    let told = broken.to_string();
    for part in parts {
        assert!(told.contains(part), "no `{part}` in\\n{told}");
    }
}

#[test]
fn sample_force_number_tolerance_unit_and_cause() {
    let pulls = Told(|sample: &PortSample<f64>, effort| {
        Correction::none(effort - 3.0 * sample.velocity).checked()
    });
    let broken = laws::stabilizer(&pulls, Samples::new(PERIOD)).expect_err("broken");
    let (sample, effort) = sample_of::<f64>(broken.tick);
    let v = sample.velocity;
    assert_eq!((broken.law, broken.tick, broken.quantity.unit), (Law::Opposes, 0, "W"));
    approx::assert_relative_eq!(broken.value, -3.0 * v * v, max_relative = 1e-9);
    // Rounding of terms as large as the two efforts.
    let size = ((effort - 3.0 * v).abs() + effort.abs()) * v.abs();
    let least = -(16.0 * f64::EPSILON * size + f64::MIN_POSITIVE);
    assert_eq!(broken.allowed, Allowed::From(least));
    let drive = Drive {
        effort,
        applied: sample.applied,
        velocity: v,
        displacement: sample.displacement,
        period: PERIOD,
        spoilt: None,
    };
    assert_eq!(broken.drive, Some(drive));
    tells(
        &broken,
        &[
            "sample 0: the correction must not feed power into the motion; the power",
            &format!("is {:.3e} W, allowed from {least:.3e} W on;", broken.value),
            &format!("driven by {effort:.3e} N at {v:.3e} m/s over 1.000e-3 s"),
            &format!("{:.3e} N applied before over {:.3e} m;", sample.applied, sample.displacement),
            "likely cause: a sign",
        ],
    );
}

#[test]
fn a_ledger_tells_what_was_allowed() {
    let forgets = Spoilt(popc(), |_, _, told: Correction<f64>| Correction {
        observed_energy: told.observed_energy * (1.0 + 1e-9),
        ..told
    });
    let samples = Samples::<f64>::new(PERIOD);
    let broken = laws::ledger(&forgets, &PortEnergy, 100.0, samples).expect_err("broken");
    assert_eq!((broken.law, broken.quantity.unit), (Law::Balances, "J"));
    let (mut sum, mut absolute, mut largest) = (0.0_f64, 0.0, 0.0_f64);
    for (sample, _) in samples.take(broken.tick + 1) {
        sum += sample.work;
        absolute += sample.work.abs();
        largest = largest.max(sum.abs());
    }
    let ticks = (broken.tick + 1) as f64;
    let allowed = 2.0 * f64::EPSILON * (absolute + ticks * largest);
    let Allowed::Within(told) = broken.allowed else { panic!("{broken}") };
    approx::assert_relative_eq!(told, allowed, max_relative = 1e-9);
    assert!(broken.value.abs() > told && broken.value.abs() < 2e-9 * largest, "{broken}");
    tells(
        &broken,
        &[
            "supplied must be stored, dissipated and shortfall together; the account is off by",
            &format!("{:.3e} J, allowed is {allowed:.3e} J; driven by", broken.value),
            "likely cause: a ledger that books something else than the candidate's decrease",
        ],
    );

    // What it tells to dissipate is halved in the effort.
    let halved = Spoilt(popc(), |sample: &PortSample<f64>, effort, told: Correction<f64>| {
        let out = if told.accepted { 0.5 * told.alpha * sample.velocity } else { 0.0 };
        Correction { effort: if told.accepted { effort + out } else { 0.0 }, ..told }
    });
    laws::stabilizer(&halved, samples).expect("what it tells adds up");
    let broken = laws::ledger(&halved, &PortEnergy, 100.0, samples).expect_err("broken");
    let (sample, _) = sample_of::<f64>(broken.tick);
    assert_eq!((broken.law, broken.quantity.unit), (Law::Injects, "W"));
    assert!(broken.value < 0.0 && broken.value > -100.0 * sample.velocity * sample.velocity);
    tells(
        &broken,
        &["the damping that is told must be in the effort; the power taken less", "clipped"],
    );

    let strong = Spoilt(popc(), |sample: &PortSample<f64>, effort, told: Correction<f64>| {
        let pushed = if told.alpha > 0.0 { 101.0 * sample.velocity } else { 0.0 };
        Correction { effort: effort + pushed, ..told }
    });
    let broken = laws::ledger(&strong, &PortEnergy, 100.0, samples).expect_err("broken");
    assert_eq!(broken.law, Law::WithinLimit);
    let (sample, _) = sample_of::<f64>(broken.tick);
    approx::assert_relative_eq!(broken.value, -sample.velocity.abs(), max_relative = 1e-6);
    tells(
        &broken,
        &["the limit less the correction is", " N, allowed from -", "held below its limit"],
    );
}

#[test]
fn the_field_that_was_replaced_is_named() {
    let blind = Told(|sample: &PortSample<f64>, effort: f64| {
        let pushed = effort + 2.0 * sample.velocity;
        if effort.is_finite() {
            Correction { alpha: 2.0, ..Correction::none(pushed) }
        } else {
            Correction { accepted: false, ..Correction::none(0.0) }
        }
    });
    let broken = laws::stabilizer(&blind, Samples::new(PERIOD)).expect_err("broken");
    assert_eq!(broken.law, Law::Rejects);
    let (sample, _) = sample_of::<f64>(broken.tick);
    let drive = broken.drive.expect("a drive");
    assert_eq!((drive.velocity, drive.spoilt.map(|it| it.0)), (sample.velocity, Some("velocity")));
    assert!(drive.spoilt.expect("a field").1.is_nan());
    tells(
        &broken,
        &["the effort is NaN N;", "with its velocity replaced by NaN;", "`Correction::checked()`"],
    );

    let accepts = Told(|_: &PortSample<f64>, effort: f64| {
        Correction::none(if effort.is_finite() { effort } else { 0.0 })
    });
    let broken = laws::stabilizer(&accepts, Samples::new(PERIOD)).expect_err("broken");
    tells(&broken, &["the rejection is false", "with its effort replaced by NaN"]);
}

#[test]
fn several_axes_are_told_by_their_magnitudes() {
    let pulls = Told(|sample: &PortSample<Vector3<f64>>, effort| {
        Correction::none(effort - sample.velocity).checked()
    });
    let broken = laws::stabilizer(&pulls, Samples::new(PERIOD)).expect_err("broken");
    let (sample, effort) = sample_of::<Vector3<f64>>(broken.tick);
    let drive = broken.drive.expect("a drive");
    approx::assert_relative_eq!(drive.effort, effort.norm(), max_relative = 1e-12);
    approx::assert_relative_eq!(drive.velocity, sample.velocity.norm(), max_relative = 1e-12);
}

/// A damper that acts only where all lanes move inwards.
fn together(sample: &PortSample<AutoF64x4>, effort: AutoF64x4) -> Correction<AutoF64x4> {
    let zero = AutoF64x4::of(0.0);
    let alpha = if sample.velocity.above(zero).all() { AutoF64x4::of(2.0) } else { zero };
    Correction { alpha, ..Correction::none(effort + sample.velocity * alpha) }.checked()
}

/// A damper that rejects all lanes where one sample is bad.
fn all_or_none(sample: &PortSample<AutoF64x4>, effort: AutoF64x4) -> Correction<AutoF64x4> {
    let two = AutoF64x4::of(2.0);
    let corrected = Correction { alpha: two, ..Correction::none(effort + sample.velocity * two) };
    let rejected = Correction { accepted: Mask::of(false), ..Correction::none(AutoF64x4::of(0.0)) };
    if sample.sound().all() { corrected.checked() } else { rejected }
}

#[test]
fn a_rejection_of_all_lanes_is_caught_and_its_field_is_told() {
    let broken = laws::stabilizer(&Told(all_or_none), Samples::new(AutoF64x4::of(PERIOD)));
    let broken = broken.expect_err("broken");
    assert_eq!((broken.law, broken.tick, broken.lane), (Law::LaneByLane, 0, 1));
    tells(&broken, &["with its period replaced by NaN"]);
}

#[test]
fn a_decision_for_all_lanes_is_caught_and_its_lane_is_told() {
    let samples = Samples::new(AutoF64x4::of(PERIOD));
    let broken = laws::stabilizer(&Told(together), samples).expect_err("broken");
    assert_eq!(broken.law, Law::LaneByLane);
    // The first sample with velocities of both signs, and its first lane that would have been damped alone.
    let (tick, (sample, effort)) = samples
        .enumerate()
        .find(|(_, (sample, _))| {
            let inwards = sample.velocity.above(AutoF64x4::of(0.0));
            inwards.any() && !inwards.all()
        })
        .expect("one");
    let lane = (0..4).find(|&lane| sample.velocity.lane(lane) > 0.0).expect("a lane");
    assert_eq!((broken.tick, broken.lane as usize), (tick, lane));
    let drive = broken.drive.expect("a drive");
    assert_eq!((drive.effort, drive.velocity), (effort.lane(lane), sample.velocity.lane(lane)));
    approx::assert_relative_eq!(broken.value, -2.0 * drive.velocity, max_relative = 1e-9);
    if lane > 0 {
        tells(&broken, &[&format!("(lane {lane})")]);
    }
    tells(&broken, &["a lane must not depend on the others; the effort is off by", "`all`, `any`"]);
}

/// Candidate that loses its mind at the first NaN.
#[derive(Clone)]
struct Gathering(f64);

impl LyapunovCandidate<f64> for Gathering {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        self.0 += sample.displacement;
        sample.work + 0.0 * self.0
    }
}

/// Port that is no function of what it sees at rest.
#[derive(Clone)]
struct Hyperbola;

impl OnePort<f64> for Hyperbola {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        1.0 / sample.velocity
    }
}

/// Adaptor that forgets the correction inside.
struct Turned<P>(P);

impl<P: OnePort<f64>> OnePort<f64> for Turned<P> {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        -self.0.respond(sample)
    }
}

/// Plant that tells twice the displacement.
#[derive(Clone)]
struct Boasting(Body<f64>);

impl Plant<f64> for Boasting {
    fn start(&self) -> PortSample<f64> {
        self.0.start()
    }

    fn advance(&mut self, effort: f64) -> PortSample<f64> {
        let moved = self.0.advance(effort);
        PortSample { displacement: 2.0 * moved.displacement, ..moved }
    }
}

#[test]
fn every_check_tells_its_quantity() {
    let samples = Samples::<f64>::new(PERIOD);
    let broken = laws::candidate(&Gathering(0.0), samples).expect_err("broken");
    tells(
        &broken,
        &["the next decrease is NaN J;", "with its motion replaced by NaN", "keep the last"],
    );

    let broken = laws::one_port(&Hyperbola, samples).expect_err("broken");
    // Every eleventh sample rests.
    assert_eq!((broken.law, broken.tick), (Law::Finite, 10));
    tells(&broken, &["the effort is inf N; driven by inf N at 0.000e0 m/s", "smallest_normal"]);
    laws::one_port(&Wall::new(8000.0, 2.0).expect("a wall"), samples).expect("a wall is one");

    let broken = laws::adaptor::<f64, _>(Turned, samples).expect_err("broken");
    tells(&broken, &["the effort is off by", "N, allowed is 0 N", "left at its default"]);

    let hand = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
    let body = Body::new(hand, PERIOD).expect("a body").starting(0.0, 0.1);
    let broken = laws::plant(&Boasting(body), samples).expect_err("broken");
    tells(&broken, &["the displacement is off by", "m, allowed is", "difference of two positions"]);

    let credit = |share: f64| Share(share);
    let value = |sample: &PortSample<f64>| 25.0 * sample.position * sample.position;
    let motion = samples.map(|(sample, _)| sample);
    let broken = laws::decrease(&credit(1.001), value, motion, 0.0).expect_err("broken");
    tells(
        &broken,
        &["the sum of the decreases is off by", "J, allowed is", "a rate times the period"],
    );
}

/// Candidate whose decrease is a share of that of `25 x²`.
#[derive(Clone)]
struct Share(f64);

impl LyapunovCandidate<f64> for Share {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        let (now, before) = (sample.position, sample.position - sample.displacement);
        self.0 * 25.0 * (before * before - now * now)
    }
}

#[test]
fn an_order_and_a_slope_are_told_without_a_drive() {
    let oscillator = Oscillator::new(hand()).expect("one");
    let start = State { position: 0.1, velocity: 0.0 };
    let broken = laws::integrator(&SemiImplicitEuler, &oscillator, [(start, 0.0)], 0.1, 4)
        .expect_err("of order 1");
    assert_eq!((broken.law, broken.drive), (Law::Converges, None));
    tells(&broken, &["the order is", ", allowed from 3.750e0 on; likely cause: a stage"]);
    assert!((broken.value - 1.0).abs() < 0.25, "{broken}");

    /// `|x|²` with half its slope.
    struct Half;
    impl LyapunovFunction<Vector2<f64>> for Half {
        fn value(&self, state: Vector2<f64>) -> f64 {
            state.norm_squared()
        }
        fn gradient(&self, state: Vector2<f64>) -> Vector2<f64> {
            state
        }
    }
    let broken = laws::lyapunov_function(&Half, [Vector2::new(3.0, 0.0)]).expect_err("half");
    assert_eq!((broken.law, broken.drive), (Law::Slope, None));
    approx::assert_relative_eq!(broken.value, -3.0, max_relative = 1e-5);
    tells(&broken, &["the gradient is off by -3.000e0, allowed is", "a wrong factor or sign"]);
}

fn hand() -> Impedance<f64> {
    Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 }
}
