//! Shipped laws, kept by the whole family.

use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::laws::{self, Law, Samples};
use lyapunov::{
    PortEnergy, Scalar, Signal, StorageFunction,
    accumulators::{Compensated, Plain},
    candidates::Always,
    stabilizers::{
        AlongDirection, AxisWeights, DirectedDamping, DriftCompensated, ForceBound, PathMemory,
        PerAxis, ReferenceFollowing, SlopeBound, StabilizerExt, Tank, TankLimits, TwoPortSide,
        WindowedCredit,
    },
    stabilizers::{
        EnergyBounding, ForceBounding, LeastNorm, MemoryBased, ReferenceDamper, Sharing, TwoLayer,
    },
};
use nalgebra::{Vector3, Vector6};

use crate::hostile;
use crate::support::{PERIOD, limit, popc};

fn samples<V: Signal>() -> impl Iterator<Item = Samples<V>> {
    (0..8).map(|seed| Samples::new(V::Scalar::of(PERIOD)).seeded(seed))
}

fn store<T: Scalar>() -> TankLimits<T> {
    let [start, floor, ceiling, power] = [2e-3, 1e-3, 5e-3, 3.0].map(T::of);
    TankLimits { start, floor, ceiling, power }
}

fn alike<V: Signal>() {
    let of = V::Scalar::of;
    let popc = popc::<V::Scalar>();
    let axes = V::splat(of(0.5));
    for samples in samples::<V>() {
        let check = |result: Result<(), laws::Violation>| result.expect("the laws");
        check(laws::stabilizer(&popc.budgeted(of(1e-3)).expect("a budget"), samples));
        check(laws::stabilizer(&popc.bounded(of(1e-3)).expect("a bound"), samples));
        check(laws::stabilizer(&popc.reset_at(Always), samples));
        check(laws::stabilizer(&popc.summed_in::<WindowedCredit<_, Plain<_>, 8>>(), samples));
        check(laws::stabilizer(&popc.summed_in::<WindowedCredit<_, Compensated<_>, 8>>(), samples));
        check(laws::stabilizer(
            &popc.sampled().summed_in::<WindowedCredit<_, Plain<_>, 8>>(),
            samples,
        ));
        check(laws::stabilizer(&popc.above_velocity(of(0.01)).expect("a threshold"), samples));
        check(laws::stabilizer(&popc.spread_over(5).expect("ticks"), samples));
        check(laws::stabilizer(&popc.rising_over(5).expect("ticks"), samples));
        check(laws::stabilizer(&popc.rate_limited::<V>(of(100.0)).expect("a rate"), samples));
        let all = popc
            .bounded(of(1e-3))
            .and_then(|it| it.above_velocity(of(0.01))?.spread_over(3)?.rising_over(4))
            .and_then(|it| it.rate_limited::<V>(of(1e3)));
        check(laws::stabilizer(&all.expect("a chain"), samples));
        let stored = |x: V, _v: V| x.inner(x);
        let candidate = (PortEnergy, StorageFunction::starting(stored, V::zero(), V::zero()));
        check(laws::stabilizer(&ReferenceFollowing::new(candidate, limit()), samples));
        let damper = ReferenceDamper::starting(of(0.1), |x: V| x, V::zero()).expect("a damper");
        let candidate = (PortEnergy, (candidate.1, damper));
        check(laws::stabilizer(&ReferenceFollowing::new(candidate, limit()), samples));
        let least = LeastNorm::new(PortEnergy, limit(), of(0.3)).expect("a filter");
        check(laws::stabilizer(&least, samples));
        check(laws::stabilizer(&TwoPortSide::<V>::new(limit()).sampled(), samples));
        let along = AlongDirection::new(axes).expect("a direction");
        check(laws::stabilizer(&DirectedDamping::new(popc, along, limit()), samples));
        let weights = AxisWeights::new(axes).expect("weights");
        check(laws::stabilizer(&DirectedDamping::new(popc, weights, limit()), samples));
        check(laws::stabilizer(&TwoPortSide::new(limit()), samples));

        let bounding = ForceBounding::of_damping(of(0.1)).expect("a bound");
        check(laws::limiter(&bounding, samples));
        check(laws::limiter(&bounding.delayed::<4>(3).expect("a pipe"), samples));
        let bound = ForceBound::new(of(0.1)).and_then(|bound| bound.budgeted(of(1e-3)));
        check(laws::limiter(&bound.expect("a bound"), samples));
        let slope = SlopeBound::<V>::new(of(1e3)).and_then(|bound| bound.creeping(of(5.0)));
        check(laws::limiter(&slope.expect("a slope"), samples));
        let tank = Tank::new(PortEnergy, store()).expect("a tank");
        check(laws::limiter(&tank, samples));
        check(laws::stabilizer(&tank, samples));
    }
}

/// What serves one axis only.
fn on_one_axis<T: Scalar>() {
    for samples in samples::<T>() {
        let memory = PathMemory::<T, 32>::beyond(T::of(-0.01), T::of(0.1)).expect("a memory");
        laws::limiter(&memory, samples).expect("the laws");
        laws::stabilizer(&memory, samples).expect("the laws");
        let memory = MemoryBased::<T, 32>::beyond(T::of(-0.01), T::of(0.1)).expect("a memory");
        laws::limiter(&memory.delayed(1), samples).expect("the laws");
    }
}

#[test]
fn on_a_line() {
    alike::<f64>();
    alike::<f32>();
    alike::<WideF64x4>();
    alike::<AutoF32x8>();
    on_one_axis::<f64>();
    on_one_axis::<f32>();
    on_one_axis::<WideF64x4>();
    on_one_axis::<AutoF32x8>();
}

#[test]
fn in_space() {
    alike::<Vector3<f64>>();
    alike::<Vector6<f32>>();
    alike::<Vector3<AutoF64x4>>();
    for samples in samples::<Vector3<f64>>() {
        let axis = popc::<f64>().bounded(1e-3).expect("a bound");
        laws::stabilizer(&PerAxis::of([axis; 3]), samples).expect("the laws");
    }
}

/// What is cut off might have braked.
#[test]
fn a_force_bound_is_no_damper() {
    let bound = ForceBound::new(0.1).expect("a bound");
    let broken = laws::stabilizer(&bound, Samples::<f64>::new(PERIOD)).expect_err("it cuts");
    assert_eq!(broken.law, Law::Opposes);
    let broken = laws::limiter(&popc::<f64>(), Samples::<f64>::new(PERIOD)).expect_err("it adds");
    assert_eq!(broken.law, Law::NoLarger);
}

/// Those that neither oppose nor only make smaller: an energy that is handed back is as large a force as is left.
fn answered<V: Signal>() {
    let of = V::Scalar::of;
    hostile::is_answered::<V>(&EnergyBounding::new(of(500.0), of(250.0)).expect("constants"));
    let prompt = EnergyBounding::of_damping(of(0.5), of(PERIOD)).expect("a damping");
    let delayed = prompt.delayed(2).expect("a delay");
    hostile::is_answered::<V>(&delayed);
    let tight = EnergyBounding::<V, _>::tight(of(0.5), of(PERIOD)).expect("a damping");
    hostile::is_answered::<V>(&tight);
    let sharing = Sharing { start: of(1e-3), share: of(0.1) };
    let master = TwoLayer::master(sharing, of(1e-3), of(500.0)).expect("an end");
    hostile::is_answered::<V>(&master);
    let side = TwoPortSide::<V>::new(limit()).sampled();
    hostile::is_answered::<V>(&DriftCompensated::new(side, of(0.1)).expect("a speed"));
}

#[test]
fn what_is_not_sound_is_answered() {
    answered::<f64>();
    answered::<f32>();
    answered::<WideF64x4>();
    answered::<Vector3<f64>>();
}
