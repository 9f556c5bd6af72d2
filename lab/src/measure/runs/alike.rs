//! Scenes that differ in numbers only, and can share lanes.

use std::mem::discriminant;

use crate::files::scene::{Basis, Filter, Integrator, Scalar, Scene, Stabilizer};

/// Whether loops of `scene` under `table` run on lanes.
///
/// An adaptive integrator chooses its steps by the motion, which no two lanes share, and nobody knows how an own
/// stabilizer takes its numbers from a scene.
pub(crate) fn has_lanes(scene: &Scene, table: &Option<Stabilizer>) -> bool {
    let adaptive =
        matches!(scene.integrator, Integrator::Dopri5 { .. } | Integrator::Dop853 { .. });
    let is_own = matches!(table, Some(Stabilizer::Own(_)));
    scene.scalar == Scalar::F64 && scene.dimensions() == 1 && !adaptive && !is_own
}

/// The places of scenes, each under its table on the loop it was told of, in groups of at most `lanes` that are alike in
/// all but numbers.
pub(crate) fn groups(
    scenes: &[Scene],
    told: &[Scene],
    tables: &[Option<Stabilizer>],
    lanes: usize,
) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let shapes: Vec<u32> = told.iter().zip(tables).map(|(it, table)| shape(it, table)).collect();
    for place in 0..scenes.len() {
        let fits = |group: &Vec<usize>| {
            let first = group[0];
            group.len() < lanes
                && shapes[first] == shapes[place]
                && are_alike(&scenes[first], &scenes[place])
                && tables_are_alike(tables[first].as_ref(), tables[place].as_ref())
        };
        // From the last one on: neighbours are alike.
        match groups.iter_mut().rev().find(|group| fits(group)) {
            Some(group) => group.push(place),
            None => groups.push(vec![place]),
        }
    }
    groups
}

/// The setting of a stabilizer on its loop that is the same in all lanes; 0 of POPC and LOLC, which have none.
fn shape(scene: &Scene, table: &Option<Stabilizer>) -> u32 {
    match table {
        None | Some(Stabilizer::Popc(_) | Stabilizer::Lolc(_)) => 0,
        Some(table) => table.kind().shape(&Basis::of(scene)),
    }
}

fn are_alike(one: &Scene, other: &Scene) -> bool {
    let clock = |it: &Scene| (it.servo_rate, it.environment_ratio(), it.ticks(), it.scalar);
    let kind = |it: &Scene| {
        let mass = it.environment.kind().impedance().map(|it| it.mass == 0.0);
        // Runs in lanes are judged over the same cycle.
        let cycle = it.environment.kind().frequency().map(f64::to_bits);
        (discriminant(&it.environment), mass, cycle, it.link.is_some(), it.velocity, it.integrator)
    };
    clock(one) == clock(other)
        && kind(one) == kind(other)
        && moves_alike(one, other)
        && effects(one) == effects(other)
}

/// Whether what moves a hand is alike: trajectories are the same in all lanes.
fn moves_alike(one: &Scene, other: &Scene) -> bool {
    let (hand, another) = (&one.operator, &other.operator);
    let times = |scene: &'_ Scene| scene.operator.grip.as_ref().map(|grip| grip.times.clone());
    hand.motion == another.motion
        && (hand.motion.is_none() || hand.rest == another.rest)
        && times(one) == times(other)
        && one.effects.load == other.effects.load
        && one.effects.pulse == other.effects.pulse
}

/// The effects of a scene without those numbers in which lanes may differ.
fn effects(scene: &Scene) -> impl PartialEq {
    let it = &scene.effects;
    let window = it.filter.map(|filter| match filter {
        Filter::Cutoff(_) => None,
        Filter::Window(ticks) => Some(ticks),
    });
    let policy = it.dropout.map(|dropout| dropout.policy);
    let there = [
        it.encoder.is_some(),
        it.saturation.is_some(),
        it.noise.is_some(),
        it.jitter.is_some(),
        it.friction.is_some(),
    ];
    (it.delay, window, policy, there)
}

fn tables_are_alike(one: Option<&Stabilizer>, other: Option<&Stabilizer>) -> bool {
    match (one, other) {
        (Some(Stabilizer::Popc(one)), Some(Stabilizer::Popc(other))) => {
            (one.work, one.ledger) == (other.work, other.ledger)
        }
        (Some(Stabilizer::Lolc(one)), Some(Stabilizer::Lolc(other))) => {
            (one.work, one.ledger, one.candidate) == (other.work, other.ledger, other.candidate)
        }
        (Some(one), Some(other)) => discriminant(one) == discriminant(other),
        (one, other) => one.is_none() && other.is_none(),
    }
}
