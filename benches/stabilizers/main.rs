//! Time of one tick of each stabilizer, in ns: `stabilizers/<name>/<f32|f64>/<1|3|6>dof`.
//!
//! All of them get the same samples, on which a controller acts now and then. Compare ids of one scalar and width with
//! one another. `<name>-by-hand` is the same as straight code, for four of them; `benches/instructions` compares
//! instructions. `popc-member` and `popc-boxed` are chosen at run time; `popc-recorded` keeps each tick in a ring and in an
//! energy meter.

mod hand;

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, OnePort, Popc, PortEnergy, PortSample, Scalar,
    Signal, Stabilizer, StorageFunction,
    accumulators::Plain,
    candidates::{Gate, InContact},
    environments::Spring,
    laws::Samples,
    stabilizers::{
        AxisWeights, CoupledPort, DirectedDamping, ForceBound, PathMemory, ReferenceFollowing,
        SlopeBound, StabilizerExt, Tank, TankLimits, TwoPortSide, VirtualCoupling, WindowedCredit,
    },
    stabilizers::{
        EnergyBounding, ForceBounding, InputToState, LeastNorm, Member, MemoryBased, Sharing,
        TwoLayer,
    },
    telemetry::{EnergyMeter, TickRing},
};
use nalgebra::{Vector3, Vector6};

const PERIOD: f64 = 1e-3;
/// The largest damping that may be injected, half of 0.2 kg per period, N·s/m.
const MOST: f64 = 100.0;
/// The credited damping, N·s/m.
const CREDIT: f64 = 0.001;
/// The damping that a force bound relies on, N·s/m.
const BOUND_DAMPING: f64 = 0.1;
/// A tank's start, floor and ceiling, J, and its power, W.
const STORE: [f64; 4] = [2e-3, 1e-3, 5e-3, 3.0];

#[inline(never)]
fn block<V: Signal>(
    stabilizer: &mut impl Stabilizer<V>,
    samples: &[(PortSample<V>, V)],
    corrections: &mut [Correction<V>],
) {
    for ((sample, effort), correction) in samples.iter().zip(corrections) {
        *correction = stabilizer.stabilize(sample, *effort);
    }
}

/// Timing of `block`, which takes `ticks` ticks, so that one iteration of the report is one tick.
fn report(
    criterion: &mut Criterion,
    (name, port): (&str, &str),
    ticks: usize,
    mut block: impl FnMut(),
) {
    let length = ticks as u64;
    criterion.bench_function(&format!("stabilizers/{name}/{port}"), |bencher| {
        bencher.iter_custom(|ticks| {
            let blocks = ticks.div_ceil(length);
            let start = Instant::now();
            for _ in 0..blocks {
                block();
            }
            start.elapsed().mul_f64(ticks as f64 / (blocks * length) as f64)
        });
    });
}

fn time<V: Signal>(
    criterion: &mut Criterion,
    id: (&str, &str),
    mut stabilizer: impl Stabilizer<V>,
) {
    let samples: Vec<_> = Samples::<V>::new(V::Scalar::of(PERIOD)).collect();
    let mut corrections = vec![Correction::none(V::zero()); samples.len()];
    report(criterion, id, samples.len(), || {
        block(black_box(&mut stabilizer), black_box(&samples), black_box(&mut corrections));
    });
}

macro_rules! by_hand {
    ($criterion:ident, $real:ident, $n:literal, $($name:literal: $form:ident),+) => {{
        let samples = hand::$real::samples::<$n>(PERIOD);
        let mut told = vec![hand::$real::Told::NOTHING; samples.len()];
        let port = concat!(stringify!($real), "/", $n, "dof");
        $(
            let mut form = hand::$real::$form::NEW;
            report($criterion, (concat!($name, "-by-hand"), port), samples.len(), || {
                hand::$real::block(black_box(&mut form), black_box(&samples), black_box(&mut told));
            });
        )+
    }};
    ($criterion:ident, $($real:ident: $n:literal),+) => {
        $(by_hand!(
            $criterion, $real, $n,
            "popc": Popc, "lolc": Lolc, "force-bound": Bound, "tank": Tank
        );)+
    };
}

/// Gate that is open beyond a surface on the first axis, or on the sum of several.
#[derive(Clone, Copy, Debug)]
struct Inside<T>(InContact<T>);

impl<V: Signal> Gate<V> for Inside<V::Scalar> {
    fn open(&self, sample: &PortSample<V>) -> <V::Scalar as Scalar>::Mask {
        sample.position.sum().above(self.0.position)
    }
}

/// Port in the place of a stabilizer, which ignores the effort and responds by itself.
struct Port<P>(P);

impl<V: Signal, P: OnePort<V>> Stabilizer<V> for Port<P> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, _effort: V) -> Correction<V> {
        Correction::none(self.0.respond(sample))
    }
}

/// POPC with all its telemetry.
struct Recorded<V: Signal> {
    popc: Popc<V::Scalar>,
    ring: TickRing<V, 256>,
    meter: EnergyMeter<V::Scalar>,
}

impl<V: Signal> Stabilizer<V> for Recorded<V> {
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let correction = self.popc.stabilize(sample, effort);
        self.ring.push(sample, &correction);
        self.meter.add(sample, &correction);
        correction
    }
}

fn family<V: Signal>(criterion: &mut Criterion, port: &str) {
    let of = V::Scalar::of;
    let fine = "what is built";
    let limit = DampingLimit::at(of(MOST)).expect(fine);
    let popc: Popc<V::Scalar> = Popc::new(PortEnergy, limit);
    let credit = Dissipation::of(of(CREDIT)).expect(fine);
    let stored = |x: V, _v: V| x.inner(x);
    let reference = (PortEnergy, StorageFunction::starting(stored, V::zero(), V::zero()));
    let [start, floor, ceiling, power] = STORE.map(of);
    let store = TankLimits { start, floor, ceiling, power };
    let windowed = popc.summed_in::<WindowedCredit<_, Plain<_>, 16>>();
    let weights = AxisWeights::new(V::splat(of(0.5))).expect(fine);
    time::<V>(criterion, ("popc", port), popc);
    time::<V>(criterion, ("popc-member", port), Member::<V>::Popc(popc));
    let boxed: Box<dyn Stabilizer<V>> = Box::new(popc);
    time::<V>(criterion, ("popc-boxed", port), boxed);
    let recorded = Recorded::<V> { popc, ring: TickRing::new(), meter: EnergyMeter::new() };
    time::<V>(criterion, ("popc-recorded", port), recorded);
    time::<V>(criterion, ("lolc", port), Lolc::new((PortEnergy, credit), limit));
    time::<V>(criterion, ("bounded", port), popc.bounded(of(1e-3)).expect(fine));
    let reset = popc.reset_at(Inside(InContact { position: of(0.0) }));
    time::<V>(criterion, ("contact-reset", port), reset);
    time::<V>(criterion, ("windowed", port), windowed);
    time::<V>(criterion, ("threshold", port), popc.above_velocity(of(0.01)).expect(fine));
    time::<V>(criterion, ("spread", port), popc.spread_over(5).expect(fine));
    time::<V>(criterion, ("rise", port), popc.rising_over(5).expect(fine));
    time::<V>(criterion, ("rate-limit", port), popc.rate_limited::<V>(of(100.0)).expect(fine));
    time::<V>(criterion, ("reference", port), ReferenceFollowing::new(reference, limit));
    time::<V>(criterion, ("force-bound", port), ForceBound::new(of(BOUND_DAMPING)).expect(fine));
    time::<V>(criterion, ("slope-bound", port), SlopeBound::<V>::new(of(1e3)).expect(fine));
    time::<V>(criterion, ("tank", port), Tank::new(PortEnergy, store).expect(fine));
    let slope = of(BOUND_DAMPING / PERIOD);
    let bounding = EnergyBounding::<V>::new(slope, slope).expect(fine);
    time::<V>(criterion, ("energy-bounding", port), bounding);
    let bounding = ForceBounding::of_damping(of(BOUND_DAMPING)).expect(fine);
    time::<V>(criterion, ("force-bounding", port), bounding);
    let least = LeastNorm::new(PortEnergy, limit, of(1.0)).expect(fine);
    time::<V>(criterion, ("least-norm", port), least);
    let sharing = Sharing { start: of(1e-3), share: of(0.1) };
    let master = TwoLayer::master(sharing, of(5e-3), of(200.0)).expect(fine);
    time::<V>(criterion, ("two-layer", port), master);
    time::<V>(criterion, ("aimed", port), DirectedDamping::new(popc, weights, limit));
    time::<V>(criterion, ("two-port-side", port), TwoPortSide::new(limit));
    let coupling = VirtualCoupling { stiffness: of(1e3), damping: of(0.1), drag: of(5.0) };
    let coupled = CoupledPort::new(Spring::<V>::new(of(1e4)).expect(fine), coupling).expect(fine);
    time::<V>(criterion, ("coupling", port), Port(coupled));
    let spring = Spring::<V>::new(of(1e4)).expect(fine);
    let asked = InputToState::new(spring, of(1.7e4), of(5e-3)).expect(fine);
    time::<V>(criterion, ("iss", port), Port(asked));
}

fn line<T: Scalar>(criterion: &mut Criterion, port: &str) {
    let memory = PathMemory::<T, 64>::beyond(T::of(-0.005), T::of(0.01)).expect("what is built");
    time::<T>(criterion, ("path-memory-64", port), memory);
    let memory = MemoryBased::<T, 64>::beyond(T::of(-0.005), T::of(0.01)).expect("what is built");
    time::<T>(criterion, ("memory-based-64", port), memory);
}

fn all(criterion: &mut Criterion) {
    family::<f64>(criterion, "f64/1dof");
    line::<f64>(criterion, "f64/1dof");
    family::<Vector3<f64>>(criterion, "f64/3dof");
    family::<Vector6<f64>>(criterion, "f64/6dof");
    family::<f32>(criterion, "f32/1dof");
    line::<f32>(criterion, "f32/1dof");
    family::<Vector3<f32>>(criterion, "f32/3dof");
    family::<Vector6<f32>>(criterion, "f32/6dof");
    by_hand!(criterion, f64: 1, f64: 3, f64: 6, f32: 1, f32: 3, f32: 6);
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(400))
        .sample_size(20);
    targets = all
}
criterion_main!(benches);
