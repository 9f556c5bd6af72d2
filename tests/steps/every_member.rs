//! Shipped laws and snapshots, of every member that answers on one axis.

use lyapunov::laws::{self, Samples};
use lyapunov::{
    Correction, Dissipation, Lolc, Popc, PortEnergy, PortSample, Snapshot, Stabilizer,
    accumulators::{Compensated, Plain},
    candidates::InContact,
    stabilizers::{
        AlongDirection, AxisWeights, DirectedDamping, DriftCompensated, EnergyBounding, ForceBound,
        ForceBounding, LeastNorm, Member, MemoryBased, NoStabilizer, PathMemory, Plausibility,
        Sharing, SlopeBound, StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide, WatchdogTimes,
        WindowedCredit,
    },
};

use crate::support::{PERIOD, limit, popc};

/// What a member promises besides finite answers.
enum Manner {
    Damps,
    Reduces,
    Answers,
}

use Manner::{Answers, Damps, Reduces};

/// A stabilizer that can be copied though its type is not known: the laws are built once for all of them.
trait Copied: Stabilizer<f64> {
    fn copied(&self) -> Box<dyn Copied>;
}

impl<S: Stabilizer<f64> + Clone + 'static> Copied for S {
    fn copied(&self) -> Box<dyn Copied> {
        Box::new(self.clone())
    }
}

struct Any(Box<dyn Copied>);

impl Clone for Any {
    fn clone(&self) -> Self {
        Self(self.0.copied())
    }
}

impl Stabilizer<f64> for Any {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        self.0.stabilize(sample, effort)
    }
}

fn any(member: impl Copied + 'static) -> Any {
    Any(Box::new(member))
}

/// The member, once it has gone on from each of its memories as if nothing had been.
fn resumed<S: Copied + Snapshot + Clone + 'static>(member: S) -> Any {
    let resumed = laws::snapshot(&member, samples());
    resumed.unwrap_or_else(|broken| panic!("{}: {broken}", std::any::type_name::<S>()));
    any(member)
}

/// The members of the enumeration, by their names, in its order.
fn named() -> Vec<(Member<f64>, Manner)> {
    let popc: Popc<f64> = popc();
    let lolc = Lolc::new((PortEnergy, Dissipation::of(0.3).expect("a damping")), limit());
    let window = WindowedCredit::of_ticks(5).expect("a window");
    let weights = AxisWeights::new(0.5).expect("weights");
    let along = AlongDirection::new(0.5).expect("a direction");
    let store = TankLimits { start: 2e-3, floor: 1e-3, ceiling: 5e-3, power: 3.0 };
    vec![
        (Member::NoStabilizer(NoStabilizer), Answers),
        (Member::Popc(popc), Damps),
        (Member::Lolc(lolc), Damps),
        (Member::Bounded(popc.bounded(1e-3).expect("a bound")), Damps),
        (Member::Windowed(popc.summed_by(window)), Damps),
        (Member::Threshold(popc.above_velocity(0.01).expect("a speed")), Damps),
        (Member::Spread(popc.spread_over(5).expect("ticks")), Damps),
        (Member::RateLimited(popc.rate_limited::<f64>(100.0).expect("a rate")), Damps),
        (Member::Rising(popc.rising_over(5).expect("ticks")), Damps),
        (Member::Weighted(DirectedDamping::new(popc, weights, limit())), Damps),
        (Member::Directed(DirectedDamping::new(popc, along, limit())), Damps),
        (Member::ForceBound(ForceBound::new(0.1).expect("a damping")), Reduces),
        (Member::Tank(Tank::new(PortEnergy, store).expect("a tank")), Reduces),
        (Member::EnergyBounding(EnergyBounding::new(500.0, 250.0).expect("constants")), Answers),
        (Member::ForceBounding(ForceBounding::of_damping(0.1).expect("a damping")), Reduces),
        (Member::LeastNorm(LeastNorm::new(PortEnergy, limit(), 0.3).expect("a decay")), Damps),
        (Member::SlopeBound(SlopeBound::new(1e3).expect("a slope")), Reduces),
    ]
}

/// What the enumeration does not hold.
fn others() -> Vec<(&'static str, Any, Manner)> {
    let popc: Popc<f64> = popc();
    let surface = InContact { position: 0.0 };
    let store = TankLimits { start: 2e-3, floor: 1e-3, ceiling: 5e-3, power: 3.0 };
    let side: TwoPortSide<f64> = TwoPortSide::new(limit());
    let sharing = Sharing { start: 1e-3, share: 0.1 };
    let master: TwoLayer<f64> = TwoLayer::master(sharing, 5e-3, 200.0).expect("an end");
    let bounding: ForceBounding<f64> = ForceBounding::of_damping(0.1).expect("a damping");
    let memory = MemoryBased::<f64, 16>::beyond(-0.01, 0.1).expect("a memory");
    let path = PathMemory::<f64, 16>::beyond(-0.01, 0.1).expect("a memory");
    let plausible = Plausibility { speed: 1e3, effort: 1e6 };
    let times = WatchdogTimes { hold: 3e-3, rise: 0.1 };
    let drift = DriftCompensated::<_, f64>::new(side.sampled(), 0.1).expect("a speed");
    let tight = EnergyBounding::<f64, _>::tight(0.5, PERIOD).expect("a damping");
    let bounded_tank = Tank::new(PortEnergy, store).expect("a tank");
    vec![
        ("sampled", resumed(popc.sampled()), Damps),
        ("compensated", resumed(popc.summed_in::<Compensated<f64>>()), Damps),
        ("windowed", resumed(popc.summed_in::<WindowedCredit<f64, Plain<f64>, 8>>()), Damps),
        ("contact reset", resumed(popc.reset_at(surface)), Damps),
        ("two-port", resumed(side), Damps),
        ("two-port, sampled", resumed(side.sampled()), Damps),
        ("plausible", resumed(popc.plausible(plausible).expect("limits")), Damps),
        ("watched", resumed(popc.watched(times).expect("times")), Answers),
        ("late", resumed(bounding.delayed::<4>(3).expect("a pipe")), Reduces),
        ("memory-based", resumed(memory), Reduces),
        ("path memory", resumed(path), Reduces),
        ("tank", resumed(bounded_tank), Damps),
        ("drift", resumed(drift), Answers),
        ("two-layer", resumed(master), Answers),
        ("tight", resumed(tight), Answers),
    ]
}

fn samples() -> impl Iterator<Item = (PortSample<f64>, f64)> {
    Samples::<f64>::new(PERIOD).seeded(2).take(300)
}

fn keeps(name: &str, member: &Any, manner: &Manner) {
    match manner {
        Damps => laws::stabilizer(member, samples()).expect(name),
        Reduces => laws::limiter(member, samples()).expect(name),
        Answers => {}
    }
    // A sound sample is answered by finite numbers; over no time, or asked for no number, nothing is done.
    let mut one = member.clone();
    for (sample, effort) in samples() {
        for period in [-PERIOD, -0.0, 0.0, f64::NAN, f64::INFINITY] {
            let told = one.clone().stabilize(&PortSample { period, ..sample }, effort);
            let damps = told.alpha > 0.0;
            assert!(
                name == "none" || !told.accepted && !damps && told.effort.is_finite(),
                "{name} {told:?}"
            );
        }
        let Correction { effort, observed_energy, alpha, shortfall, accepted } =
            one.stabilize(&sample, effort);
        let finite = [effort, observed_energy, alpha, shortfall].into_iter().all(f64::is_finite);
        assert!(finite && accepted && alpha >= 0.0 && shortfall >= 0.0, "{name} {sample:?}");
    }
}

#[test]
fn every_member_keeps_its_laws() {
    for (member, manner) in named() {
        keeps(member.name(), &any(member), &manner);
    }
    for (name, member, manner) in others() {
        keeps(name, &member, &manner);
    }
}

#[test]
fn every_name_is_that_of_its_member() {
    let names: Vec<_> = named().iter().map(|(member, _)| member.name()).collect();
    assert_eq!(names, Member::<f64>::NAMES);
}

/// From a stored memory a member goes on as itself; that of another one is refused, with the places of both.
#[test]
fn a_memory_is_that_of_its_member() {
    for (own, (member, _)) in named().into_iter().enumerate() {
        let resumed = laws::snapshot(&member, samples());
        resumed.unwrap_or_else(|broken| panic!("{}: {broken}", member.name()));
        for (place, (other, _)) in named().into_iter().enumerate() {
            let restored = other.restored(member.state());
            assert_eq!(restored.is_ok(), own == place, "{} in {}", member.name(), other.name());
            if let Err(error) = restored {
                let told = error.to_string();
                let bound = if own > place {
                    format!("at most {place}.0")
                } else {
                    format!("at least {place}.0 and")
                };
                assert!(error.value == own as f64 && told.contains(&bound), "{told}");
            }
        }
    }
}
