//! Energy of a port of poses: over random motions it gives no more than is reported, by a sum of the test's own.

use proptest::prelude::any;
use proptest::test_runner::{Config, RngSeed, TestCaseResult, TestRunner};
use proptest::{prop_assert, prop_assert_eq};

use lyapunov::{
    DampingLimit, HeldTick, Popc, PortEnergy, Scalar, Signal, Stabilizer,
    poses::{Jacobian, Pose, PoseTrack, Screw, WithPose},
    stabilizers::{BodyInertia, DirectedDamping, InertiaLimit, PartLimits, PerPart, TaskInertia},
};
use nalgebra::{Isometry3, SMatrix, Vector3};

use crate::support::{Dice, Real, quaternion, wide};

const PERIOD: f64 = 1e-3;
const TICKS: usize = 300;

fn limits<T: Scalar>() -> PartLimits<T> {
    let inertia = BodyInertia { mass: T::of(0.3), moment: T::of(3e-4) };
    PartLimits::of_body(T::of(0.5), inertia, T::of(PERIOD)).expect("limits")
}

/// The works of a held force and of a held torque, by nalgebra.
fn work(from: &Pose<f64>, to: &Pose<f64>, held: Screw<f64>) -> (f64, f64) {
    let (one, other) = (Isometry3::from(*from), Isometry3::from(*to));
    let turn = (other.rotation * one.rotation.inverse()).scaled_axis();
    let shift = other.translation.vector - one.translation.vector;
    (held.translation.dot(&shift), held.rotation.dot(&turn))
}

/// The same numbers, as an `f64` holds them.
fn widened<T: Real>(pose: &Pose<T>) -> Pose<f64> {
    let Isometry3 { rotation, translation } = Isometry3::from(*pose);
    let numbers: [T; 4] = rotation.into_inner().coords.into();
    crate::support::pose(wide(translation.vector).into(), quaternion(numbers))
}

/// Closes the loop over random motions, wrenches and actuators, and keeps the account beside.
fn holds<T: Real>(
    seed: u64,
    mut stabilizer: impl Stabilizer<WithPose<T>>,
    parts: bool,
) -> TestCaseResult {
    let mut dice = Dice::of(seed);
    let mut pose: Pose<T> = dice.pose();
    let mut track = PoseTrack::<T>::from(pose);
    let mut at = track.tell(&pose);
    let mut applied = WithPose::<T>::default();
    let (mut accounts, mut size) = ([0.0f64; 2], 0.0f64);
    for tick in 0..TICKS {
        let strength = if tick % 100 < 50 { 2e-4 } else { 2e-6 };
        let still = dice.within(1.0) > 0.8;
        let by = if still { Screw::default() } else { dice.screw(strength, 20.0 * strength) };
        let next = Screw::<T>::moving(by, &pose);
        let position = track.tell(&next);
        let moved = position - at;
        let velocity = WithPose::of(moved.screw.map(|axis| axis / T::of(PERIOD)));
        let sample =
            HeldTick { period: T::of(PERIOD), position, velocity, displacement: moved, applied }
                .sample();

        let held = {
            let [along, about] = [applied.screw.translation, applied.screw.rotation].map(wide);
            Screw::<f64>::new(along.into(), about.into())
        };
        let (along, about) = work(&widened(&pose), &widened(&next), held);
        accounts = [accounts[0] + along, accounts[1] + about];
        size += along.abs() + about.abs();

        let correction = stabilizer.stabilize(&sample, WithPose::of(dice.screw(20.0, 0.5)));
        let square: f64 = velocity.inner(velocity).into();
        let burnt = correction.alpha.into() * square * PERIOD;
        let kept = accounts[0] + accounts[1] + burnt + correction.shortfall.into();
        // The rounding of `f32` poses is that of 1 m and 1 rad against steps of micrometres.
        let coarse = T::epsilon().into() * 20.0 * TICKS as f64;
        let rounding = TICKS as f64 * T::epsilon().into() * size + coarse;
        prop_assert!(correction.accepted, "tick {tick}");
        prop_assert!(kept >= -rounding, "{kept:e} J on tick {tick}");
        let observed: f64 = correction.observed_energy.into();
        let expected = if parts { accounts[0].min(accounts[1]) } else { accounts[0] + accounts[1] };
        prop_assert!((observed - expected).abs() <= rounding, "{observed:e} for {expected:e}");

        applied = if dice.within(1.0) > 0.5 {
            WithPose::of(correction.effort.screw.limited(T::of(8.0)))
        } else {
            correction.effort
        };
        prop_assert_eq!(applied.pose, Signal::splat(T::of(0.0)));
        (pose, at) = (next, position);
    }
    Ok(())
}

fn with_any<T: Real>(seed: u64) -> TestCaseResult {
    let PartLimits { translation, rotation } = limits::<T>();
    let popc = |limit| Popc::new(PortEnergy, limit);
    holds::<T>(seed, PerPart::of(popc(translation), popc(rotation)), true)?;
    let unlimited = popc(DampingLimit::at(T::of(f64::INFINITY)).expect("none"));
    let shared = DirectedDamping::within(unlimited, limits::<T>());
    holds::<T>(seed, shared, false)?;
    // A body as six joints of its own: three that slide and three that turn.
    let axis = |index: usize| Vector3::from_fn(|axis, _| T::of(f64::from(axis == index % 3)));
    let zero = Vector3::zeros();
    let joints = Jacobian::of(core::array::from_fn(|index| match index {
        0..3 => Screw::<T>::new(axis(index), zero),
        _ => Screw::new(zero, axis(index)),
    }));
    let inertia = SMatrix::<T, 6, 6>::from_fn(|row, column| {
        T::of(if row != column {
            0.0
        } else if row < 3 {
            0.3
        } else {
            3e-4
        })
    });
    let inertia = TaskInertia::new(&joints, inertia).expect("an inertia");
    let limited = InertiaLimit::new(shared, inertia, T::of(0.3), T::of(PERIOD)).expect("a limit");
    holds::<T>(seed, limited, false)
}

fn try_all(property: fn(u64) -> TestCaseResult) {
    let rng_seed = RngSeed::Fixed(0x905e);
    let config = Config { cases: 100, failure_persistence: None, rng_seed, ..Config::default() };
    let result = TestRunner::new(config).run(&any::<u64>(), property);
    result.unwrap_or_else(|failed| panic!("{failed}"));
}

#[test]
fn it_gives_no_more_than_is_reported() {
    try_all(with_any::<f64>);
    try_all(with_any::<f32>);
}
