//! Reading of the quantities that set a stabilizer's numbers from a scene.

use std::f64::consts::TAU;

use lyapunov::environments::Time;

use super::criterion::Criterion;
use super::equilibrium::last_pull;
use crate::files::scene::{Basis, Damping, Direction, Draft, Reference, Scene};

impl Basis {
    pub(crate) fn of(scene: &Scene) -> Self {
        let start = [scene.initial.position.get(), scene.initial.velocity.get()];
        let moving = scene.operator.mass.get() + scene.device.mass.get();
        let kind = scene.environment.kind();
        let (pull, reach) = (last_pull(scene), reach(scene));
        let thrown = 0.5 * moving * speed(scene) * speed(scene);
        let energy = if pull > 0.0 { 0.5 * pull * reach * reach } else { thrown };
        let pace = scene.environment_rate().recip();
        let steepest = kind.steepest();
        Self {
            limit: scene.damping(scene.default_cap()),
            damping: scene.device.damping.get(),
            energy,
            speed: (2.0 * energy / moving).sqrt(),
            swing: if pull > 0.0 { TAU * (moving / pull).sqrt() } else { 1.0 },
            count: scene.effects.encoder.map(|encoder| encoder.resolution.get()),
            delay: scene.delay_ticks(),
            ratio: u32::try_from(scene.environment_ratio()).unwrap_or(u32::MAX),
            surface: surface(scene),
            steepest: steepest.map(|it| {
                it.stiffness.abs() + 2.0 * it.damping.abs() / pace + 4.0 * it.mass / (pace * pace)
            }),
            drag: steepest.or(kind.impedance()).map_or(0.0, |it| {
                0.5 * it.stiffness.abs() * pace + it.damping.abs() + 2.0 * it.mass / pace
            }),
            reference: Reference::of(scene),
            damper: scene.environment.wall().map(|it| [it.damping.get(), it.position.get()]),
            normal: kind.normal().map_or(Direction::FIRST, Direction::from),
            start,
            scene: Some(Box::new(scene.clone())),
        }
    }

    /// The basis of a hand of `mass` kg that moves at `speed` m/s, without a scene; `period` in s.
    pub(crate) fn of_hand(mass: f64, period: f64, speed: f64) -> Self {
        Self {
            limit: Damping { cap: Damping::default_cap(0), port_mass: mass, period },
            damping: 0.0,
            energy: 0.5 * mass * speed * speed,
            speed,
            swing: 100.0 * period,
            count: None,
            delay: 0,
            ratio: 1,
            surface: None,
            steepest: None,
            drag: 0.0,
            reference: None,
            damper: None,
            normal: Direction::FIRST,
            start: [0.0; 2],
            scene: None,
        }
    }
}

/// The speed at the start, m/s.
fn speed(scene: &Draft) -> f64 {
    let axis = |axis| scene.initial.velocity.axis(axis);
    axis(0).hypot(axis(1)).hypot(axis(2))
}

/// The swing that a run is measured against, m; in several dimensions the swing about the hand's rest.
fn reach(scene: &Draft) -> f64 {
    if scene.dimensions() == 1 {
        return Criterion::of(scene).start;
    }
    let away = |axis| scene.initial.position.axis(axis) - scene.operator.rest.axis(axis);
    let moving = scene.operator.mass.get() + scene.device.mass.get();
    let frequency = (last_pull(scene) / moving).sqrt();
    away(0).hypot(away(1)).hypot(away(2)).hypot(speed(scene) / frequency)
}

fn surface(scene: &Scene) -> Option<f64> {
    scene.law()?.surface(Time::Seconds(0.0)).map(|surface| surface.position)
}
