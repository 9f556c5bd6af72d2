//! Translation and rotation of a rigid body against closed forms.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, DampingLimit, Dissipation, LyapunovCandidate, Mask, ParameterError, PortEnergy,
    PortSample, Signal, Snapshot, Stabilizer, laws,
    poses::{Screw, WorldAxes},
    stabilizers::{
        Account, BodyInertia, DirectedDamping, LimitCredit, PartLimits, PerPart, StabilizerExt,
    },
};
use nalgebra::Vector3;

use crate::support::{PERIOD, popc};

type Popc = lyapunov::Popc<f64>;
type Body = Screw<f64, WorldAxes>;

fn at(most: f64) -> DampingLimit<f64> {
    DampingLimit::at(most).expect("a limit")
}

/// A stabilizer that tells what it was made with, and keeps nothing.
#[derive(Clone, Copy)]
struct Says {
    energy: f64,
    alpha: f64,
    shortfall: f64,
}

impl Stabilizer<Vector3<f64>> for Says {
    fn stabilize(
        &mut self,
        sample: &PortSample<Vector3<f64>>,
        effort: Vector3<f64>,
    ) -> Correction<Vector3<f64>> {
        let Self { energy: observed_energy, alpha, shortfall } = *self;
        let effort = effort + sample.velocity * alpha;
        Correction { observed_energy, alpha, shortfall, ..Correction::none(effort) }.checked()
    }
}

/// 3 m/s and 2 rad/s, over half a second.
fn moving() -> PortSample<Body> {
    let twist = Screw::new(Vector3::new(0.0, 3.0, 0.0), Vector3::new(0.0, 0.0, -2.0));
    PortSample::starting(0.5, Screw::default(), twist)
}

fn says(energy: f64, alpha: f64, shortfall: f64) -> Says {
    Says { energy, alpha, shortfall }
}

/// `Σ αᵢ vᵢ² / Σ vᵢ²`: 9 and 4 of 13 here.
#[test]
fn the_joined_damping_burns_what_both_burn() {
    for (first, second, mean) in [(13.0, 0.0, 9.0), (0.0, 13.0, 4.0), (26.0, 13.0, 22.0)] {
        let mut both = PerPart::of(says(-2.0, first, 0.25), says(-3.0, second, 0.5));
        let told = both.stabilize(&moving(), Screw::default());
        assert_relative_eq!(told.alpha, mean, max_relative = 1e-14);
        assert_eq!((told.observed_energy, told.shortfall), (-3.0, 0.75));
        let [along, about] = both.apart(&moving(), Screw::default());
        assert_eq!((along.effort, along.alpha), (Vector3::new(0.0, 3.0 * first, 0.0), first));
        assert_eq!((about.effort, about.alpha), (Vector3::new(0.0, 0.0, -2.0 * second), second));
        assert_eq!(told.effort, Screw::new(along.effort, about.effort));
    }
    let full = says(f64::MAX, 5.0, f64::MAX);
    let mut both = PerPart::of(full, full);
    let told = both.stabilize(&moving(), Screw::default());
    // Two equal dampings are one, and two debts beyond the range are told as the largest number.
    assert_eq!((told.alpha, told.shortfall, told.accepted), (5.0, f64::MAX, true));
    // v² is the smallest normal number, and v² T is less: that is no motion.
    for (step, alpha) in [(-511, 0.0), (-510, 9.0)] {
        let twist: Body = Screw::new(Vector3::x() * 2f64.powi(step), Vector3::zeros());
        let slow = PortSample::starting(0.5, Screw::default(), twist);
        let mut both = PerPart::of(says(0.0, 9.0, 0.0), says(0.0, 0.0, 0.0));
        assert_eq!(both.stabilize(&slow, Screw::default()).alpha, alpha);
    }
}

/// A part whose sample is rejected counts neither in the damping nor in what moves.
#[test]
fn a_rejected_part_dissipates_nothing() {
    let mut sample = moving();
    sample.velocity.rotation.x = f64::NAN;
    let mut both = PerPart::of(says(1.0, 7.0, 0.0), says(2.0, 100.0, 0.0));
    let told = both.stabilize(&sample, Screw::default());
    assert!(!told.accepted.all() && told.observed_energy == 1.0);
    assert_relative_eq!(told.alpha, 7.0, max_relative = 1e-14);
    assert_eq!(told.effort, Screw::new(Vector3::new(0.0, 21.0, 0.0), Vector3::zeros()));
    sample.velocity = Screw::new(Vector3::x() * f64::INFINITY, Vector3::y());
    let told = both.stabilize(&sample, Screw::default());
    assert!(!told.accepted.all() && told.effort.translation == Vector3::zeros());
    assert_relative_eq!(told.alpha, 100.0, max_relative = 1e-14);
}

/// Each number of a sample reaches its own part.
#[test]
fn a_part_is_told_its_own_numbers() {
    /// Books everything that it is told, each number in a decade of its own.
    #[derive(Clone, Copy)]
    struct Reads;
    impl LyapunovCandidate<Vector3<f64>> for Reads {
        fn decrease(&mut self, sample: &PortSample<Vector3<f64>>) -> f64 {
            let PortSample { period, position, velocity, displacement, applied, work } = *sample;
            let numbers = [position, velocity, displacement, applied, work].map(|it| it.x);
            numbers.iter().fold(period, |sum, number| 10.0 * sum + number)
        }
    }
    let both = |along: f64, about: f64| Screw::new(Vector3::x() * along, Vector3::x() * about);
    let sample: PortSample<Body> = PortSample {
        period: 1.0,
        position: both(2.0, 0.0),
        velocity: both(3.0, 9.0),
        displacement: both(4.0, 8.0),
        applied: both(5.0, 7.0),
        work: both(6.0, 1.0),
    };
    assert_eq!(PerPart::of(Reads, Reads).decrease(&sample), 123_456.0 + 109_871.0);
    let damper = |damping: f64| Dissipation::of(damping).expect("a damper");
    let burnt = PerPart::of(damper(4.0), damper(8.0)).decrease(&moving());
    assert_eq!(burnt, (4.0 * 9.0 + 8.0 * 4.0) * 0.5);
}

#[test]
fn each_part_can_be_reached() {
    let mut both = PerPart::of(Popc::new(PortEnergy, at(2.0)), Popc::new(PortEnergy, at(3.0)));
    both.translation_mut().grant(5.0).expect("a credit");
    both.rotation_mut().owe(1.0).expect("a debt");
    both.rotation_mut().set_limit(at(4.0));
    assert_eq!(
        (both.translation().observed_energy(), both.rotation().observed_energy()),
        (5.0, -1.0)
    );
    assert_eq!((both.translation().limit().most(), both.rotation().limit().most()), (2.0, 4.0));
    both.rotation_mut().grant(9.0).expect("a credit");
    LimitCredit::<f64>::limit_credit(&mut both, 3.0);
    assert_eq!(
        (both.translation().observed_energy(), both.rotation().observed_energy()),
        (3.0, 3.0)
    );
}

/// From what is stored both parts go on, and what is refused by either is refused.
#[test]
fn both_memories_are_kept() {
    let both = PerPart::of(popc::<f64>(), popc::<f64>().spread_over::<f64>(3).expect("ticks"));
    laws::snapshot(&both, laws::Samples::<Body>::new(PERIOD)).expect("the law");
    let (sound, bad) = (((), 1.0), ((), f64::NAN));
    let popcs = PerPart::of(popc::<f64>(), popc::<f64>());
    assert!(popcs.restored((sound, sound)).is_ok());
    assert!(popcs.restored((sound, bad)).is_err() && popcs.restored((bad, sound)).is_err());
}

/// `cap m / T` and `cap I / T`, and the names under which what is refused is known.
#[test]
fn limits_are_of_mass_and_of_moment() {
    let of =
        |cap, mass, moment, period| PartLimits::of_body(cap, BodyInertia { mass, moment }, period);
    let limits = of(0.5, 6.0, 3.0, 0.25).expect("limits");
    assert_eq!((limits.translation.most(), limits.rotation.most()), (12.0, 6.0));
    let late = limits.delayed(2);
    let share = 2.0 - 3f64.sqrt();
    assert_relative_eq!(late.translation.most(), 12.0 * share, max_relative = 1e-14);
    assert_relative_eq!(late.rotation.most(), 6.0 * share, max_relative = 1e-14);
    let refused = |limits: Result<PartLimits<f64>, ParameterError>| {
        let error = limits.expect_err("refused");
        (error.parameter, error.value)
    };
    assert_eq!(refused(of(-1.0, 1.0, 1.0, 1.0)), ("damping cap", -1.0));
    assert_eq!(refused(of(0.5, 0.0, 1.0, 1.0)), ("mass", 0.0));
    assert_eq!(refused(of(0.5, 1.0, -2.0, 1.0)), ("moment of inertia", -2.0));
    assert_eq!(refused(of(0.5, 1.0, 1.0, 0.0)), ("period", 0.0));
}

/// Under one sum a debt beyond both limits is served by each part's limit; the larger limit may be either part's.
#[test]
fn under_one_sum_each_part_has_its_limit() {
    for (translation, rotation) in
        [(8.0, 2.0), (2.0, 8.0), (5.0, 5.0), (4.0, 0.0), (0.0, 4.0), (0.0, 0.0)]
    {
        let limits = PartLimits { translation: at(translation), rotation: at(rotation) };
        let mut popc = Popc::new(PortEnergy, at(f64::INFINITY));
        popc.owe(1e6).expect("a debt");
        let mut one: DirectedDamping<_, _, f64> = DirectedDamping::within(popc, limits);
        let sample = moving();
        let added = one.stabilize(&sample, Body::default()).effort;
        let most = Screw::new(
            sample.velocity.translation * translation,
            sample.velocity.rotation * rotation,
        );
        let off = added - most;
        assert!(
            off.inner(off).sqrt() <= 1e-12 * (translation + rotation),
            "{added:?} for {most:?}"
        );
    }
}
