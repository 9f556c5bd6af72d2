//! Reading of the quantities that set a stabilizer's numbers from a scene.

use std::f64::consts::TAU;

use nalgebra::SVector;

use super::building::Space;
use super::criterion::Criterion;
use super::equilibrium::last_pull;
use super::hand::{farthest, holds_still, strongest_pull};
use crate::files::scene::{Basis, Damping, Direction, Draft, Reference, Scene};

impl Basis {
    pub(crate) fn of(scene: &Scene) -> Self {
        let start = [scene.initial.position.get(), scene.initial.velocity.get()];
        let moving = scene.operator.mass.get() + scene.device.mass.get();
        let kind = scene.environment.kind();
        let (pull, energy) = (last_pull(scene), energy(scene));
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
            surface: scene.surface(),
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
            pressed: match scene.dimensions() {
                2 => pressed::<2>(scene),
                3 => pressed::<3>(scene),
                _ => 0.0,
            },
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
            pressed: 0.0,
            scene: None,
        }
    }
}

/// The speed at the start, m/s.
fn speed(scene: &Draft) -> f64 {
    let axis = |axis| scene.initial.velocity.axis(axis);
    axis(0).hypot(axis(1)).hypot(axis(2))
}

/// The energy that the motion starts with, J; where the hand's rest or grip changes, or there is not one place to come to
/// rest at, that of the hand's spring at its stiffest, drawn from the start to the farthest rest, and of the speed.
fn energy(scene: &Draft) -> f64 {
    let moving = scene.operator.mass.get() + scene.device.mass.get();
    let (pull, speed) = (strongest_pull(scene), speed(scene));
    if pull == 0.0 {
        return 0.5 * moving * speed * speed;
    }
    let about_rest = || farthest(scene).hypot(speed / (pull / moving).sqrt());
    let settled = holds_still(scene).then(|| Criterion::of(scene));
    let settled = settled.filter(|it| it.equilibria.len() == 1).map(|it| it.start);
    let reach = settled.unwrap_or_else(about_rest);
    0.5 * pull * reach * reach
}

/// The energy of the solid that the start lies in, J; 0 outside.
fn pressed<const N: usize>(scene: &Draft) -> f64
where
    SVector<f64, N>: Space<Scalar = f64>,
{
    let stiffness = scene.environment.surface_stiffness().unwrap_or_default();
    let depth = SVector::<f64, N>::solid(scene).map_or(0.0, |solid| {
        solid.nearest(scene.initial.position.vector::<f64, N>()).depth.max(0.0)
    });
    0.5 * stiffness * depth * depth
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// The energy of 0.1 kg at −0.01 m on 1000 N/m that rests at −0.02 m, before a wall at 0.05 m; `more` adds keys.
    fn energy_of(hand: &str, more: &str) -> f64 {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice.mass = 0.1\ninitial.position = -0.01\n\
             operator = {{ stiffness = 1000.0, rest = -0.02{hand} }}\n{more}\n"
        );
        let wall = "environment.wall = { position = 0.05, stiffness = 1000.0 }";
        let text = if more.contains("environment") { text } else { format!("{text}{wall}\n") };
        let scene = Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        Basis::of(&scene).energy
    }

    #[test]
    fn a_hand_that_moves_starts_with_the_energy_of_its_spring_drawn_to_the_farthest_rest() {
        let wave = ", motion = { kind = \"sine\", amplitude = 0.03, frequency = 2.0 }";
        let ramp = ", motion = { kind = \"ramp\", at = 0.5, to = 1.0, rate = 0.04 }";
        let grip =
            ", grip = { times = [0.5, 0.6], stiffness = [2000.0, 0.0], damping = [0.0, 0.0] }";
        let swinging = "environment.moving-wall = { position = 0.05, stiffness = 1000.0, \
             amplitude = 0.01, frequency = 2.0 }";
        for (hand, more, stiffness, reach) in [
            ("", "", 1000.0, 0.01),
            (", motion = { kind = \"step\", at = 0.1, to = 0.0 }", "", 1000.0, 0.01),
            (", motion = { kind = \"step\", at = 0.1, to = 0.03 }", "", 1000.0, 0.04),
            (", motion = { kind = \"step\", at = 1.1, to = 0.03 }", "", 1000.0, 0.01),
            (wave, "", 1000.0, 0.04),
            // From −0.02 m on it comes as far as 0 in half a second.
            (ramp, "", 1000.0, 0.01),
            (grip, "", 2000.0, 0.01),
            ("", swinging, 1000.0, 0.01),
        ] {
            let wanted = 0.5 * stiffness * reach * reach;
            assert_relative_eq!(energy_of(hand, more), wanted, max_relative = 1e-12);
            // ½ · 0.1 kg · (2 m/s)² more.
            let thrown = energy_of(hand, &format!("{more}\ninitial.velocity = 2.0"));
            assert_relative_eq!(thrown, wanted + 0.2, max_relative = 1e-12);
        }
    }

    /// A hand that presses along any direction on a plane has the energy of one that presses on a wall on a line.
    #[test]
    fn a_hand_before_a_plane_starts_with_the_energy_that_it_has_before_a_wall() {
        let usual =
            "duration = 2.0\nservo_rate = 1000.0\ndevice.mass = 0.2\neffects.delay.ticks = 1\n";
        let hand = |rest: &str| {
            format!(
                "operator = {{ mass = 0.1, damping = 1.0, stiffness = 200.0, rest = {rest} }}\n"
            )
        };
        let energy = |text: &str| {
            let scene = Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}"));
            Basis::of(&scene).energy
        };
        for (at, velocity) in [(0.003, 0.0), (-0.02, 0.0), (-0.02, 0.3)] {
            let wall = energy(&format!(
                "{usual}{}initial = {{ position = {at}, velocity = {velocity} }}\n\
                 environment.wall = {{ position = 0.001, stiffness = 6000.0 }}\n",
                hand("0.012")
            ));
            // At (0.012 · 200 + 0.001 · 6000) N / 6200 N/m.
            let rest = 0.042 / 31.0;
            let swing = 200.0 * f64::powi(at - rest, 2) + 0.3 * velocity * velocity;
            let wanted = 0.5 * swing.max(200.0 * f64::powi(0.012 - rest, 2));
            assert_relative_eq!(wall, wanted, max_relative = 1e-12);
            for inward in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8], [-0.28, 0.96]] {
                let along = |way: f64| format!("[{:?}, {:?}]", way * inward[0], way * inward[1]);
                let plane = energy(&format!(
                    "{usual}{}space.dimensions = 2\n\
                     initial = {{ position = {}, velocity = {} }}\n\
                     environment.plane = {{ point = {}, normal = {}, stiffness = 6000.0 }}\n",
                    hand(&along(0.012)),
                    along(at),
                    along(velocity),
                    along(0.001),
                    along(-1.0)
                ));
                assert_relative_eq!(plane, wall, max_relative = 1e-12);
            }
        }
    }

    /// A box holds a hand in its middle at several faces: there is not one place to draw the spring to.
    #[test]
    fn a_hand_that_several_faces_hold_draws_its_spring_to_its_rest() {
        let text = "duration = 2\nservo_rate = 1000\nspace.dimensions = 2\ndevice.mass = 0.2\n\
            operator = { stiffness = 200.0, rest = [0.0, 0.0] }\ninitial.position = [0.03, 0.04]\n\
            environment.box = { center = [0.0, 0.0], half = [0.01, 0.01], stiffness = 6000.0 }\n";
        let scene = Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        assert_relative_eq!(Basis::of(&scene).energy, 0.25, max_relative = 1e-12);
    }

    #[test]
    fn a_start_in_a_solid_presses_its_spring() {
        let text = "duration = 1\nservo_rate = 1000\ndevice.mass = 0.1\nspace.dimensions = 2\n\
            initial.position = [0.003, 0.004]\ninitial.velocity = [0.0, 0.0]\n\
            environment.sphere = { center = [0.0, 0.0], radius = 0.007, stiffness = 1000.0 }\n";
        let scene = Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        // 5 mm from the middle: 2 mm deep.
        assert_relative_eq!(Basis::of(&scene).stored(), 0.002, max_relative = 1e-12);
    }
}
