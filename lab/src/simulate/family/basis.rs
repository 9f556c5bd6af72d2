//! Quantities of a loop that set the family's parameters.

use std::f64::consts::TAU;

use lyapunov::environments::Time;

use super::{Reference, Settings};
use crate::files::scene::{Damping, Scene};
use crate::simulate::criterion::Criterion;
use crate::simulate::equilibrium::last_pull;

/// Slots of a credit window.
pub(super) const SLOTS: usize = 8;

/// A loop's quantities that set the family's parameters.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Basis {
    /// The quantities that make the damping limit.
    pub(crate) limit: Damping,
    /// The device's damping, N·s/m.
    pub(crate) damping: f64,
    /// The energy that the motion starts with, J: the scale of all energies.
    pub(crate) energy: f64,
    /// The speed at which the mass has that energy, m/s.
    pub(crate) speed: f64,
    /// The duration of a swing of the hand, s.
    pub(crate) swing: f64,
    /// One count of the encoder, m.
    pub(crate) count: Option<f64>,
    /// Ticks by which a force acts late.
    pub(crate) delay: u32,
    /// Servo ticks per tick of the environment.
    pub(crate) ratio: u32,
    /// The position where contact begins, m.
    pub(crate) surface: Option<f64>,
    /// The energy that the environment stores; none where it is no function of position and velocity.
    pub(crate) reference: Option<Reference>,
    /// The damper of the ideal wall, N·s/m, and where it begins, m; none without a wall.
    pub(crate) damper: Option<[f64; 2]>,
    /// Position and velocity at the start, m and m/s.
    pub(crate) start: [f64; 2],
}

impl Basis {
    pub(crate) fn of(scene: &Scene) -> Self {
        let start = [scene.initial.position.get(), scene.initial.velocity.get()];
        let moving = scene.operator.mass.get() + scene.device.mass.get();
        let wall = scene.environment.wall();
        let (pull, reach) = (last_pull(scene), Criterion::of(scene).start);
        let thrown = 0.5 * moving * start[1] * start[1];
        let energy = if pull > 0.0 { 0.5 * pull * reach * reach } else { thrown };
        Self {
            limit: scene.damping(Settings::of(scene).damping_cap.get()),
            damping: scene.device.damping.get(),
            energy,
            speed: (2.0 * energy / moving).sqrt(),
            swing: if pull > 0.0 { TAU * (moving / pull).sqrt() } else { 1.0 },
            count: scene.effects.encoder.map(|encoder| encoder.resolution.get()),
            delay: scene.effects.delay.map_or(0, |delay| delay.ticks.get().into()),
            ratio: u32::try_from(scene.environment_ratio()).unwrap_or(u32::MAX),
            surface: surface(scene),
            reference: Reference::of(scene),
            damper: wall.map(|wall| [wall.damping.get(), wall.position.get()]),
            start,
        }
    }

    /// The basis of a hand of `mass` kg that moves at `speed` m/s, without a scene; `period` in s.
    pub(crate) fn of_hand(mass: f64, period: f64, speed: f64) -> Self {
        Self {
            limit: Damping { cap: 0.5, port_mass: mass, period },
            damping: 0.0,
            energy: 0.5 * mass * speed * speed,
            speed,
            swing: 100.0 * period,
            count: None,
            delay: 0,
            ratio: 1,
            surface: None,
            reference: None,
            damper: None,
            start: [0.0; 2],
        }
    }

    /// The energy that the environment stores at the start, J; not below 0.
    pub(crate) fn stored(&self) -> f64 {
        let [x, v] = self.start;
        self.reference.as_ref().map_or(0.0, |it| it.stored(x, v)).max(0.0)
    }

    /// The speed above which a velocity is more than noise, m/s.
    pub(super) fn threshold(&self) -> f64 {
        self.count.map_or(0.01 * self.speed, |count| count / self.limit.period)
    }

    /// The number of ticks over which a correction is spread, or rises.
    pub(super) fn ticks(&self) -> u32 {
        self.ratio.max(2)
    }

    /// The fastest that a correction may grow, N/s: to the largest correction at the hand's speed within those ticks;
    /// no limit where the speed is unknown.
    pub(super) fn rate(&self) -> f64 {
        let Damping { cap, port_mass, period } = self.limit;
        let most = cap * port_mass / period * self.speed;
        let rate = most / (f64::from(self.ticks()) * period);
        if rate > 0.0 { rate } else { f64::INFINITY }
    }

    /// Ticks per slot of the window; the window is as long as a swing of the hand.
    pub(super) fn slot(&self) -> u32 {
        // The conversion saturates: no run leaves a longer slot either.
        (self.swing / (SLOTS as f64 * self.limit.period)).ceil().max(1.0) as u32
    }
}

fn surface(scene: &Scene) -> Option<f64> {
    scene.law()?.surface(Time::Seconds(0.0)).map(|surface| surface.position)
}
