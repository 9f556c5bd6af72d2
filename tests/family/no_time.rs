//! Periods that are no time: every member rejects them, and goes on as if its clock had told the truth again.

use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::laws::Samples;
use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, Mask, OnePort, Popc, PortEnergy, PortSample,
    Scalar, Signal, Stabilizer,
    accumulators::{Compensated, Plain, Wide, Widen},
    effects::{Fallback, OnePortExt},
    environments::Wall,
    stabilizers::{
        AlongDirection, AxisWeights, DirectedDamping, DriftCompensated, EnergyBounding, EnergyTank,
        ForceBound, ForceBounding, LeastNorm, MemoryBased, PathMemory, PerAxis, Sharing,
        SlopeBound, StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide, WatchdogTimes,
        WindowedCredit,
    },
};
use nalgebra::Vector3;

use crate::support::{PERIOD, limit, popc};

const NO_TIMES: [f64; 6] = [-1e-3, -0.0, 0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn told_finite<V: Signal>(correction: &Correction<V>) -> bool {
    let energies = correction.observed_energy + correction.alpha + correction.shortfall;
    correction.effort.finite().all() && energies.finite().all()
}

/// A sample over no time is not accepted, adds no damping, and credits nothing; the next one is answered.
fn is_rejected<V: Signal>(name: &str, stabilizer: &(impl Stabilizer<V> + Clone)) {
    let mut one = stabilizer.clone();
    for (sample, effort) in Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(7) {
        for no_time in NO_TIMES.map(V::Scalar::of) {
            let mut other = one.clone();
            let untimed = PortSample { period: no_time, ..sample };
            let correction = other.stabilize(&untimed, effort);
            assert!(!correction.accepted.any(), "{name}: {no_time:?} {correction:?}");
            assert!(told_finite(&correction), "{name}: {no_time:?} {correction:?}");
            assert!(!correction.alpha.above(V::Scalar::of(0.0)).any(), "{name} {correction:?}");
            let next = other.stabilize(&sample, effort);
            assert!(
                told_finite(&next) && next.accepted.all(),
                "{name}: after {no_time:?} {next:?}"
            );
        }
        assert!(one.stabilize(&sample, effort).accepted.all(), "{name}");
    }
}

fn store<T: Scalar>() -> TankLimits<T> {
    let [start, floor, ceiling, power] = [2e-3, 1e-3, 5e-3, 3.0].map(T::of);
    TankLimits { start, floor, ceiling, power }
}

fn every_member<V: Signal>() {
    let of = V::Scalar::of;
    let popc = popc::<V::Scalar>();
    let damper = Dissipation::of(of(0.3)).expect("a damping");
    let lolc = Lolc::new((PortEnergy, damper), limit());
    let axes = V::splat(of(0.5));
    is_rejected::<V>("popc", &popc);
    is_rejected::<V>("lolc", &lolc);
    is_rejected::<V>("lolc, sampled", &lolc.sampled());
    is_rejected::<V>("compensated", &lolc.summed_in::<Compensated<_>>());
    is_rejected::<V>("windowed", &popc.summed_in::<WindowedCredit<_, Plain<_>, 8>>());
    is_rejected::<V>("bounded", &popc.bounded(of(1e-3)).expect("a bound"));
    is_rejected::<V>("threshold", &popc.above_velocity(of(0.01)).expect("a speed"));
    is_rejected::<V>("spread", &popc.spread_over(5).expect("ticks"));
    is_rejected::<V>("rising", &popc.rising_over(5).expect("ticks"));
    is_rejected::<V>("rate", &popc.rate_limited::<V>(of(100.0)).expect("a rate"));
    let weights = AxisWeights::new(axes).expect("weights");
    is_rejected::<V>("weighted", &DirectedDamping::new(popc, weights, limit()));
    let along = AlongDirection::new(axes).expect("a direction");
    is_rejected::<V>("directed", &DirectedDamping::new(popc, along, limit()));
    is_rejected::<V>("two-port", &TwoPortSide::<V>::new(limit()));
    let side = TwoPortSide::<V>::new(limit()).sampled();
    is_rejected::<V>("two-port, sampled", &side);
    is_rejected::<V>("drift", &DriftCompensated::new(side, of(0.1)).expect("a speed"));
    is_rejected::<V>(
        "least-norm",
        &LeastNorm::new(PortEnergy, limit(), of(0.3)).expect("a filter"),
    );
    is_rejected::<V>("force-bound", &ForceBound::new(of(0.1)).expect("a bound"));
    let bounding = ForceBounding::of_damping(of(0.1)).expect("a bound");
    is_rejected::<V>("force-bounding", &bounding);
    is_rejected::<V>("slope-bound", &SlopeBound::<V>::new(of(1e3)).expect("a slope"));
    is_rejected::<V>("tank", &Tank::new(PortEnergy, store()).expect("a tank"));
    is_rejected::<V>("energy-bounding", &EnergyBounding::new(of(500.0), of(250.0)).expect("rates"));
    let tight = EnergyBounding::<V, _>::tight(of(0.5), of(PERIOD)).expect("a damping");
    is_rejected::<V>("tight", &tight);
    let sharing = Sharing { start: of(1e-3), share: of(0.1) };
    let master = TwoLayer::master(sharing, of(1e-3), of(500.0)).expect("an end");
    is_rejected::<V>("two-layer", &master);
    let mut tank = EnergyTank::new(store()).expect("a tank");
    for no_time in NO_TIMES.map(V::Scalar::of) {
        let passed = tank.pass(no_time, of(1.0), axes, axes);
        assert!(passed == V::zero() && tank.energy() == of(2e-3), "{no_time:?} {passed:?}");
    }
}

fn on_one_axis<T: Scalar>() {
    let memory = PathMemory::<T, 32>::beyond(T::of(-0.01), T::of(0.1)).expect("a memory");
    is_rejected::<T>("path-memory", &memory);
    let memory = MemoryBased::<T, 32>::beyond(T::of(-0.01), T::of(0.1)).expect("a memory");
    is_rejected::<T>("memory-based", &memory);
}

#[test]
fn is_rejected_by_every_member() {
    every_member::<f64>();
    every_member::<f32>();
    every_member::<WideF64x4>();
    every_member::<AutoF32x8>();
    every_member::<Vector3<f64>>();
    every_member::<Vector3<AutoF64x4>>();
    on_one_axis::<f64>();
    on_one_axis::<f32>();
    on_one_axis::<AutoF64x4>();
    is_rejected::<Vector3<f64>>("per-axis", &PerAxis::of([popc::<f64>(); 3]));
}

#[test]
fn is_rejected_with_wide_sums() {
    fn wide<T: Widen>() {
        is_rejected::<T>("wide", &popc::<T>().summed_in::<Wide<T>>());
    }
    wide::<f32>();
    wide::<f64>();
}

/// A watchdog holds, and counts no silence of a clock that stepped back.
#[test]
fn is_rejected_under_a_watchdog() {
    let times = WatchdogTimes { hold: 0.01, rise: 0.0 };
    is_rejected::<f64>("watched", &popc::<f64>().watched(times).expect("times"));
}

/// The lane whose clock failed is rejected, the others are as without it.
#[test]
fn only_the_lane_is_rejected() {
    let mut lanes = popc::<AutoF64x4>();
    let mut alone = popc::<f64>();
    for (tick, (sample, effort)) in Samples::<f64>::new(PERIOD).take(400).enumerate() {
        let spread = AutoF64x4::of;
        let period = AutoF64x4::from_lanes(|lane| if lane == tick % 3 { -PERIOD } else { PERIOD });
        let correction = lanes.stabilize(&sample.map(period, spread), spread(effort));
        let expected = alone.stabilize(&sample, effort);
        assert_eq!(correction.effort.lane(3), expected.effort);
        assert_eq!(correction.effort.lane(tick % 3), 0.0);
        for lane in 0..4 {
            assert_eq!(correction.accepted.lane(lane), lane != tick % 3, "{tick}");
            assert_eq!(correction.observed_energy.lane(lane), expected.observed_energy);
        }
    }
}

/// Work is what crossed the port whatever the clock says; a damper's credit needs a time.
#[test]
fn work_is_booked_and_no_credit() {
    let damper = Dissipation::of(2.0).expect("a damping");
    let gave = PortSample { velocity: 0.5, work: -1e-3, ..PortSample::starting(-PERIOD, 0.0, 0.0) };
    let mut held = Lolc::new((PortEnergy, damper), limit::<f64>());
    assert_eq!(held.stabilize(&gave, 1.0).observed_energy, -1e-3);
    let mut sampled = Lolc::new((PortEnergy, damper), limit::<f64>()).sampled();
    assert_eq!(sampled.stabilize(&gave, -1.0).observed_energy, 0.0);
}

/// A guard spans it like any bad sample, over the period before.
#[test]
fn a_guard_spans_it() {
    for no_time in NO_TIMES {
        let wall = Wall::new(1e3, 0.0).expect("a wall");
        let limit = DampingLimit::at(100.0).expect("a limit");
        let mut port = wall.stabilized(Popc::new(PortEnergy, limit)).guarded(Fallback::Zero);
        let at = |position: f64| PortSample::starting(PERIOD, position, 0.0);
        assert_eq!(port.respond(&at(1e-3)), 1.0);
        assert_eq!(port.respond(&PortSample { period: no_time, ..at(2e-3) }), 0.0, "{no_time}");
        assert!(!OnePort::<f64>::correction(&port).accepted);
        assert_eq!(port.respond(&at(1e-3)), 1.0);
        assert!(OnePort::<f64>::correction(&port).accepted);
    }
}

/// A gap beyond the range of the scalar is not handed inside, and the port goes on after it.
#[test]
fn a_guard_hands_no_infinity_inside() {
    let mut seen = Vec::new();
    struct Inside<'a>(&'a mut Vec<PortSample<f32>>);
    impl OnePort<f32> for Inside<'_> {
        fn respond(&mut self, sample: &PortSample<f32>) -> f32 {
            self.0.push(*sample);
            0.0
        }
    }
    let mut port = Inside(&mut seen).guarded(Fallback::Zero);
    for position in [3e38, f32::NAN, -3e38, -3e38, 0.0] {
        port.respond(&PortSample::starting(1e-3, position, 0.0));
    }
    assert!(seen.iter().all(|sample| sample.finite()) && seen.len() == 3, "{seen:?}");
}
