//! Lanes of the family, each equal to its scalar run bit for bit.

use lyapunov::lanes::{AutoF32x4, AutoF64x4, WideF64x4};
use lyapunov::laws::Samples;
use lyapunov::{
    PortEnergy, PortSample, Scalar, Stabilizer,
    accumulators::Plain,
    candidates::InContact,
    stabilizers::{
        AxisWeights, DirectedDamping, DriftCompensated, ForceBound, PathMemory, SlopeBound,
        StabilizerExt, Tank, TankLimits, TwoPortSide, WaveTransform, WindowedCredit,
    },
    stabilizers::{EnergyBounding, ForceBounding, LeastNorm, MemoryBased, Sharing, TwoLayer},
};

use crate::support::{PERIOD, limit, popc};

/// One of the family by number, built alike for every scalar.
fn build<T: Scalar>(number: usize) -> Option<Box<dyn Stabilizer<T>>> {
    let of = T::of;
    let popc = popc::<T>();
    let store = TankLimits { start: of(2e-3), floor: of(0.0), ceiling: of(5e-3), power: of(3.0) };
    Some(match number {
        0 => Box::new(popc.bounded(of(1e-3)).expect("one")),
        1 => Box::new(popc.reset_at(InContact { position: of(0.0) })),
        2 => Box::new(popc.summed_in::<WindowedCredit<T, Plain<T>, 8>>()),
        3 => Box::new(popc.above_velocity(of(0.01)).expect("one")),
        4 => Box::new(popc.spread_over(5).expect("one")),
        5 => Box::new(popc.rising_over(5).expect("one")),
        6 => Box::new(popc.rate_limited::<T>(of(100.0)).expect("one")),
        7 => Box::new(ForceBound::new(of(0.1)).expect("one")),
        8 => Box::new(Tank::new(PortEnergy, store).expect("one")),
        9 => Box::new(DirectedDamping::new(popc, AxisWeights::new(of(0.5)).expect("one"), limit())),
        10 => Box::new(TwoPortSide::new(limit())),
        11 => Box::new(DriftCompensated::<_, T>::new(popc, of(0.1)).expect("one")),
        12 => Box::new(
            SlopeBound::<T>::new(of(1e3)).and_then(|it| it.creeping(of(5.0))).expect("one"),
        ),
        13 => Box::new(PathMemory::<T, 32>::beyond(of(-0.01), of(0.1)).expect("one")),
        14 => Box::new(EnergyBounding::<T>::new(of(500.0), of(250.0)).expect("one")),
        15 => Box::new(
            EnergyBounding::<T>::of_damping(of(0.5), of(PERIOD))
                .and_then(|it| it.delayed(2))
                .expect("one"),
        ),
        16 => Box::new(EnergyBounding::<T, _>::tight(of(0.5), of(PERIOD)).expect("one")),
        17 => Box::new(ForceBounding::of_damping(of(0.1)).expect("one")),
        18 => Box::new(
            ForceBounding::of_damping(of(0.1)).and_then(|it| it.delayed::<4>(3)).expect("one"),
        ),
        19 => Box::new(MemoryBased::<T, 32>::beyond(of(-0.01), of(0.1)).expect("one").delayed(1)),
        20 => Box::new(LeastNorm::new(PortEnergy, limit(), of(0.3)).expect("one")),
        21 => {
            let sharing = Sharing { start: of(1e-3), share: of(0.1) };
            Box::new(TwoLayer::master(sharing, of(1e-3), of(500.0)).expect("one"))
        }
        22 => Box::new(TwoPortSide::new(limit()).sampled()),
        _ => return None,
    })
}

fn lane<L: Scalar, T: Scalar>(sample: &PortSample<L>, lane: usize) -> PortSample<T> {
    let of = |value: L| T::of(value.lane(lane));
    sample.map(of(sample.period), of)
}

fn alike<L: Scalar, T: Scalar>() {
    for number in 0.. {
        let Some(mut lanes) = build::<L>(number) else { break };
        let mut scalars: Vec<_> = (0..L::LANES).filter_map(|_| build::<T>(number)).collect();
        for (sample, effort) in Samples::<L>::new(L::of(PERIOD)).seeded(3) {
            let together = lanes.stabilize(&sample, effort);
            for (index, scalar) in scalars.iter_mut().enumerate() {
                let alone = scalar.stabilize(&lane(&sample, index), T::of(effort.lane(index)));
                for (a, b) in [
                    (together.effort, alone.effort),
                    (together.observed_energy, alone.observed_energy),
                    (together.alpha, alone.alpha),
                    (together.shortfall, alone.shortfall),
                ] {
                    assert_eq!(a.lane(index).to_bits(), b.lane(0).to_bits(), "number {number}");
                }
            }
        }
    }
}

#[test]
fn each() {
    alike::<AutoF64x4, f64>();
    alike::<WideF64x4, f64>();
    alike::<AutoF32x4, f32>();
}

#[test]
fn waves() {
    let (lanes, alone) = (WaveTransform::new(WideF64x4::of(0.7)), WaveTransform::new(0.7));
    let (lanes, alone) = (lanes.expect("one"), alone.expect("one"));
    let [v, f] = [0.3, -1.0].map(|base| WideF64x4::from_lanes(|lane| base + lane as f64 * 0.61));
    for index in 0..4 {
        let (there, back) = lanes.encode(v, f);
        let (one, other) = alone.encode(v.lane(index), f.lane(index));
        assert_eq!((there.lane(index), back.lane(index)), (one, other));
        let (flow, effort) = lanes.decode(there, back);
        assert_eq!((flow.lane(index), effort.lane(index)), alone.decode(one, other));
    }
}
