//! Apparent inertia of an arm, and the limit that it sets at every tick.

use lyapunov::{
    Correction, DampingLimit, HeldTick, Popc, PortEnergy, Scalar, Signal, Stabilizer,
    lanes::AutoF64x4,
    laws,
    poses::{Jacobian, Screw},
    stabilizers::{Inertia, InertiaLimit, JointInertia, TaskInertia},
};
use nalgebra::{Matrix1, Matrix2, SMatrix, SVector, Vector2, Vector3};

use crate::arm::{joints, panda};
use crate::support::Dice;

const PERIOD: f64 = 1e-3;

/// What the arm does under an impulse at its tool, by solving its own inertia with nalgebra.
#[test]
fn it_is_how_the_arm_yields() {
    let (arm, mut dice) = (panda(), Dice::of(91));
    for _ in 0..200 {
        let posture = arm.at(joints(&mut dice, 3.0));
        let (jacobian, inertia) = (posture.jacobian(), posture.inertia());
        let arm_inertia = TaskInertia::new(&jacobian, inertia).expect("an inertia");
        let wrench = dice.screw(3.0, 1.0);
        let solve = |torques| inertia.cholesky().expect("above 0").solve(&torques);
        let answer = jacobian.twist(solve(jacobian.torques(wrench)));
        let expected = wrench.inner(answer);
        assert!((arm_inertia.inverse_square(wrench) - expected).abs() < 1e-9 * expected);

        let force = Screw::<f64>::new(dice.direction() * 2.0, Vector3::zeros());
        let along = jacobian.twist(solve(jacobian.torques(force))).translation;
        let mass = 4.0 / force.translation.dot(&along);
        assert!((arm_inertia.apparent(force) - mass).abs() < 1e-9 * mass);
    }
}

/// At right angles the planar arm of two links has its known inertia: `J M⁻¹ Jᵀ` by hand.
#[test]
fn of_two_links_by_hand() {
    let inertia = Matrix2::new(0.5, 0.1, 0.1, 0.1);
    // Tool at (0.4, 0.3) from the shoulder, (0, 0.3) from the elbow.
    let hinge = |arm: Vector3<f64>| Screw::new(Vector3::z().cross(&arm), Vector3::z());
    let jacobian =
        Jacobian::<f64, 2>::of([hinge(Vector3::new(0.4, 0.3, 0.0)), hinge(Vector3::y() * 0.3)]);
    let arm_inertia = TaskInertia::new(&jacobian, inertia).expect("an inertia");
    // Along y only the shoulder moves the tool: J = (0.4, 0), and (M⁻¹)₁₁ = 1 / 0.4.
    let along_y = Screw::<f64>::new(Vector3::y(), Vector3::zeros());
    assert!((arm_inertia.apparent(along_y) - 0.4 / (0.4 * 0.4)).abs() < 1e-12);
    // Along x both do: J = (−0.3, −0.3), J M⁻¹ Jᵀ = 0.09 (0.1 − 0.2 + 0.5) / 0.04.
    let along_x = Screw::<f64>::new(Vector3::x(), Vector3::zeros());
    assert!((arm_inertia.apparent(along_x) - 0.04 / (0.09 * 0.4)).abs() < 1e-12);
    let matrix = SMatrix::<f64, 6, 2>::from_columns(&[
        SVector::from([-0.3, 0.4, 0.0, 0.0, 0.0, 1.0]),
        SVector::from([-0.3, 0.0, 0.0, 0.0, 0.0, 1.0]),
    ]);
    assert_eq!(Jacobian::from(matrix), jacobian);
}

/// On one axis it is `DampingLimit::of_mass`.
#[test]
fn on_one_axis_it_is_the_limit_of_a_mass() {
    let (mass, cap) = (0.3, 0.5);
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY).expect("none"));
    let arm_inertia = JointInertia::new(Matrix1::new(mass)).expect("an inertia");
    for ticks in 0..3 {
        let mut new =
            InertiaLimit::new(unlimited, arm_inertia, cap, PERIOD).expect("a limit").delayed(ticks);
        let limit = DampingLimit::of_mass(cap, mass, PERIOD).expect("a limit").delayed(ticks);
        let mut known = Popc::new(PortEnergy, limit);
        for (sample, effort) in laws::Samples::<SVector<f64, 1>>::new(PERIOD) {
            let (one, other) = (new.stabilize(&sample, effort), known.stabilize(&sample, effort));
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (a.abs() + b.abs());
            assert!(near(one.alpha, other.alpha), "{} {}", one.alpha, other.alpha);
            assert!(near(one.effort.x, other.effort.x) && near(one.shortfall, other.shortfall));
            assert_eq!(one.observed_energy, other.observed_energy);
        }
    }
}

/// In any posture and direction a correction takes energy and adds none, however large the debt: the kinetic energy
/// after a tick of it, by the arm's own matrices.
#[test]
fn no_correction_adds_energy() {
    let (arm, mut dice) = (panda(), Dice::of(92));
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY).expect("none"));
    let start = arm.at(joints(&mut dice, 3.0));
    let arm_inertia = TaskInertia::new(&start.jacobian(), start.inertia()).expect("an inertia");
    let cap = 0.5;
    let mut popc = InertiaLimit::new(unlimited, arm_inertia, cap, PERIOD).expect("a limit");
    let (mut cut, mut plain) = (0, 0);
    for _ in 0..2000 {
        let posture = arm.at(joints(&mut dice, 3.0));
        let (jacobian, inertia) = (posture.jacobian(), posture.inertia());
        popc.tell(TaskInertia::new(&jacobian, inertia).expect("an inertia"));
        let rates = joints(&mut dice, 1.0);
        let twist = jacobian.twist(rates);
        let debt = 10f64.powf(dice.within(4.0) - 2.0);
        let applied = twist.scale(-debt / (twist.inner(twist) * PERIOD));
        let sample = HeldTick {
            period: PERIOD,
            position: Screw::default(),
            velocity: twist,
            displacement: twist.scale(PERIOD),
            applied,
        }
        .sample();
        let mut alone = popc;
        let correction = alone.stabilize(&sample, Screw::default());

        let torques = jacobian.torques(correction.effort);
        let gained = -inertia.cholesky().expect("above 0").solve(&torques) * PERIOD;
        let kinetic = |rates: SVector<f64, 7>| 0.5 * rates.dot(&(inertia * rates));
        let lost = kinetic(rates) - kinetic(rates + gained);
        let asked = correction.effort.inner(twist) * PERIOD;
        // Of what the correction is meant to take at least the share 1 − cap / 2 is taken.
        assert!(lost >= (1.0 - cap / 2.0) * asked * (1.0 - 1e-6), "{lost:e} of {asked:e}");
        assert!((asked + correction.shortfall - debt).abs() < 1e-9 * debt);
        let limited = correction.shortfall > 1e-9 * debt;
        (cut, plain) = (cut + usize::from(limited), plain + usize::from(!limited));
        if limited {
            // c·v = cap · (1/T) (c·v)² / (c·Λ⁻¹ c) ⇒ the fastest way down, shortened to the share `cap`.
            let whole = correction.effort.inner(twist) / -gained.dot(&torques);
            assert!((whole - 1.0 / cap).abs() < 1e-6, "{whole}");
        }
    }
    assert!(cut > 200 && plain > 200, "{cut} {plain}");
}

/// A cap of 0 observes, an infinite one changes nothing.
#[test]
fn from_nothing_to_all() {
    let inertia = Matrix2::new(0.5, 0.1, 0.1, 0.1);
    let arm_inertia = JointInertia::new(inertia).expect("an inertia");
    let popc = Popc::new(PortEnergy, DampingLimit::at(3.0).expect("a limit"));
    let with = |cap| InertiaLimit::new(popc, arm_inertia, cap, PERIOD).expect("a limit");
    let (mut none, mut all, mut known) = (with(0.0), with(f64::INFINITY), popc);
    for (sample, effort) in laws::Samples::<Vector2<f64>>::new(PERIOD) {
        let expected: Correction<_> = known.stabilize(&sample, effort);
        assert_eq!(all.stabilize(&sample, effort), expected);
        let observed = none.stabilize(&sample, effort);
        assert_eq!((observed.effort, observed.alpha), (effort, 0.0));
        assert_eq!(observed.shortfall, (-observed.observed_energy).max(0.0));
    }
}

#[test]
fn it_keeps_the_laws() {
    let unlimited = |it| Popc::new(PortEnergy, DampingLimit::at(it).expect("none"));
    let inertia = Matrix2::new(0.5, 0.1, 0.1, 0.1);
    let arm_inertia = JointInertia::new(inertia).expect("an inertia");
    let limit =
        InertiaLimit::new(unlimited(f64::INFINITY), arm_inertia, 0.5, PERIOD).expect("a limit");
    let (arm, mut dice) = (panda(), Dice::of(93));
    let posture = arm.at(joints(&mut dice, 2.0));
    let task = TaskInertia::new(&posture.jacobian(), posture.inertia()).expect("an inertia");
    let at_tool = InertiaLimit::new(unlimited(f64::INFINITY), task, 0.5, PERIOD).expect("a limit");
    for seed in 0..8 {
        laws::stabilizer(&limit, laws::Samples::<Vector2<f64>>::new(PERIOD).seeded(seed))
            .expect("laws");
        laws::stabilizer(&at_tool, laws::Samples::<Screw<f64>>::new(PERIOD).seeded(seed))
            .expect("laws");
    }
    let wide = AutoF64x4::of;
    let lanes = JointInertia::new(inertia.map(wide)).expect("an inertia");
    let popc = Popc::new(PortEnergy, DampingLimit::at(wide(f64::INFINITY)).expect("none"));
    let lanes = InertiaLimit::new(popc, lanes, wide(0.5), wide(PERIOD)).expect("a limit");
    laws::stabilizer(&lanes, laws::Samples::<Vector2<AutoF64x4>>::new(wide(PERIOD))).expect("laws");
}

#[test]
fn what_is_no_inertia_is_refused() {
    for bad in [[[1.0, 2.0], [2.0, 1.0]], [[0.0, 0.0], [0.0, 1.0]], [[f64::NAN, 0.0], [0.0, 1.0]]] {
        assert!(JointInertia::new(Matrix2::from(bad)).is_err());
    }
    let arm_inertia = JointInertia::new(Matrix1::new(1.0)).expect("an inertia");
    let popc = Popc::new(PortEnergy, DampingLimit::at(1.0).expect("a limit"));
    let refused =
        |cap, period| InertiaLimit::new(popc, arm_inertia, cap, period).expect_err("no").parameter;
    assert_eq!(refused(-1.0, PERIOD), "damping cap");
    assert_eq!(refused(0.5, 0.0), "period");
}
