//! The list of members has every one of the family, and each lane of it is the scalar run.

use std::collections::BTreeMap;

use lyapunov_core::lanes::{AutoF32x4, AutoF32x8, AutoF64x4, WideF32x8, WideF64x4};
use lyapunov_core::{PortSample, Signal, Stabilizer};
use lyapunov_embedded::{BLOCK, Hash, Number, SEEDS, Ticks, Visit, hash, step, visit};
use lyapunov_stabilizers::Member;

/// Ticks from each seed: all of a block in release, as `run.sh` builds it; without optimization they take a minute and a half.
const EACH: usize = if cfg!(debug_assertions) { 100 } else { BLOCK };

/// One lane of a run: the numbers of its samples and efforts, one after the other, and the hash of what was answered.
struct Lane {
    told: Vec<f64>,
    hash: Hash,
}

/// The lanes of every member by name.
struct Lanes(BTreeMap<&'static str, Vec<Lane>>);

impl<T: Number> Visit<T> for Lanes {
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        let run = |lane| {
            let (mut member, mut hash, mut told) = (member, Hash::EMPTY, Vec::new());
            for (sample, effort) in SEEDS.flat_map(|seed| Ticks::<V>::new(seed).take(EACH)) {
                let PortSample { period, position, velocity, displacement, applied, work } = sample;
                told.push(period.lane(lane));
                for signal in [position, velocity, displacement, applied, work, effort] {
                    signal.map(|axis| {
                        told.push(axis.lane(lane));
                        axis
                    });
                }
                hash.correction(&step(&mut member, &sample, effort), lane);
            }
            Lane { told, hash }
        };
        let before = self.0.insert(name, (0..T::LANES).map(run).collect());
        assert!(before.is_none(), "two members are called {name}");
    }
}

/// Runs of each lane by itself, in the scalar.
struct Alone<'a>(&'a Lanes);

impl<T: Number> Visit<T> for Alone<'_> {
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        for (index, lane) in self.0.0[name].iter().enumerate() {
            let (mut member, mut hash) = (member, Hash::EMPTY);
            let mut told = lane.told.iter();
            while let Some(period) = told.next() {
                let mut signal = || V::zero().map(|_| T::of(*told.next().expect("an axis")));
                let sample = PortSample {
                    period: T::of(*period),
                    position: signal(),
                    velocity: signal(),
                    displacement: signal(),
                    applied: signal(),
                    work: signal(),
                };
                let effort = signal();
                hash.correction(&step(&mut member, &sample, effort), 0);
            }
            assert_eq!(hash, lane.hash, "lane {index} of {name}");
        }
    }
}

fn lanes<T: Number>() -> Lanes {
    let mut lanes = Lanes(BTreeMap::new());
    visit::<T>(&mut lanes).expect("the parameters");
    lanes
}

#[test]
fn every_name_is_in_the_list() {
    let listed = lanes::<f32>().0;
    let page = include_str!("../../../docs/family.md");
    let table = page.split("## The names").nth(1).and_then(|it| it.split("\n## ").next());
    let rows = table.expect("the table of names").lines().filter_map(|row| row.strip_prefix("| `"));
    let named: Vec<&str> = rows.filter_map(|row| row.split('`').next()).collect();
    assert!(named.len() > 20, "the table of docs/family.md is read wrongly: {named:?}");
    // The others are the same controller with a candidate of the lab.
    let own = |name: &&str| !["lolc-device-damping", "lolc-mass-spring-damper"].contains(name);
    // In the enumeration it goes by another name than in scenes.
    let alike =
        |name: &str| if name == "popc-directed" { "directed-damping" } else { name }.to_owned();
    for name in named.into_iter().filter(own).chain(Member::<f32>::NAMES.iter().copied()) {
        assert!(listed.contains_key(&*alike(name)), "tests/embedded/src/members lacks {name}");
    }
}

/// Hashes of every member over all ticks, by name.
struct Hashes(BTreeMap<&'static str, Hash>);

impl<T: Number> Visit<T> for Hashes {
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        self.0.insert(name, hash(member, BLOCK, 0, step));
    }
}

/// Ticks that two members answer alike do not tell one from the other.
#[test]
fn every_member_is_told_from_the_others() {
    let mut hashes = Hashes(BTreeMap::new());
    visit::<f64>(&mut hashes).expect("the parameters");
    let mut told: Vec<(&str, Hash)> = Vec::new();
    for (name, hash) in hashes.0 {
        if let Some((other, _)) = told.iter().find(|(_, other)| *other == hash) {
            // The same stabilizer as a type of its own and as a case of the enumeration.
            assert_eq!(format!("{other}-member"), name, "{other} and {name} answer alike");
        }
        told.push((name, hash));
    }
}

/// Types that the crate of the stabilizers exports, and that are no step: traits, parameters, states, parts of a type.
const NO_STEP: [&str; 17] = [
    "Account",
    "LimitCredit",
    "Metric",
    "DeviceDamping",
    "EveryAxis",
    "FreshContact",
    "KeptCredit",
    "Inertia",
    "Input",
    "MemberState",
    "StabilizerExt",
    "TankLimits",
    "Valve",
    "Following",
    "BodyInertia",
    "PublishedBand",
    "TightBand",
];

#[test]
fn every_exported_type_is_in_the_list() {
    let exports = include_str!("../../../stabilizers/src/lib.rs");
    let list = [
        include_str!("../src/members/bounding.rs"),
        include_str!("../src/members/channel.rs"),
        include_str!("../src/members/damping.rs"),
        include_str!("../src/members/several_axes.rs"),
        include_str!("../src/port.rs"),
    ]
    .concat();
    let word = |it: char| !it.is_alphanumeric();
    let types: Vec<&str> = exports
        .split(';')
        .filter_map(|item| item.split_once("pub use ").map(|it| it.1))
        .flat_map(|item| item.split(word))
        .filter(|name| name.starts_with(char::is_uppercase))
        .collect();
    assert!(types.len() > 40, "the exports are read wrongly: {types:?}");
    for name in types.into_iter().filter(|name| !NO_STEP.contains(name)) {
        assert!(list.split(word).any(|it| it == name), "tests/embedded/src/members lacks {name}");
    }
}

fn are_their_scalar_runs<L: Number, T: Number>() {
    visit::<T>(&mut Alone(&lanes::<L>())).expect("the parameters");
}

#[test]
fn lanes_are_their_scalar_runs() {
    are_their_scalar_runs::<AutoF32x4, f32>();
    are_their_scalar_runs::<AutoF32x8, f32>();
    are_their_scalar_runs::<WideF32x8, f32>();
    are_their_scalar_runs::<AutoF64x4, f64>();
    are_their_scalar_runs::<WideF64x4, f64>();
}
