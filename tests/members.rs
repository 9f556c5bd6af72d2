//! Members of the family chosen at run time: each is what it holds, bit for bit, in an enumeration and in a box.

use lyapunov::lanes::{AutoF64x4, WideF64x4};
use lyapunov::laws::{self, Samples};
use lyapunov::{
    Correction, DampingLimit, Dissipation, Held, HeldTick, Lolc, OnePort, Plant, Popc, PortEnergy,
    Scalar, Signal, Snapshot, Stabilizer,
    accumulators::Plain,
    bodies::{Body, Impedance},
    environments::Wall,
    stabilizers::{
        AlongDirection, AxisWeights, DirectedDamping, EnergyBounding, ForceBound, ForceBounding,
        LeastNorm, Member, MemberState, NoStabilizer, SlopeBound, StabilizerExt, Tank, TankLimits,
        WindowedCredit,
    },
};
use nalgebra::{Vector3, Vector6};
use serde::Serialize;
use serde::de::DeserializeOwned;

const PERIOD: f64 = 1e-3;

fn limit<T: Scalar>() -> DampingLimit<T> {
    DampingLimit::of_mass(T::of(0.5), T::of(0.2), T::of(PERIOD)).expect("a limit")
}

/// Each member by its name, with the stabilizer that it holds in a box beside it.
fn named<V: Signal>(name: &str) -> Option<(Member<V>, Box<dyn Stabilizer<V>>)> {
    macro_rules! both {
        ($variant:ident, $stabilizer:expr) => {{
            let stabilizer = $stabilizer;
            (Member::$variant(stabilizer), Box::new(stabilizer))
        }};
    }
    let of = V::Scalar::of;
    let popc = Popc::new(PortEnergy, limit());
    let axes = V::splat(of(0.5));
    Some(match name {
        "none" => both!(NoStabilizer, NoStabilizer),
        "popc" => both!(Popc, popc),
        "lolc" => {
            let damper = Dissipation::of(of(0.3)).expect("a damping");
            both!(Lolc, Lolc::new((PortEnergy, damper), limit()))
        }
        "popc-bounded" => both!(Bounded, popc.bounded(of(1e-3)).expect("a bound")),
        "popc-windowed" => {
            type Sum<T> = WindowedCredit<T, Plain<T>, 8>;
            let sum = Sum::of_ticks(5).expect("a window");
            let windowed: Popc<V::Scalar, Held, Sum<V::Scalar>> = popc.summed_by(sum);
            both!(Windowed, windowed)
        }
        "popc-threshold" => both!(Threshold, popc.above_velocity(of(0.01)).expect("a speed")),
        "popc-spread" => both!(Spread, popc.spread_over(5).expect("ticks")),
        "popc-rate-limited" => {
            both!(RateLimited, popc.rate_limited::<V>(of(100.0)).expect("a rate"))
        }
        "popc-rising" => both!(Rising, popc.rising_over(5).expect("ticks")),
        "popc-weighted" => {
            let weights = AxisWeights::new(axes).expect("weights");
            both!(Weighted, DirectedDamping::new(popc, weights, limit()))
        }
        "popc-directed" => {
            let along = AlongDirection::new(axes).expect("a direction");
            both!(Directed, DirectedDamping::new(popc, along, limit()))
        }
        "force-bound" => both!(ForceBound, ForceBound::new(of(0.1)).expect("a damping")),
        "tank" => {
            let [start, floor, ceiling, power] = [2e-3, 1e-3, 5e-3, 3.0].map(of);
            let store = TankLimits { start, floor, ceiling, power };
            both!(Tank, Tank::new(PortEnergy, store).expect("a tank"))
        }
        "energy-bounding" => {
            both!(EnergyBounding, EnergyBounding::new(of(500.0), of(250.0)).expect("constants"))
        }
        "force-bounding" => {
            both!(ForceBounding, ForceBounding::of_damping(of(0.1)).expect("a damping"))
        }
        "least-norm" => {
            both!(LeastNorm, LeastNorm::new(PortEnergy, limit(), of(0.3)).expect("a decay"))
        }
        "slope-bound" => both!(SlopeBound, SlopeBound::new(of(1e3)).expect("a slope")),
        _ => return None,
    })
}

fn are_what_they_hold<V: Signal>() {
    for &name in Member::<V>::NAMES {
        let (mut member, mut boxed) = named::<V>(name).expect(name);
        assert_eq!(member.name(), name);
        let mut gentle = named::<V>(name).expect(name).0.spread_over(1).expect("ticks");
        for (sample, effort) in Samples::<V>::new(V::Scalar::of(PERIOD)) {
            let told: Correction<V> = member.stabilize(&sample, effort);
            assert_eq!(told, boxed.stabilize(&sample, effort), "{name}");
            if told.alpha == V::Scalar::of(0.0) {
                assert_eq!(told.effort, gentle.stabilize(&sample, effort).effort, "{name}");
            } else {
                gentle.stabilize(&sample, effort);
            }
        }
    }
}

#[test]
fn each_is_what_it_holds() {
    are_what_they_hold::<f64>();
    are_what_they_hold::<f32>();
    are_what_they_hold::<WideF64x4>();
    are_what_they_hold::<Vector6<f32>>();
    are_what_they_hold::<Vector3<AutoF64x4>>();
}

/// Every member, at every tick, from a stored memory; and the memory of another member is refused.
fn resume<V: Signal + Serialize + DeserializeOwned>()
where
    V::Scalar: Serialize + DeserializeOwned,
{
    let samples = Samples::<V>::new(V::Scalar::of(PERIOD));
    for &name in Member::<V>::NAMES {
        let (mut member, _) = named::<V>(name).expect(name);
        laws::snapshot(&member, samples).expect(name);
        for (sample, effort) in samples.take(300) {
            member.stabilize(&sample, effort);
        }
        let mut bytes = Vec::new();
        ciborium::into_writer(&member.state(), &mut bytes).expect("it is written");
        let state: MemberState<V, _> = ciborium::from_reader(&bytes[..]).expect("it is read");
        assert_eq!(state, member.state(), "{name}");
        for &other in Member::<V>::NAMES {
            let (fresh, _) = named::<V>(other).expect(other);
            let restored = fresh.restored(state);
            assert_eq!(restored.is_ok(), name == other, "{name} in {other}");
            if let Err(error) = restored {
                assert_eq!(error.parameter, "place of the stored member");
            }
        }
    }
}

#[test]
fn a_stored_member_goes_on_as_itself_only() {
    resume::<f64>();
    resume::<f32>();
    resume::<Vector3<f64>>();
}

/// The names that commands know are the same; the others belong to a type that docs/stabilizers.md has.
#[test]
fn the_names_are_those_of_the_pages() {
    let by_name = include_str!("../docs/family.md");
    for name in Member::<f64>::NAMES {
        assert!(by_name.contains(&format!("`{name}`")), "docs/family.md lacks {name}");
    }
}

#[test]
fn a_member_keeps_the_laws_of_what_it_holds() {
    let samples = Samples::<Vector3<f64>>::new(PERIOD);
    for name in ["popc", "lolc", "popc-spread", "popc-directed", "least-norm"] {
        laws::stabilizer(&named::<Vector3<f64>>(name).expect(name).0, samples).expect(name);
    }
    for name in ["force-bound", "force-bounding", "tank", "slope-bound"] {
        laws::limiter(&named::<Vector3<f64>>(name).expect(name).0, samples).expect(name);
    }
}

/// Swing of a hand on a wall with this stabilizer in front.
fn swing(stabilizer: impl Stabilizer<f64>) -> f64 {
    let hand = Impedance { mass: 0.2, damping: 0.2, stiffness: 50.0 };
    let mut plant: Box<dyn Plant<f64>> =
        Box::new(Body::new(hand, PERIOD).expect("a body").starting(-0.004, 0.0));
    let wall: Box<dyn OnePort<f64>> = Box::new(Wall::new(20_000.0, 0.0).expect("a wall"));
    let mut port = wall.stabilized(stabilizer);
    let (mut sample, mut most): (_, f64) = (plant.start(), 0.0);
    for _ in 0..3000 {
        let effort = port.respond(&sample);
        plant.advance_into(effort, &mut sample);
        assert_eq!(OnePort::<f64>::correction(&port).effort, effort);
        most = most.max(sample.position.abs());
    }
    most
}

#[test]
fn a_box_goes_on_a_port_and_a_port_in_a_box() {
    for name in Member::<f64>::NAMES {
        let (member, boxed) = named::<f64>(name).expect(name);
        assert_eq!(swing(member).to_bits(), swing(boxed).to_bits(), "{name}");
    }
    let alone = swing(named::<f64>("none").expect("one").0);
    let watched = swing(named::<f64>("popc").expect("one").1);
    // From 4 mm: alone it grows, watched it does not.
    assert!(alone > 0.02 && watched < 0.0041, "{alone} m alone, {watched} m watched");
}

/// A candidate of the caller's own in the enumeration.
#[test]
fn a_candidate_of_ones_own_is_chosen_too() {
    let credit = Dissipation::of(5.0).expect("a damping");
    let own: Member<f64, Dissipation<f64>> = Member::Lolc(Lolc::new(credit, limit()));
    let tick = HeldTick {
        period: PERIOD,
        position: 0.0,
        velocity: 0.1,
        displacement: 1e-4,
        applied: -2.0,
    };
    let sample = tick.sample();
    assert_eq!({ own }.stabilize(&sample, 0.0).observed_energy, 5.0 * (0.1 * 0.1 * PERIOD));
}
