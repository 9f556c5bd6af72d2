//! Equilibrium of a scene.

use lyapunov::environments::{Kinematics, NearestPoint, Solid};
use nalgebra::SVector;

use super::building::Space;
use super::place::Place;
use crate::files::scene::{Draft, Face, Motion, StaticSpring};

/// Halvings of an interval: more than f64 has digits.
const HALVINGS: usize = 200;

/// Share of a force that may lie beside the direction of its side, and of a depth by which a direction is tried.
const BALANCED: f64 = 1e-9;

/// Places where the operator's spring, the environment and the forces that push at the end balance: on a line and before a
/// solid with one surface one, before a box one for each face that holds the hand. None where no spring pulls and where
/// something never rests; in a space neither in the middle of a ball, nor where a saturation turns the force of a side.
pub(crate) fn equilibria(scene: &Draft) -> Vec<Place> {
    match scene.dimensions() {
        1 => on_a_line(scene).map(Place::on_a_line).into_iter().collect(),
        2 => in_space::<2>(scene).into_iter().flatten().map(Place::at).collect(),
        _ => in_space::<3>(scene).into_iter().flatten().map(Place::at).collect(),
    }
}

fn on_a_line(scene: &Draft) -> Option<f64> {
    let (pull, rest) = (last_pull(scene), last_rest(scene)?);
    if pull <= 0.0 {
        return None;
    }
    let free = rest + last_push(scene) / pull;
    let balanced = balance(scene, pull, free)?;
    let most = scene.effects.saturation.map_or(f64::INFINITY, |limit| limit.force.get());
    let pushed = pull * (free - balanced);
    Some(if pushed.abs() > most { free - most.copysign(pushed) / pull } else { balanced })
}

/// Whether something drives the scene for as long as it lasts.
pub(crate) fn never_rests(scene: &Draft) -> bool {
    last_rest(scene).is_none() || scene.environment.kind().frequency().is_some()
}

/// The places where a solid and the hand hold each other. A hand that pulls to `free` rests on a side
/// of the solid with the normal `n`, below which `free` lies `d` deep, at `free + n d K / (k + K)`, if that side is the
/// nearest there too.
fn in_space<const N: usize>(scene: &Draft) -> Option<Vec<SVector<f64, N>>>
where
    SVector<f64, N>: Space<Scalar = f64>,
{
    let (pull, rest) = (last_pull(scene), last_rest(scene)?);
    if pull <= 0.0 {
        return None;
    }
    let mut free = scene.operator.rest.vector::<f64, N>();
    free[0] = rest + last_push(scene) / pull;
    let (solid, push) = (SVector::solid(scene)?, scene.environment.surface_stiffness()?);
    let most = scene.effects.saturation.map_or(f64::INFINITY, |limit| limit.force.get());
    let clipped = |force: SVector<f64, N>| force.map(|axis| axis.clamp(-most, most));
    let mut places = Vec::new();
    if solid.nearest(free).depth.max(0.0) * push == 0.0 {
        places.push(free);
    }
    for NearestPoint { depth, normal } in sides(scene, &*solid, free)? {
        let held = clipped(normal * (depth * push / (pull + push) * pull));
        let place = free + held / pull;
        // A force that is cut on one axis is that of no side.
        let is_along = (held - normal * held.dot(&normal)).norm() <= BALANCED * held.norm();
        if depth > 0.0 && is_along && solid.nearest(place).normal.dot(&normal) > 0.5 {
            places.push(place);
        }
    }
    Some(places)
}

/// The sides of a `solid` seen from `free`; none in the middle of a ball, where no direction leads out.
fn sides<const N: usize>(
    scene: &Draft,
    solid: &dyn Solid<SVector<f64, N>>,
    free: SVector<f64, N>,
) -> Option<Vec<NearestPoint<SVector<f64, N>>>> {
    let faces = scene.environment.kind().faces();
    if faces.is_empty() {
        let nearest = solid.nearest(free);
        let beside = free - nearest.normal * (BALANCED * nearest.depth);
        let is_known = solid.nearest(beside).normal.dot(&nearest.normal) > 0.0;
        return is_known.then(|| vec![nearest]);
    }
    let side = |face: Face| {
        let mut normal = SVector::zeros();
        normal[face.axis] = face.outward;
        NearestPoint { depth: face.outward * (face.position - free[face.axis]), normal }
    };
    Some(faces.into_iter().map(side).collect())
}

/// Position where a spring of `pull` N/m that would rest at `free` balances the environment.
fn balance(scene: &Draft, pull: f64, free: f64) -> Option<f64> {
    let kind = scene.environment.kind();
    if kind.frequency().is_some() {
        return None;
    }
    let surface = scene.surface();
    if surface.is_some_and(|surface| free <= surface) {
        return Some(free);
    }
    if let Some(StaticSpring { stiffness: push, position }) = kind.static_spring() {
        return match surface {
            Some(surface) => Some(surface + (free - surface) * (pull / (pull + push))),
            None => (pull + push > 0.0).then(|| (pull * free + push * position) / (pull + push)),
        };
    }
    let law = scene.law()?;
    let force = |x: f64| law.force(&Kinematics::at(x, 0.0));
    // A force that grows with the position is no larger than at `free` on the way there.
    let reach = (force(free).abs() / pull).min(f64::MAX / 4.0);
    let [mut low, mut high] = surface.map_or([free - reach, free + reach], |it| [it, free]);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if pull * (middle - free) + force(middle) > 0.0 { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}

/// Distance that the plant would swing about `rest` if nothing else acted.
pub(crate) fn swing(scene: &Draft, rest: &Place) -> f64 {
    let mass = scene.operator.mass.get() + scene.device.mass.get();
    let frequency = (last_pull(scene) / mass).sqrt();
    let away = rest.distance(|axis| scene.initial.position.axis(axis));
    let still = Place::origin(scene.dimensions());
    away.hypot(still.distance(|axis| scene.initial.velocity.axis(axis)) / frequency)
}

/// Frequency at which the operator's rest swings, Hz, if it does.
pub(crate) fn driven(scene: &Draft) -> Option<f64> {
    match &scene.operator.motion {
        Some(Motion::Sine { amplitude, frequency }) => {
            let swings = amplitude.get() != 0.0 && frequency.get() != 0.0;
            swings.then_some(frequency.get())
        }
        _ => None,
    }
}

/// Stiffness that pulls the device back at the end, N/m: the operator's spring, and a link in series.
pub(crate) fn last_pull(scene: &Draft) -> f64 {
    let operator = &scene.operator;
    let changes = operator.grip.iter().flat_map(|grip| grip.times.iter().zip(&grip.stiffness));
    let mut gone = changes.filter(|(time, _)| scene.tick_of(time.get()) <= scene.ticks());
    pull_of(scene, gone.next_back().map_or(operator.stiffness, |(_, stiffness)| *stiffness).get())
}

/// Stiffness that pulls the device back while the operator's spring has that of `hand`, N/m.
pub(super) fn pull_of(scene: &Draft, hand: f64) -> f64 {
    match scene.link {
        Some(link) if hand > 0.0 => (hand.recip() + link.stiffness.get().recip()).recip(),
        _ => hand,
    }
}

/// Force in +x that pushes the device at the end, N.
fn last_push(scene: &Draft) -> f64 {
    let load = scene.effects.load.map_or(0.0, |load| load.force.get());
    let pulse = scene.effects.pulse.filter(|pulse| {
        let (start, duration) = (pulse.start.get(), pulse.duration.get());
        (scene.tick_of(start)..scene.tick_of(start + duration)).contains(&scene.ticks())
    });
    load + pulse.map_or(0.0, |pulse| pulse.force.get())
}

/// Rest position of the operator's spring at the end, m; none if it still moves.
fn last_rest(scene: &Draft) -> Option<f64> {
    let rest = scene.operator.rest.get();
    let end = scene.end();
    match &scene.operator.motion {
        None => Some(rest),
        Some(Motion::Step { at, to }) => {
            Some(if scene.tick_of(at.get()) <= scene.ticks() { to.get() } else { rest })
        }
        Some(Motion::Ramp { at, to, rate }) => {
            let (way, speed, time) = (to.get() - rest, rate.get(), end - at.get());
            let moved = speed * time.max(0.0);
            if moved >= way.abs() { Some(to.get()) } else { (moved == 0.0).then_some(rest) }
        }
        Some(Motion::Sine { .. }) => driven(scene).is_none().then_some(rest),
        Some(Motion::File { samples, .. }) => {
            samples.last().filter(|(time, _)| *time <= end).map(|(_, rest)| *rest)
        }
    }
}
