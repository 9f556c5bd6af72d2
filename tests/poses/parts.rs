//! Limits and sums for each part: translation and rotation share no number.

use lyapunov::{
    DampingLimit, Dissipation, HeldTick, Lolc, LyapunovCandidate, Popc, PortEnergy, PortSample,
    Scalar, Signal, Stabilizer,
    lanes::AutoF32x8,
    laws,
    poses::{Screw, Spatial, WithPose, WorldAxes},
    stabilizers::{
        BodyInertia, DirectedDamping, LimitCredit, PartLimits, PerAxis, PerPart, StabilizerExt,
    },
};
use nalgebra::Vector3;

use crate::support::Dice;

const PERIOD: f64 = 1e-3;

fn limits<T: Scalar>() -> PartLimits<T> {
    let inertia = BodyInertia { mass: T::of(0.4), moment: T::of(2e-4) };
    PartLimits::of_body(T::of(0.5), inertia, T::of(PERIOD)).expect("limits")
}

fn each<T: Scalar>() -> PerPart<Popc<T>, Popc<T>> {
    let PartLimits { translation, rotation } = limits();
    PerPart::of(Popc::new(PortEnergy, translation), Popc::new(PortEnergy, rotation))
}

fn one<V: Spatial>() -> impl Stabilizer<V> + Clone {
    let unlimited = DampingLimit::at(V::Scalar::of(f64::INFINITY)).expect("none");
    DirectedDamping::within(Popc::new(PortEnergy, unlimited), limits::<V::Scalar>())
}

/// Random samples of a moving port.
fn samples(seed: u64) -> impl Iterator<Item = (PortSample<Screw<f64>>, Screw<f64>)> {
    let mut dice = Dice::of(seed);
    (0..2000).map(move |_| {
        let twist = dice.screw::<f64, WorldAxes>(0.3, 5.0);
        let (applied, effort) = (dice.screw(5.0, 0.05), dice.screw(5.0, 0.05));
        let moved = twist.scale(PERIOD);
        (
            HeldTick {
                period: PERIOD,
                position: Screw::default(),
                velocity: twist,
                displacement: moved,
                applied,
            }
            .sample(),
            effort,
        )
    })
}

#[test]
fn limits_are_of_mass_and_of_inertia() {
    let limits = limits::<f64>();
    assert_eq!((limits.translation.most(), limits.rotation.most()), (200.0, 0.1));
    let late = limits.delayed(1);
    assert_eq!(late.translation, limits.translation.delayed(1));
    assert_eq!(late.rotation, limits.rotation.delayed(1));
    let of = |cap, mass, moment, period| {
        PartLimits::of_body(cap, BodyInertia { mass, moment }, period).expect_err("refused")
    };
    assert_eq!(of(-1.0, 1.0, 1.0, 1.0).parameter, "damping cap");
    assert_eq!(of(0.5, 0.0, 1.0, 1.0).parameter, "mass");
    assert_eq!(of(0.5, 1.0, f64::NAN, 1.0).parameter, "moment of inertia");
    assert_eq!(of(0.5, 1.0, 1.0, 0.0).parameter, "period");
}

/// Each part is what its stabilizer alone would do, to the bit, and the joined correction is the sum of both.
#[test]
fn each_part_is_a_port_of_its_own() {
    let mut both = each::<f64>();
    let PartLimits { translation, rotation } = limits();
    let (mut moving, mut turning) =
        (Popc::new(PortEnergy, translation), Popc::new(PortEnergy, rotation));
    let mut acted = [false; 2];
    for (sample, effort) in samples(71) {
        let alone = |part: fn(Screw<f64>) -> Vector3<f64>| {
            let [velocity, moved, applied] =
                [sample.velocity, sample.displacement, sample.applied].map(part);
            (
                HeldTick {
                    period: PERIOD,
                    position: Vector3::zeros(),
                    velocity,
                    displacement: moved,
                    applied,
                }
                .sample(),
                part(effort),
            )
        };
        let (along, about) = (alone(|it| it.translation), alone(|it| it.rotation));
        let (first, second) =
            (moving.stabilize(&along.0, along.1), turning.stabilize(&about.0, about.1));
        let mut copy = both;
        assert_eq!(copy.apart(&sample, effort), [first, second]);
        let whole = both.stabilize(&sample, effort);
        assert_eq!(whole.effort, Screw::new(first.effort, second.effort));
        assert_eq!(whole.observed_energy, first.observed_energy.min(second.observed_energy));
        assert_eq!(whole.shortfall, first.shortfall + second.shortfall);
        assert!(first.alpha <= translation.most() && second.alpha <= rotation.most());
        acted = [acted[0] | (first.alpha > 0.0), acted[1] | (second.alpha > 0.0)];
    }
    assert_eq!(acted, [true; 2]);
}

/// Under one sum both parts take the same share of their limits, serve the whole debt up to them, and the wrench that
/// passes is not touched otherwise.
#[test]
fn one_sum_serves_in_proportion() {
    let (mut stabilizer, limits) = (one::<Screw<f64>>(), limits::<f64>());
    let (mut account, mut cut) = (0.0, 0);
    for (sample, effort) in samples(72) {
        account += sample.applied.inner(sample.displacement);
        let correction = stabilizer.stabilize(&sample, effort);
        assert!((correction.observed_energy - account).abs() < 1e-12);
        let added = correction.effort - effort;
        let (v, w) = (sample.velocity.translation, sample.velocity.rotation);
        let most = (limits.translation.most() * v.norm_squared()
            + limits.rotation.most() * w.norm_squared())
            * PERIOD;
        let share = ((-account).max(0.0) / most).min(1.0);
        cut += usize::from(share == 1.0);
        let [along, about] = [limits.translation, limits.rotation].map(|it| it.most() * share);
        assert!((added.translation - v * along).norm() < 1e-9);
        assert!((added.rotation - w * about).norm() < 1e-9);
        assert!((correction.shortfall - ((-account).max(0.0) - most).max(0.0)).abs() < 1e-12);
    }
    assert!((10..1990).contains(&cut), "{cut}");
}

/// Millimetres for metres (and millinewtons where energy stays in joules) change nothing but the numbers of
/// translation: no number of one part enters the other.
#[test]
fn no_number_depends_on_the_unit_of_the_other_part() {
    let unit = 1024.0;
    let told =
        |screw: Screw<f64>, factor| Screw::<f64>::new(screw.translation * factor, screw.rotation);
    let scaled = PartLimits {
        translation: DampingLimit::at(limits::<f64>().translation.most() / (unit * unit))
            .expect("a limit"),
        ..limits()
    };
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY).expect("none"));
    let mut one = [
        DirectedDamping::<_, _, f64>::within(unlimited, limits()),
        DirectedDamping::within(unlimited, scaled),
    ];
    let mut two = [
        each(),
        PerPart::of(
            Popc::new(PortEnergy, scaled.translation),
            Popc::new(PortEnergy, scaled.rotation),
        ),
    ];
    for (sample, effort) in samples(73) {
        let other = PortSample {
            velocity: told(sample.velocity, unit),
            displacement: told(sample.displacement, unit),
            applied: told(sample.applied, 1.0 / unit),
            ..sample
        };
        let efforts = [(sample, effort), (other, told(effort, 1.0 / unit))];
        let near = |[first, second]: [Screw<f64>; 2]| {
            let apart = first - told(second, unit);
            assert!(apart.translation.norm() < 1e-9 && apart.rotation.norm() < 1e-11, "{apart:?}");
        };
        near([0, 1].map(|index| one[index].stabilize(&efforts[index].0, efforts[index].1).effort));
        near([0, 1].map(|index| two[index].stabilize(&efforts[index].0, efforts[index].1).effort));
    }
}

/// A pair of candidates counts both parts, each with its own damping.
#[test]
fn a_pair_of_candidates_is_their_sum() {
    let damper = |damping: f64| Dissipation::of(damping).expect("a damper");
    let mut credit = PerPart::of(damper(0.7), damper(2e-3));
    for (sample, _) in samples(74) {
        let (v, w) = (sample.velocity.translation, sample.velocity.rotation);
        let expected = (0.7 * v.norm_squared() + 2e-3 * w.norm_squared()) * PERIOD;
        assert!((credit.decrease(&sample) - expected).abs() < 1e-15);
    }
    let candidate = (PortEnergy, credit);
    let mut lolc = Lolc::new(candidate, DampingLimit::at(1.0).expect("a limit"));
    let (sample, effort) = samples(74).next().expect("a sample");
    let booked = lolc.stabilize(&sample, effort).observed_energy;
    assert!((booked - sample.work.sum() - credit.decrease(&sample)).abs() < 1e-15);
}

#[test]
fn credit_is_limited_in_each_part() {
    let mut both = each::<f64>().bounded(1e-3).expect("a bound");
    let rest = Screw::<f64>::new(Vector3::x(), Vector3::z());
    let absorbed = HeldTick {
        period: PERIOD,
        position: rest,
        velocity: rest,
        displacement: rest.scale(PERIOD),
        applied: rest.scale(10.0),
    }
    .sample();
    both.stabilize(&absorbed, Screw::default());
    let idle = HeldTick {
        period: PERIOD,
        position: rest,
        velocity: rest,
        displacement: Screw::default(),
        applied: Screw::default(),
    }
    .sample();
    assert_eq!(both.stabilize(&idle, Screw::default()).observed_energy, 1e-3);
    let mut alone = each::<f64>();
    LimitCredit::<f64>::limit_credit(&mut alone, 0.0);
    assert_eq!(alone.stabilize(&idle, Screw::default()).observed_energy, 0.0);
}

fn keeps_the_laws<V: Spatial>() {
    for seed in 0..8 {
        let samples = laws::Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(seed);
        laws::stabilizer(&each::<V::Scalar>(), samples).expect("the laws");
        laws::stabilizer(&one::<V>(), samples).expect("the laws");
        let axes = PerAxis::of([*each::<V::Scalar>().translation(); 3]);
        laws::stabilizer(&PerPart::of(axes, axes), samples).expect("the laws");
        let gentle = each::<V::Scalar>().spread_over(3).expect("ticks");
        laws::stabilizer(&gentle, samples).expect("the laws");
    }
}

#[test]
fn they_keep_the_laws() {
    keeps_the_laws::<Screw<f64>>();
    keeps_the_laws::<Screw<f32>>();
    keeps_the_laws::<Screw<AutoF32x8>>();
    keeps_the_laws::<WithPose<f64>>();
    keeps_the_laws::<WithPose<f32>>();
}

/// A limit of 0 observes; one for one part alone leaves the other.
#[test]
fn a_part_may_be_left_alone() {
    let at = |damping: f64| DampingLimit::at(damping).expect("a limit");
    let unlimited = Popc::new(PortEnergy, at(f64::INFINITY));
    let parts =
        |translation, rotation| PartLimits { translation: at(translation), rotation: at(rotation) };
    for (limits, moves, turns) in [
        (parts(0.0, 0.0), false, false),
        (parts(100.0, 0.0), true, false),
        (parts(0.0, 0.1), false, true),
    ] {
        let mut stabilizer = DirectedDamping::<_, _, f64>::within(unlimited, limits);
        let mut seen = (false, false);
        for (sample, effort) in samples(75) {
            let added = stabilizer.stabilize(&sample, effort).effort - effort;
            seen.0 |= added.translation.norm() > 0.0;
            seen.1 |= added.rotation.norm() > 0.0;
        }
        assert_eq!(seen, (moves, turns));
    }
}
