//! Shipped laws: every part that ships keeps them, and a check names the law that a part breaks.

use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::laws::{self, Law, Probe, Samples};
use lyapunov::{
    Correction, DampingLimit, Dissipation, HeldTick, Lolc, LyapunovCandidate, OnePort,
    ParameterError, Plant, PortEnergy, PortSample, Scalar, Signal, Stabilizer, StorageFunction,
    accumulators::Compensated,
    bodies::{Body, DampedMass, ElasticJoint, Impedance, PlantExt, TwoMassBody, TwoMassParts},
    effects::{Dropout, Fallback, OnePortExt},
    environments::{
        Contact, CubicSpring, HuntCrossley, LayeredWall, MassSpringDamper, MovingWall, Sphere,
        Spring, VaryingSpring, Wall,
    },
    stabilizers::{CoupledPort, NoStabilizer, VirtualCoupling},
    trajectories::{Constant, Sine},
};
use nalgebra::SVector;

const PERIOD: f64 = 1e-3;

fn limit<T: Scalar>(cap: f64) -> DampingLimit<T> {
    DampingLimit::of_mass(T::of(cap), T::of(0.2), T::of(PERIOD)).expect("a limit")
}

fn stabilizers_keep_the_laws<V: Signal>(seed: u64) {
    let of = V::Scalar::of;
    let samples = Samples::<V>::new(of(PERIOD)).seeded(seed);
    let damper = Dissipation::of(of(0.3)).expect("a damping");
    for cap in [0.0, 0.5, f64::INFINITY] {
        let popc = Lolc::new(PortEnergy, limit(cap));
        let lolc = Lolc::new((PortEnergy, damper), limit(cap));
        laws::stabilizer(&popc, samples).expect("POPC");
        laws::stabilizer(&lolc, samples).expect("LOLC");
        laws::stabilizer(&lolc.sampled(), samples).expect("LOLC, sampled work");
        let compensated = lolc.summed_in::<Compensated<V::Scalar>>();
        laws::stabilizer(&compensated, samples).expect("LOLC, compensated");
        laws::stabilizer(&compensated.sampled(), samples).expect("LOLC, compensated, sampled");
    }
}

#[test]
fn the_stabilizers_that_ship_keep_the_laws() {
    for seed in 0..20 {
        stabilizers_keep_the_laws::<f64>(seed);
        stabilizers_keep_the_laws::<f32>(seed);
        stabilizers_keep_the_laws::<WideF64x4>(seed);
        stabilizers_keep_the_laws::<AutoF32x8>(seed);
        stabilizers_keep_the_laws::<SVector<f64, 3>>(seed);
        stabilizers_keep_the_laws::<SVector<f32, 6>>(seed);
        stabilizers_keep_the_laws::<SVector<AutoF64x4, 3>>(seed);
    }
}

#[test]
fn the_candidates_that_ship_keep_the_laws() {
    let samples = Samples::<f64>::new(PERIOD);
    let wall = Wall::new(8000.0, 2.0).expect("a wall").at(0.001);
    let energy = |x: f64, v: f64| 0.5 * (50.0 * x * x + 0.3 * v * v);
    laws::candidate(&PortEnergy, samples).expect("port energy");
    laws::candidate(&(PortEnergy, wall.dissipation()), samples).expect("wall damping");
    laws::candidate(&StorageFunction::starting(energy, 0.0, 0.0), samples).expect("stored energy");
}

#[test]
fn the_environments_that_ship_keep_the_laws() {
    let samples = Samples::<f64>::new(PERIOD);
    let layered = LayeredWall::new(0.01, [500.0, 8000.0], 2.0).expect("a layered wall");
    let contact = HuntCrossley::new(8000.0, 1.5, 0.3).expect("a contact");
    let wall = Wall::new(8000.0, 2.0).expect("a wall");
    let moving = MovingWall::new(wall, 0.01, 2.0, 1.0 / PERIOD).expect("a moving wall");
    let spring = Spring::new(100.0).expect("a spring");
    let cubic: CubicSpring<f64> = CubicSpring::new(100.0, 1e5).expect("a cubic spring");
    let varying = VaryingSpring::<f64>::new(spring, 50.0, 2.0, 1.0 / PERIOD).expect("it varies");
    laws::one_port(&layered, samples).expect("layered wall");
    laws::one_port(&contact, samples).expect("Hunt and Crossley");
    laws::one_port(&moving, samples).expect("moving wall");
    laws::one_port(&varying, samples).expect("varying spring");
    laws::one_port(&cubic, samples).expect("cubic spring");
    laws::candidate(&layered.dissipation(), samples).expect("its damper");
    laws::candidate(&contact.dissipation(), samples).expect("its damper");
    // Even while the hand rests the wall moves, so its damper credits energy without any work at the port.
    let credit = moving.dissipation(1.0 / PERIOD).expect("its damper");
    let violation = laws::candidate(&credit, samples).expect_err("the wall's own work");
    assert_eq!(violation.law, Law::NothingForNothing);

    let samples = Samples::<SVector<f64, 3>>::new(PERIOD);
    let ball = Sphere::new(SVector::zeros(), 0.1).expect("a ball");
    let ball = Contact::with(ball, 1000.0, 2.0).expect("a contact");
    laws::one_port(&ball, samples).expect("ball");
    laws::candidate(&ball.dissipation(), samples).expect("its damper");
}

#[test]
fn the_ports_and_plants_that_ship_keep_the_laws() {
    let samples = Samples::<f64>::new(PERIOD);
    let impedance = Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 };
    let wall = Wall::new(8000.0, 2.0).expect("a wall");
    let chain = wall
        .held(10)
        .and_then(|port| port.stabilized(Lolc::new(PortEnergy, limit(0.5))).saturated(8.0))
        .and_then(|port| port.delayed::<4>(2))
        .and_then(|port| port.differenced().encoded(1e-6))
        .expect("a chain")
        .guarded(Fallback::Zero);
    laws::one_port(&Spring::new(100.0).expect("a spring"), samples).expect("spring");
    laws::one_port(&MassSpringDamper::new(impedance).expect("one"), samples).expect("example 2");
    laws::one_port(&wall, samples).expect("wall");
    laws::one_port(&chain, samples).expect("chain");
    let body = Body::<f64>::new(impedance, PERIOD).expect("a body");
    laws::plant(&body, samples).expect("body");
    let (device, link) = (
        DampedMass { mass: 0.2, damping: 0.001 },
        ElasticJoint { stiffness: 5000.0, damping: 1.0 },
    );
    let parts = TwoMassParts { operator: impedance, device, link };
    let linked = TwoMassBody::<f64>::new(parts, PERIOD).expect("two masses");
    laws::plant(&linked, samples).expect("linked");
    let firm = TwoMassParts { operator: Impedance { stiffness: 400.0, ..impedance }, ..parts };
    let moved = linked
        .jittered(parts, 1e-4, || 0.5)
        .and_then(|body| {
            body.led_by(Sine::new(0.0, 0.01, 2.0, 1000.0)?).gripped(parts, [(5, firm)])
        })
        .expect("a chain")
        .pushed(Constant::new(1.5).expect("a load"));
    laws::plant(&moved, samples).expect("a chain of what moves a body");
}

#[test]
fn the_adaptors_that_ship_hand_on_the_correction() {
    adaptors_hand_on::<f64>();
    adaptors_hand_on::<f32>();
    adaptors_hand_on::<SVector<f64, 3>>();
    // Lanes reject together what they share; a guard is for one value at a time.
    let samples = Samples::<AutoF64x4>::new(AutoF64x4::of(PERIOD));
    laws::adaptor(|port| port.differenced(), samples).expect("difference");
}

fn adaptors_hand_on<V: Signal<Scalar: Scalar<Mask = bool>>>() {
    let of = V::Scalar::of;
    let samples = Samples::<V>::new(of(PERIOD));
    let coupling = VirtualCoupling { stiffness: of(1000.0), damping: of(0.1), drag: of(5.0) };
    let hands_on = [
        ("hold", laws::adaptor(|port| port.held(10).unwrap(), samples)),
        ("saturation", laws::adaptor(|port| port.saturated(of(0.1)).unwrap(), samples)),
        ("delay", laws::adaptor(|port| port.delayed::<4>(2).unwrap(), samples)),
        ("encoder", laws::adaptor(|port| port.encoded(of(1e-5)).unwrap(), samples)),
        ("difference", laws::adaptor(|port| port.differenced(), samples)),
        ("low pass", laws::adaptor(|port| port.low_passed(of(50.0)).unwrap(), samples)),
        ("window", laws::adaptor(|port| port.windowed::<8>(8, of(1e-5)).unwrap(), samples)),
        ("noise", laws::adaptor(|port| port.noisy(of(1e-6), |_| 1).unwrap(), samples)),
        ("dropout", laws::adaptor(|port| dropped(port).unwrap(), samples)),
        ("guard", laws::adaptor(|port| port.guarded(Fallback::Hold), samples)),
        ("coupling", laws::adaptor(|port| CoupledPort::new(port, coupling).unwrap(), samples)),
    ];
    for (adaptor, result) in hands_on {
        assert_eq!(result, Ok(()), "{adaptor}");
    }
}

fn dropped<V: Signal>(port: Probe<V>) -> Result<Dropout<Probe<V>, V>, ParameterError> {
    port.dropped(V::Scalar::of(0.3), Fallback::Hold, |_| 1)
}

/// An adaptor that doubles the effort, and reports the correction that `told` makes of the one inside.
struct Doubled<P, F>(P, F);

impl<P: OnePort<f64>, F: Fn(Correction<f64>) -> Correction<f64>> OnePort<f64> for Doubled<P, F> {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        2.0 * self.0.respond(sample)
    }

    fn correction(&self) -> Correction<f64> {
        (self.1)(self.0.correction())
    }
}

#[test]
fn an_adaptor_that_forgets_or_changes_the_correction_is_caught() {
    let check = |told: fn(Correction<f64>) -> Correction<f64>| {
        laws::adaptor(|port| Doubled(port, told), Samples::new(PERIOD))
    };
    assert_eq!(check(|inside| inside), Ok(()));
    // The report of a port without a stabilizer, the default of the trait.
    let forgetful = check(|_| Correction::none(0.0)).expect_err("broken");
    assert_eq!((forgetful.law, forgetful.tick), (Law::HandsOn, 0));
    let law = |told| check(told).expect_err("broken").law;
    assert_eq!(law(|inside| Correction { effort: 2.0 * inside.effort, ..inside }), Law::HandsOn);
    assert_eq!(law(|inside| Correction { observed_energy: 0.0, ..inside }), Law::HandsOn);
    assert_eq!(law(|inside| Correction { alpha: 0.0, ..inside }), Law::HandsOn);
    assert_eq!(law(|inside| Correction { shortfall: 0.0, ..inside }), Law::HandsOn);
    assert_eq!(law(|inside| Correction { accepted: false, ..inside }), Law::HandsOn);
}

#[test]
fn no_stabilizer_changes_nothing_and_accepts_all() {
    for (sample, effort) in Samples::<SVector<f64, 3>>::new(PERIOD) {
        let correction = NoStabilizer.stabilize(&sample, effort);
        assert_eq!(
            (correction.effort, correction.observed_energy, correction.alpha),
            (effort, 0.0, 0.0)
        );
        assert!(correction.shortfall == 0.0 && correction.accepted);
    }
    let correction = NoStabilizer.stabilize(
        &HeldTick {
            period: PERIOD,
            position: f64::NAN,
            velocity: 0.0,
            displacement: 0.0,
            applied: 0.0,
        }
        .sample(),
        f64::NAN,
    );
    assert!(correction.effort.is_nan() && correction.accepted);
}

/// A stabilizer made of a closure.
#[derive(Clone)]
struct Told<F>(F);

impl<F: Fn(&PortSample<f64>, f64) -> Correction<f64>> Stabilizer<f64> for Told<F> {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        (self.0)(sample, effort)
    }
}

fn broken(stabilize: impl Fn(&PortSample<f64>, f64) -> Correction<f64> + Clone) -> Law {
    laws::stabilizer(&Told(stabilize), Samples::new(PERIOD)).expect_err("broken").law
}

#[test]
fn each_law_of_a_stabilizer_catches_its_breach() {
    let sound = |_: &PortSample<f64>, effort| Correction::none(effort).checked();
    laws::stabilizer(&Told(sound), Samples::new(PERIOD)).expect("nothing is a stabilizer too");

    assert_eq!(
        broken(|_, f| Correction {
            observed_energy: f64::INFINITY,
            ..Correction::none(f).checked()
        }),
        Law::Finite
    );
    assert_eq!(
        broken(|_, f| Correction { alpha: -1.0, ..Correction::none(f).checked() }),
        Law::NoNegativeDamping
    );
    assert_eq!(broken(|d, f| Correction::none(f - d.velocity).checked()), Law::Opposes);
    assert_eq!(
        broken(|_, f| Correction { observed_energy: -1.0, ..Correction::none(f).checked() }),
        Law::Served
    );
    assert_eq!(broken(|_, f| Correction::none(f)), Law::Rejects);
}

/// A stabilizer, candidate, port and plant with a faulty state.
#[derive(Clone, Default)]
struct Faulty<'a> {
    sum: f64,
    shared: Option<&'a std::cell::Cell<f64>>,
}

impl Stabilizer<f64> for Faulty<'_> {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        if let Some(shared) = self.shared {
            shared.set(shared.get() + 1.0);
            return Correction::none(effort + shared.get() * sample.velocity).checked();
        }
        self.sum += effort;
        let accepted = self.sum.is_finite();
        Correction { accepted, ..Correction::none(if accepted { effort } else { 0.0 }) }
    }
}

impl LyapunovCandidate<f64> for Faulty<'_> {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        self.sum += sample.work;
        sample.work + sample.period * 1e-9
    }
}

impl OnePort<f64> for Faulty<'_> {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        1.0 / sample.velocity
    }
}

impl Plant<f64> for Faulty<'_> {
    fn start(&self) -> PortSample<f64> {
        PortSample::starting(PERIOD, 0.0, 0.0)
    }

    fn advance(&mut self, effort: f64) -> PortSample<f64> {
        self.sum += 1e-6;
        HeldTick {
            period: PERIOD,
            position: self.sum,
            velocity: 0.0,
            displacement: 0.0,
            applied: effort,
        }
        .sample()
    }
}

#[test]
fn a_faulty_state_is_caught() {
    let samples = Samples::new(PERIOD);
    let faulty = Faulty::default();
    let shared = std::cell::Cell::new(0.0);
    let sharing = Faulty { shared: Some(&shared), ..Faulty::default() };
    let law = |result: Result<(), laws::Violation>| result.expect_err("broken").law;
    assert_eq!(law(laws::stabilizer(&faulty, samples)), Law::Recovers);
    assert_eq!(law(laws::stabilizer(&sharing, samples)), Law::Repeatable);
    assert_eq!(law(laws::candidate(&faulty, samples)), Law::NothingForNothing);
    assert_eq!(law(laws::one_port(&faulty, samples)), Law::Finite);
    assert_eq!(law(laws::plant(&faulty, samples)), Law::TellsTheTruth);
}
