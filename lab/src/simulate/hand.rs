//! Course of the operator's hand over a run.

use super::equilibrium::{driven, pull_of};
use crate::files::scene::{Draft, Motion};

/// Whether neither the hand's rest nor its grip changes within the run.
pub(super) fn holds_still(scene: &Draft) -> bool {
    let is_within = |instant: f64| scene.tick_of(instant) <= scene.ticks();
    let moves = match &scene.operator.motion {
        None => false,
        Some(Motion::Step { at, .. }) => is_within(at.get()),
        Some(Motion::Ramp { at, rate, .. }) => rate.get() > 0.0 && at.get() < scene.end(),
        Some(Motion::Sine { .. }) => driven(scene).is_some(),
        Some(Motion::File { .. }) => true,
    };
    let mut grips = scene.operator.grip.iter().flat_map(|grip| &grip.times);
    !moves && !grips.any(|time| is_within(time.get()))
}

/// The largest stiffness that pulls the device back within the run, N/m: the operator's spring, and a link in series.
pub(super) fn strongest_pull(scene: &Draft) -> f64 {
    let operator = &scene.operator;
    let grips = operator.grip.iter().flat_map(|grip| grip.times.iter().zip(&grip.stiffness));
    let within = grips.filter(|(time, _)| scene.tick_of(time.get()) <= scene.ticks());
    let hand = within.fold(operator.stiffness.get(), |most, (_, grip)| most.max(grip.get()));
    pull_of(scene, hand)
}

/// The largest distance from the start to a place where the hand's spring rests within the run, m.
pub(super) fn farthest(scene: &Draft) -> f64 {
    let away = |axis| scene.initial.position.axis(axis) - scene.operator.rest.axis(axis);
    let (start, rest) = (scene.initial.position.axis(0), scene.operator.rest.get());
    // The hand moves along the first axis.
    let along = |place: f64| (start - place).abs();
    let first = along(rest);
    let farthest = match &scene.operator.motion {
        None => first,
        Some(Motion::Step { at, to }) => {
            if scene.tick_of(at.get()) <= scene.ticks() {
                first.max(along(to.get()))
            } else {
                first
            }
        }
        Some(Motion::Ramp { at, to, rate }) => {
            let moved = rate.get() * (scene.end() - at.get()).max(0.0);
            let way = to.get() - rest;
            first.max(along(rest + way.abs().min(moved).copysign(way)))
        }
        Some(Motion::Sine { amplitude, .. }) => {
            if driven(scene).is_some() {
                first + amplitude.get().abs()
            } else {
                first
            }
        }
        Some(Motion::File { samples, .. }) => {
            // Before the first sample and after the last the hand stays there.
            let within = samples.iter().enumerate();
            let within = within.filter(|(index, (time, _))| *index == 0 || *time <= scene.end());
            within.fold(0.0, |most, (_, (_, place))| f64::max(most, along(*place)))
        }
    };
    farthest.hypot(away(1)).hypot(away(2))
}
