//! Finite garbage: with stated limits no account is blinded by it.

use lyapunov::lanes::{AutoF32x8, WideF64x4};
use lyapunov::laws::{self, Samples};
use lyapunov::{
    Correction, Dissipation, HeldTick, Lolc, Mask, PortEnergy, PortSample, Scalar, Signal,
    Stabilizer,
    accumulators::{Compensated, Wide, Widen},
    stabilizers::{
        Account, EnergyBounding, ForceBound, ForceBounding, LeastNorm, Plausibility, SlopeBound,
        StabilizerExt, Tank, TankLimits,
    },
};
use nalgebra::Vector3;

use crate::support::{PERIOD, limit, popc};

/// More than any of the shipped samples has.
fn limits<T: Scalar>() -> Plausibility<T> {
    Plausibility { speed: T::of(1e3), effort: T::of(1e4) }
}

/// Samples with one absurd field each; all numbers are finite.
fn absurd<V: Signal>(sample: PortSample<V>) -> impl Iterator<Item = PortSample<V>> {
    let largest = V::Scalar::largest();
    let sizes = [largest, -largest, V::Scalar::of(1e36), V::Scalar::of(1.0001e4)];
    sizes.into_iter().flat_map(move |size| {
        let absurd = V::splat(size);
        [
            PortSample { velocity: absurd, ..sample },
            PortSample { displacement: absurd, ..sample },
            PortSample { applied: absurd, ..sample },
            PortSample { work: absurd, ..sample },
        ]
    })
}

/// Garbage is rejected, and the account is that of a copy which never saw it.
fn keeps_its_account<V: Signal, S>(name: &str, stabilizer: S)
where
    S: Stabilizer<V> + Account<V::Scalar> + StabilizerExt + Clone,
{
    let mut one = stabilizer.clone().plausible(limits()).expect("limits");
    let mut bare = stabilizer;
    for (sample, effort) in Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(3) {
        let before = one.observed_energy();
        for flawed in absurd(sample) {
            let mut other = one.clone();
            let correction = other.stabilize(&flawed, effort);
            assert!(!correction.accepted.any(), "{name}: {flawed:?} {correction:?}");
            assert!(correction.effort.finite().all(), "{name}: {correction:?}");
            assert_eq!(other.observed_energy(), before, "{name}: {flawed:?}");
        }
        let refused = one.clone().stabilize(&sample, V::splat(V::Scalar::largest()));
        assert!(!refused.accepted.any() && refused.effort.finite().all(), "{name}: {refused:?}");
        // What is plausible, and can be resolved, changes no bit.
        assert_eq!(one.stabilize(&sample, effort), bare.stabilize(&sample, effort), "{name}");
    }
}

fn every_account<V: Signal>() {
    let of = V::Scalar::of;
    let popc = popc::<V::Scalar>();
    let lolc = Lolc::new((PortEnergy, Dissipation::of(of(0.3)).expect("a damping")), limit());
    keeps_its_account::<V, _>("popc", popc);
    keeps_its_account::<V, _>("lolc", lolc);
    keeps_its_account::<V, _>("compensated", lolc.summed_in::<Compensated<_>>());
    keeps_its_account::<V, _>(
        "force-bound",
        ForceBound::<V::Scalar>::new(of(0.1)).expect("a bound"),
    );
    let bounding = ForceBounding::of_damping(of(0.1)).expect("a bound");
    keeps_its_account::<V, _>("force-bounding", bounding);
    let least = LeastNorm::new(PortEnergy, limit(), of(0.3)).expect("a filter");
    keeps_its_account::<V, _>("least-norm", least);
    keeps_its_account::<V, _>("slope-bound", SlopeBound::<V>::new(of(1e3)).expect("a slope"));
    let rates = EnergyBounding::<V>::new(of(500.0), of(250.0)).expect("constants");
    keeps_its_account::<V, _>("energy-bounding", rates);
    let [start, floor, ceiling, power] = [2e-3, 1e-3, 5e-3, 3.0].map(of);
    let tank = Tank::new(PortEnergy, TankLimits { start, floor, ceiling, power });
    keeps_its_account::<V, _>("tank", tank.expect("a tank"));
}

#[test]
fn no_account_is_blinded() {
    every_account::<f64>();
    every_account::<f32>();
    every_account::<WideF64x4>();
    every_account::<AutoF32x8>();
    every_account::<Vector3<f32>>();
    fn wide<T: Widen>() {
        keeps_its_account::<T, _>("wide", popc::<T>().summed_in::<Wide<T>>());
    }
    wide::<f32>();
    wide::<f64>();
}

/// Sampled work is of the effort now, which is refused as well.
#[test]
fn sampled_work_is_not_blinded() {
    let mut popc = popc::<f32>().sampled().plausible(limits()).expect("limits");
    let moving = PortSample::starting(1e-3, 0.0, 0.1);
    for effort in [f32::MAX, -f32::MAX, 1e36] {
        assert!(!popc.stabilize(&moving, effort).accepted);
        assert_eq!(popc.observed_energy(), 0.0);
    }
    assert!(popc.stabilize(&moving, -1.0).alpha > 0.0);
}

/// An effort that is refused hides no work that was done.
#[test]
fn the_work_before_a_refused_effort_is_booked() {
    let mut popc = popc::<f64>().plausible(limits()).expect("limits");
    let gave = HeldTick {
        period: PERIOD,
        position: 0.0,
        velocity: -0.1,
        displacement: -1e-4,
        applied: 2.0,
    };
    let refused: Correction<f64> = popc.stabilize(&gave.sample(), 1e300);
    assert!(!refused.accepted && refused.observed_energy == -2e-4 && refused.shortfall == 2e-4);
}

/// Only the lane with garbage is refused.
#[test]
fn lanes_stand_for_themselves() {
    let mut lanes = popc::<WideF64x4>().plausible(limits()).expect("limits");
    let one = |value: f64| WideF64x4::from_lanes(|lane| if lane == 1 { value } else { -1e-4 });
    let sample = PortSample {
        work: one(1e292),
        ..PortSample::starting(WideF64x4::of(PERIOD), WideF64x4::of(0.0), WideF64x4::of(0.1))
    };
    let correction = lanes.stabilize(&sample, WideF64x4::of(0.0));
    for lane in 0..4 {
        assert_eq!(correction.accepted.lane(lane), lane != 1);
        let sum = if lane == 1 { 0.0 } else { -1e-4 };
        assert_eq!(correction.observed_energy.lane(lane), sum);
    }
}

#[test]
fn the_laws_hold_and_limits_are_checked() {
    let popc = popc::<f64>();
    laws::stabilizer(&popc.plausible(limits()).expect("limits"), Samples::<f64>::new(PERIOD))
        .expect("laws");
    let none = Plausibility { speed: f64::INFINITY, effort: f64::INFINITY };
    laws::stabilizer(&popc.plausible(none).expect("none"), Samples::<f64>::new(PERIOD))
        .expect("laws");
    for bad in [-1.0, f64::NAN] {
        assert!(popc.plausible(Plausibility { speed: bad, effort: 1.0 }).is_err());
        let mut one = popc.plausible(limits()).expect("limits");
        assert!(one.set_plausibility(Plausibility { speed: 1.0, effort: bad }).is_err());
        assert_eq!(one.plausibility(), limits());
    }
}

/// Shortfalls of several axes add up to a number, and a limit of a cap of 0 is 0 whatever it is divided by.
#[test]
fn sums_and_quotients_stay_in_range() {
    use lyapunov::{DampingLimit, stabilizers::PerAxis};
    let mut axes = PerAxis::of([popc::<f32>(); 3]);
    let owed = f32::MAX;
    let sample = PortSample {
        work: Vector3::from_element(-owed),
        ..PortSample::starting(1e-3, Vector3::zeros(), Vector3::zeros())
    };
    let correction = axes.stabilize(&sample, Vector3::zeros());
    assert!(correction.shortfall.is_finite(), "{correction:?}");
    assert_eq!(DampingLimit::of_stiffness(0.0, 1e-200, 1e-200).expect("a limit").most(), 0.0);
    assert_eq!(DampingLimit::of_stiffness(0.5, 1e200, 1e200).expect("a limit").most(), 0.0);
    let limit = DampingLimit::of_stiffness(1e-300, 1e-200, 1e-200).expect("a limit").most();
    approx::assert_relative_eq!(limit, 1e100, max_relative = 1e-12);
}

/// A device that cannot move does no work, whatever the effort.
#[test]
fn without_a_speed_there_is_no_work() {
    let limits = Plausibility { speed: 0.0, effort: f64::INFINITY };
    let mut popc = popc::<f64>().plausible::<f64>(limits).expect("limits");
    let absurd = PortSample::<f64> { work: 1e36, ..PortSample::starting(PERIOD, 0.0, 0.0) };
    assert!(!popc.stabilize(&absurd, 0.0).accepted);
    assert_eq!(popc.observed_energy(), 0.0);
}
