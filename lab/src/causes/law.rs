//! The environment's law in continuous time.

use std::f64::consts::TAU;

use crate::scene::Environment;

/// Where the plant is and how it moves, at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Motion {
    /// s.
    pub(super) time: f64,
    /// m.
    pub(super) position: f64,
    /// m/s.
    pub(super) velocity: f64,
    /// m/s².
    pub(super) acceleration: f64,
}

/// The force of `environment` on this motion, N; 0 of one that is not on a line.
pub(super) fn force(environment: &Environment, at: Motion) -> f64 {
    let Motion { time, position, velocity, acceleration } = at;
    let pushing = |depth: f64, force: f64| if depth > 0.0 { force.max(0.0) } else { 0.0 };
    let turn = |frequency: f64| TAU * (frequency * time);
    match environment {
        Environment::Wall(it) => {
            let depth = position - it.position.get();
            pushing(depth, it.stiffness.get() * depth + it.damping.get() * velocity)
        }
        Environment::Spring(it) => it.stiffness.get() * (position - it.position.get()),
        Environment::MassSpringDamper(it) => {
            it.mass.get() * acceleration
                + it.damping.get() * velocity
                + it.stiffness.get() * (position - it.position.get())
        }
        Environment::LayeredWall(it) => {
            let (depth, layer) = (position - it.position.get(), it.depth.get());
            let [first, second] = it.stiffness.map(|stiffness| stiffness.get());
            let spring = first * depth.min(layer) + second * (depth - layer).max(0.0);
            pushing(depth, spring + it.damping.get() * velocity)
        }
        Environment::HuntCrossley(it) => {
            let depth = position - it.position.get();
            let spring = it.stiffness.get() * libm::pow(depth.max(0.0), it.exponent.get());
            pushing(depth, spring * (1.0 + it.damping.get() * velocity))
        }
        Environment::MovingWall(it) => {
            let (amplitude, phase) = (it.amplitude.get(), turn(it.frequency.get()));
            let surface = it.position.get() + amplitude * libm::sin(phase);
            let speed = TAU * it.frequency.get() * amplitude * libm::cos(phase);
            let depth = position - surface;
            pushing(depth, it.stiffness.get() * depth + it.damping.get() * (velocity - speed))
        }
        Environment::VaryingSpring(it) => {
            let swing = it.amplitude.get() * libm::sin(turn(it.frequency.get()));
            (it.stiffness.get() + swing) * (position - it.position.get())
        }
        Environment::Plane(_) | Environment::Sphere(_) | Environment::Cuboid(_) => 0.0,
    }
}

/// Parts of a tick, for a surface that is met within it.
const PARTS: u32 = 8;

/// Gauss's three points: exact where force and motion are those of a spring and a cubic.
const POINTS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

/// The work of the law over a tick, `∫ f v dt`, J, on the cubic that meets position and velocity at both ends.
pub(super) fn work(environment: &Environment, from: Motion, to: Motion) -> f64 {
    let span = to.time - from.time;
    let part = f64::from(PARTS).recip();
    let parts = (0..PARTS).flat_map(|index| {
        POINTS.map(|(place, weight)| (part * (f64::from(index) + place), part * weight))
    });
    parts
        .map(|(share, weight)| {
            let at = between(from, to, share);
            weight * span * force(environment, at) * at.velocity
        })
        .sum()
}

/// Hermite's cubic at a share of the way.
fn between(from: Motion, to: Motion, share: f64) -> Motion {
    let span = to.time - from.time;
    let (moved, s) = (to.position - from.position, share);
    let (start, end) = (from.velocity, to.velocity);
    let mean = moved / span;
    // x = x₀ + span (v₀ s + (3 mean − 2 v₀ − v₁) s² + (v₀ + v₁ − 2 mean) s³)
    let (second, third) = (3.0 * mean - 2.0 * start - end, start + end - 2.0 * mean);
    Motion {
        time: from.time + s * span,
        position: from.position + span * s * (start + s * (second + s * third)),
        velocity: start + s * (2.0 * second + 3.0 * third * s),
        acceleration: (2.0 * second + 6.0 * third * s) / span,
    }
}
