//! Snapshots of every stabilizer, bit for bit after arbitrary sequences.

use std::cell::Cell;

use nalgebra::{Matrix2, Vector2};
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::test_runner::{Config, TestRunner};
use serde::{Serialize, de::DeserializeOwned};

use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, PortEnergy, PortSample, Scalar, Signal, Snapshot,
    Stabilizer, StorageFunction,
    accumulators::{Compensated, DoubleDouble, Plain, Wide},
    candidates::InContact,
    laws::{self, Samples},
    poses::Screw,
    stabilizers::{
        AlongDirection, DirectedDamping, DriftCompensated, EnergyBounding, ForceBound,
        ForceBounding, InertiaLimit, JointInertia, LeastNorm, MemoryBased, NoStabilizer,
        PathMemory, PerAxis, PerPart, ReferenceDamper, ReferenceFollowing, Sharing, SlopeBound,
        StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide, WatchdogTimes, WindowedCredit,
    },
};

use crate::support::{PERIOD, has_a_text, limit, loaded, popc, read, stored, written};

/// The numbers of a correction, bit by bit.
fn bits<V: Signal>(correction: &Correction<V>) -> String {
    format!("{correction:?}")
}

/// What is stored at any tick of any sequence, bad samples among them, goes on as the one that was not interrupted.
pub(crate) fn goes_on<V, S>(stabilizer: S)
where
    V: Signal,
    S: Stabilizer<V> + Snapshot<State: Serialize + DeserializeOwned> + Clone,
{
    let ticks = vec((0usize..2000, 0u8..24), 2..40);
    let mut runner = TestRunner::new(Config { cases: 24, ..Config::default() });
    let texts = Cell::new(0);
    let tried = runner.run(&(ticks, any::<u64>(), 0usize..40), |(ticks, seed, cut)| {
        let samples: Vec<_> = Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(seed).collect();
        let mut running = stabilizer.clone();
        let mut resumed = Vec::new();
        for (at, (pick, flaw)) in ticks.iter().enumerate() {
            let (sample, effort) = samples[*pick];
            let (sample, effort) = flawed(sample, effort, *flaw);
            if at == cut % ticks.len() {
                let bytes = stored(&running.state());
                let state: S::State = loaded(&bytes);
                assert_eq!(stored(&state), bytes);
                resumed.push(stabilizer.clone().restored(state).expect("a state"));
                if has_a_text(&bytes) {
                    let text = written(&running.state());
                    let state: S::State = read(&text);
                    assert_eq!(stored(&state), bytes, "{text}");
                    resumed.push(stabilizer.clone().restored(state).expect("a state"));
                    texts.set(texts.get() + 1);
                }
            }
            let correction = running.stabilize(&sample, effort);
            for resumed in &mut resumed {
                assert_eq!(bits(&resumed.stabilize(&sample, effort)), bits(&correction));
            }
        }
        assert!(!resumed.is_empty());
        for resumed in resumed {
            assert_eq!(stored(&resumed.state()), stored(&running.state()));
        }
        Ok(())
    });
    tried.expect("every sequence");
    assert!(texts.get() > 5, "{} texts", texts.get());
}

/// A sample and an effort of which one number may be bad.
fn flawed<V: Signal>(sample: PortSample<V>, effort: V, flaw: u8) -> (PortSample<V>, V) {
    let bad = V::Scalar::of([f64::NAN, f64::INFINITY, f64::NEG_INFINITY][usize::from(flaw % 3)]);
    let spoilt = V::splat(bad);
    match flaw / 3 {
        0 => (PortSample { work: spoilt, ..sample }, effort),
        1 => (PortSample { velocity: spoilt, displacement: spoilt, ..sample }, effort),
        2 => (PortSample { position: spoilt, period: bad, ..sample }, effort),
        3 => (sample, spoilt),
        _ => (sample, effort),
    }
}

/// Both, and the law.
pub(crate) fn resumes<V, S>(stabilizer: S)
where
    V: Signal,
    S: Stabilizer<V> + Snapshot<State: Serialize + DeserializeOwned> + Clone,
{
    let samples = Samples::<V>::new(V::Scalar::of(PERIOD));
    laws::snapshot(&stabilizer, samples).expect("the law");
    goes_on::<V, S>(stabilizer);
}

#[test]
fn the_observers_of_every_sum() {
    let lolc = Lolc::new((PortEnergy, Dissipation::of(0.1).expect("one")), limit::<f64>());
    resumes::<f64, _>(lolc);
    resumes::<f64, _>(lolc.sampled());
    resumes::<f64, _>(lolc.summed_in::<Compensated<f64>>());
    resumes::<f64, _>(lolc.summed_in::<Wide<f64>>());
    resumes::<f64, _>(lolc.summed_in::<Compensated<f64>>().sampled());
    resumes::<f32, _>(popc::<f32>().summed_in::<Wide<f32>>());
    resumes::<f32, _>(popc::<f32>().summed_in::<Compensated<f32>>());
    resumes::<Vector2<f64>, _>(lolc);
    resumes::<f64, _>(popc::<f64>().summed_in::<WindowedCredit<f64, Plain<f64>, 8>>());
    let slots = WindowedCredit::<f64, Plain<f64>, 4>::of_ticks(7).expect("one");
    resumes::<f64, _>(popc::<f64>().summed_by(slots));
}

#[test]
fn candidates_with_memory() {
    let energy = |x: f64, v: f64| 0.5 * (0.3 * v * v + 50.0 * x * x);
    let storage = StorageFunction::starting(energy, 0.1, 0.0);
    resumes::<f64, _>(Lolc::new(storage, limit()));
    let depth = |x: f64| x.max(0.0);
    let damper = ReferenceDamper::starting(2.0, depth, -0.01).expect("one");
    let following: ReferenceFollowing<f64, _> =
        ReferenceFollowing::new((PortEnergy, (storage, damper)), limit());
    resumes::<f64, _>(following);
    resumes::<f64, _>(Lolc::new((PortEnergy, storage, damper), limit()));
}

#[test]
fn adaptors() {
    let popc = popc::<f64>();
    resumes::<f64, _>(popc.bounded(1e-3).expect("one"));
    resumes::<f64, _>(popc.reset_at(InContact { position: 0.0 }));
    resumes::<f64, _>(popc.above_velocity(0.01).expect("one"));
    resumes::<f64, _>(popc.spread_over(5).expect("one"));
    resumes::<f64, _>(popc.rising_over(5).expect("one"));
    resumes::<f64, _>(popc.rate_limited::<f64>(100.0).expect("one"));
    let times = WatchdogTimes { hold: 2.5e-3, rise: 20e-3 };
    resumes::<f64, _>(popc.watched::<f64>(times).expect("one"));
    resumes::<f64, _>(DriftCompensated::<_, f64>::new(popc, 0.1).expect("one"));
    let normal = AlongDirection::new(Vector2::new(0.0, 1.0)).expect("one");
    resumes::<Vector2<f64>, _>(DirectedDamping::new(popc, normal, limit()));
    resumes::<Vector2<f64>, _>(PerAxis::of([popc; 2]));
    let inertia = JointInertia::new(Matrix2::new(0.3, 0.1, 0.1, 0.2)).expect("one");
    resumes::<Vector2<f64>, _>(InertiaLimit::new(popc, inertia, 0.5, PERIOD).expect("one"));
    resumes::<Screw<f64>, _>(PerPart::of(popc, popc.spread_over::<f64>(3).expect("one")));
    let chain = popc.bounded(1e-2).and_then(|it| it.spread_over(4));
    let chain = chain.and_then(|it| it.rate_limited::<f64>(2000.0)).expect("one");
    resumes::<f64, _>(chain.watched::<f64>(times).expect("one"));
    resumes::<f64, _>(NoStabilizer);
}

#[test]
fn limiters() {
    let store = TankLimits { start: 2e-3, floor: 0.0, ceiling: 5e-3, power: 3.0 };
    resumes::<f64, _>(Tank::new(PortEnergy, store).expect("one"));
    resumes::<f64, _>(LeastNorm::new(PortEnergy, limit(), 0.3).expect("one"));
    resumes::<f64, _>(ForceBound::new(0.1).expect("one"));
    resumes::<f64, _>(
        ForceBounding::of_damping(0.1).and_then(|it| it.delayed::<4>(3)).expect("one"),
    );
    resumes::<f64, _>(EnergyBounding::<f64>::new(500.0, 250.0).expect("one"));
    resumes::<f64, _>(SlopeBound::<f64>::new(1e3).and_then(|it| it.creeping(5.0)).expect("one"));
    resumes::<f64, _>(PathMemory::<f64, 40>::beyond(-0.01, 0.1).expect("one"));
    resumes::<f64, _>(MemoryBased::<f64, 40>::beyond(-0.01, 0.1).expect("one"));
}

#[test]
fn ends_of_a_channel() {
    let mut side = TwoPortSide::<f64>::new(limit());
    side.receive(0.25);
    resumes::<f64, _>(side);
    resumes::<f64, _>(side.sampled());
    let sharing = Sharing { start: 1e-3, share: 0.1 };
    let mut master = TwoLayer::master(sharing, 1e-3, 500.0).expect("one");
    master.receive(0.25);
    resumes::<f64, _>(master);
}

/// Lanes have snapshots too, kept in memory.
#[test]
fn lanes() {
    use lyapunov::lanes::AutoF64x4;
    let popc = popc::<AutoF64x4>().spread_over::<AutoF64x4>(4).expect("one");
    laws::snapshot(&popc, Samples::<AutoF64x4>::new(AutoF64x4::of(PERIOD))).expect("the law");
}

/// Both parts of a wide number are stored.
#[test]
fn thirty_digits() {
    let third = DoubleDouble::of(1.0) / DoubleDouble::of(3.0);
    for number in [third, -third, DoubleDouble::of(-0.0), DoubleDouble::of(0.0)] {
        let again: DoubleDouble = loaded(&stored(&number));
        let parts = |it: DoubleDouble| (it.high().to_bits(), it.low().to_bits());
        assert_eq!(parts(again), parts(number));
    }
}

/// A forgetful snapshot is found by the law.
#[test]
fn the_law_finds_what_is_forgotten() {
    #[derive(Clone)]
    struct Forgetful(lyapunov::Popc<f64>);
    impl Stabilizer<f64> for Forgetful {
        fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
            self.0.stabilize(sample, effort)
        }
    }
    impl Snapshot for Forgetful {
        type State = ();

        fn state(&self) {}

        fn restored(self, _state: ()) -> Result<Self, lyapunov::ParameterError> {
            Ok(self)
        }
    }
    let popc = lyapunov::Popc::new(PortEnergy, DampingLimit::at(10.0).expect("one"));
    let found = laws::snapshot(&Forgetful(popc), Samples::new(PERIOD));
    assert_eq!(found.expect_err("a broken law").law, laws::Law::Resumes);
}
