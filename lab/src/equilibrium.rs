//! Where a scene comes to rest.

use lyapunov::{Drive, OnePort};

use crate::Space;
use crate::building::AsPort;
use crate::scene::{Environment, Scene};

/// Halvings of an interval: more than the digits of f64.
const HALVINGS: usize = 200;

/// Where the operator's spring, the environment and the load balance, m; none where no spring pulls, where something
/// never rests, and in more than one dimension.
pub(crate) fn equilibrium(scene: &Scene) -> Option<f64> {
    let (pull, rest) = (last_pull(scene), scene.last_rest()?);
    let load = scene.effects.load.map_or(0.0, |load| load.force.get());
    if scene.dimensions() > 1 || pull <= 0.0 {
        return None;
    }
    let between = |push: f64, place: f64| (pull * rest + push * place + load) / (pull + push);
    match &scene.environment {
        Environment::Wall(wall) => {
            let (push, surface) = (wall.stiffness.get(), wall.position.get());
            let free = rest + load / pull;
            let pressed = surface + (free - surface) * (pull / (pull + push));
            Some(if free > surface { pressed } else { free })
        }
        Environment::Spring(it) if pull + it.stiffness.get() > 0.0 => {
            Some(between(it.stiffness.get(), it.position.get()))
        }
        Environment::MassSpringDamper(it) => Some(between(it.stiffness.get(), it.position.get())),
        Environment::LayeredWall(it) => one_sided(scene, it.position.get(), rest + load / pull),
        Environment::HuntCrossley(it) => one_sided(scene, it.position.get(), rest + load / pull),
        _ => None,
    }
}

/// How far the plant would swing about `rest` if nothing else acted.
pub(crate) fn swing(scene: &Scene, rest: f64) -> f64 {
    let mass = scene.operator.mass.get() + scene.device.mass.get();
    let frequency = (last_pull(scene) / mass).sqrt();
    let away = scene.initial.position.get() - rest;
    away.hypot(scene.initial.velocity.get() / frequency)
}

/// The stiffness that the operator's spring ends with, N/m.
fn last_pull(scene: &Scene) -> f64 {
    let last = scene.operator.grip.as_ref().and_then(|grip| grip.stiffness.last());
    last.unwrap_or(&scene.operator.stiffness).get()
}

/// Between the surface and where the spring would rest without the wall, where a wall that only pushes balances it.
fn one_sided(scene: &Scene, surface: f64, free: f64) -> Option<f64> {
    if free <= surface {
        return Some(free);
    }
    let pull = last_pull(scene);
    let excess = |x: f64| {
        let mut wall = f64::render(scene, AsPort).ok()?;
        Some(pull * (x - free) + wall.respond(&Drive::starting(1.0, x, 0.0)))
    };
    let (mut low, mut high) = (surface, free);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if excess(middle)? > 0.0 { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}
