//! Numbers of a scene that may differ from lane to lane.

use crate::files::scene::{Draft, Stabilizer, Wall};

/// Copier of one number from another scene.
pub(super) type Copier = fn(&mut Draft, &Draft);

/// The numbers by their keys. Those that set the ticks of a run (duration, rates) are the same in a group of lanes.
const FIELDS: &[(&str, Copier)] = &[
    ("operator.mass", |to, from| to.operator.mass = from.operator.mass),
    ("operator.damping", |to, from| to.operator.damping = from.operator.damping),
    ("operator.stiffness", |to, from| to.operator.stiffness = from.operator.stiffness),
    ("operator.rest", |to, from| to.operator.rest.clone_from(&from.operator.rest)),
    ("device.mass", |to, from| to.device.mass = from.device.mass),
    ("device.damping", |to, from| to.device.damping = from.device.damping),
    ("initial.position", |to, from| to.initial.position.clone_from(&from.initial.position)),
    ("initial.velocity", |to, from| to.initial.velocity.clone_from(&from.initial.velocity)),
    ("environment.wall.stiffness", |to, from| {
        wall(to, from, |to, from| to.stiffness = from.stiffness);
    }),
    ("environment.wall.damping", |to, from| {
        wall(to, from, |to, from| to.damping = from.damping);
    }),
    ("environment.wall.position", |to, from| {
        wall(to, from, |to, from| to.position = from.position);
    }),
    ("duration", |to, from| to.duration = from.duration),
    ("servo_rate", |to, from| to.servo_rate = from.servo_rate),
    ("environment_rate", |to, from| to.environment_rate = from.environment_rate),
    ("stabilizer.popc.damping_cap", CAP),
    ("stabilizer.lolc.damping_cap", CAP),
];

fn wall(to: &mut Draft, from: &Draft, copy: fn(&mut Wall, &Wall)) {
    if let (Some(to), Some(from)) = (to.environment.wall_mut(), from.environment.wall()) {
        copy(to, from);
    }
}

/// Copier of the one number of the stabilizers that the kernel has.
pub(super) const CAP: Copier = |to, from| match (&mut to.stabilizer, &from.stabilizer) {
    (Some(Stabilizer::Popc(to)), Some(Stabilizer::Popc(from))) => {
        to.damping_cap = from.damping_cap;
    }
    (Some(Stabilizer::Lolc(to)), Some(Stabilizer::Lolc(from))) => {
        to.damping_cap = from.damping_cap;
    }
    _ => {}
};

/// Copier of a number that the stabilizer at hand does not have.
pub(super) const NOTHING: Copier = |_, _| {};

/// Copier of the number `key`; none if lanes cannot differ in it.
pub(super) fn copier(key: &str) -> Option<Copier> {
    FIELDS.iter().find(|(known, _)| *known == key).map(|(_, copy)| *copy)
}
