//! The environment's law in continuous time.

use std::fmt;

use lyapunov::Signal;
use lyapunov::environments::{ForceLaw, Kinematics, Solid, Time};

use crate::files::Scene;
use crate::files::scene::Boxed;
use crate::simulate::{Scenes, Space};

/// Position, velocity and acceleration of the plant at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion<V> {
    /// s.
    pub(crate) time: f64,
    /// m.
    pub(crate) position: V,
    /// m/s.
    pub(crate) velocity: V,
    /// m/s².
    pub(crate) acceleration: V,
}

impl<V: Signal> From<Motion<V>> for Kinematics<V> {
    fn from(Motion { time, position, velocity, acceleration }: Motion<V>) -> Self {
        Self { time: Time::Seconds(time), position, velocity, acceleration }
    }
}

/// The law of a scene's environment.
pub(crate) struct Law<V: Signal> {
    /// None where the scene's environment is of another space.
    force: Option<Box<dyn ForceLaw<V>>>,
    /// The solid that the force comes from; none before what is neither a wall nor a solid.
    solid: Option<Box<dyn Solid<V>>>,
}

impl<V: Signal> fmt::Debug for Law<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Law").finish_non_exhaustive()
    }
}

/// Parts of a tick, for what has a kink within it.
const PARTS: u32 = 8;

/// The most sides of an environment that a part of a tick is taken apart for.
const SIDES: u32 = 4;

/// Halvings of a part on the way to where it leaves a side: what is left of it has no digit of the tick.
const HALVINGS: u32 = 50;

/// Gauss's three points: exact where force and motion are those of a spring and a cubic.
const POINTS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

impl<V: Space<Scalar = f64>> Law<V> {
    pub(crate) fn of(scene: &Scene) -> Self {
        Self { force: V::render(Scenes::of(scene), Boxed).ok(), solid: V::solid(scene) }
    }

    /// The force on this motion, N.
    pub(crate) fn force(&self, at: Motion<V>) -> V {
        self.force.as_ref().map_or(V::zero(), |law| law.force(&at.into()))
    }

    /// The work over a tick, `∫ f v dt`, J, on the cubic that meets position and velocity at both ends after `span` s.
    pub(crate) fn work(&self, from: Motion<V>, to: Motion<V>, span: f64) -> f64 {
        if span == 0.0 {
            return 0.0;
        }
        // The sides of a box stand at right angles; the direction of a ball turns little.
        let is_same =
            |shares: [f64; 2]| match shares.map(|it| self.side(between(from, to, span, it))) {
                [Some(one), Some(other)] => one.inner(other) > 0.0,
                [one, other] => one.is_none() && other.is_none(),
            };
        let mut work = 0.0;
        let mut add = |start: f64, width: f64| {
            for (place, weight) in POINTS {
                let at = between(from, to, span, start + width * place);
                work += self.force(at).scale(width * weight * span).inner(at.velocity);
            }
        };
        (0..PARTS).for_each(|part| pieces(part, &is_same, &mut add));
        work
    }

    /// The direction of the side that pushes, by which the force is smooth; none where no force acts: outside of a wall, and where its
    /// damper would pull.
    fn side(&self, at: Motion<V>) -> Option<V> {
        let normal = match &self.solid {
            Some(solid) => solid.nearest(at.position).normal,
            None => V::zero().map(|_| 1.0),
        };
        (self.force(at) != V::zero()).then_some(normal)
    }
}

/// Hands on the pieces of a part of a tick by start and width, one for each side that it goes through; `is_same` tells of two places
/// whether they are on one side.
fn pieces(part: u32, is_same: &dyn Fn([f64; 2]) -> bool, piece: &mut dyn FnMut(f64, f64)) {
    let width = f64::from(PARTS).recip();
    let mut start = width * f64::from(part);
    let end = start + width;
    for _ in 1..SIDES {
        if is_same([start, end]) {
            break;
        }
        let [mut low, mut high] = [start, end];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if is_same([start, middle]) { low = middle } else { high = middle }
        }
        piece(start, high - start);
        start = high;
    }
    piece(start, end - start);
}

/// The motion on Hermite's cubic of `span` s at a share of the way.
fn between<V: Signal<Scalar = f64>>(
    from: Motion<V>,
    to: Motion<V>,
    span: f64,
    share: f64,
) -> Motion<V> {
    let (moved, s) = (to.position - from.position, share);
    let (start, end) = (from.velocity, to.velocity);
    let mean = moved.map(|axis| axis / span);
    // x = x₀ + span (v₀ s + (3 mean − 2 v₀ − v₁) s² + (v₀ + v₁ − 2 mean) s³)
    let (second, third) = (mean.scale(3.0) - start.scale(2.0) - end, start + end - mean.scale(2.0));
    Motion {
        time: from.time + s * (to.time - from.time),
        position: from.position + (start + (second + third.scale(s)).scale(s)).scale(span * s),
        velocity: start + (second.scale(2.0) + third.scale(3.0).scale(s)).scale(s),
        acceleration: (second.scale(2.0) + third.scale(6.0).scale(s)).map(|axis| axis / span),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;
    use nalgebra::{Vector2, Vector3};

    use super::*;

    /// The law of an environment of 2 kN/m in a space of `axes`.
    fn law<V: Space<Scalar = f64>>(axes: u32, environment: &str) -> Law<V> {
        let text = format!(
            "duration = 1\nservo_rate = 100\ndevice.mass = 1\nspace.dimensions = {axes}\n\
             environment.{environment}\n"
        );
        let space = if axes == 1 { text.replace("space.dimensions = 1\n", "") } else { text };
        Law::of(&Scene::parse(&space, "test").unwrap_or_else(|fault| panic!("{fault}")))
    }

    fn flies<V>(time: f64, position: V, velocity: V, acceleration: V) -> Motion<V> {
        Motion { time, position, velocity, acceleration }
    }

    /// The energy that 2 kN/m store at a depth, J.
    fn stored(depth: f64) -> f64 {
        0.5 * 2000.0 * depth * depth
    }

    /// A tick that flies at 0.5 m/s from 1.3 mm before a wall to 3.7 mm in it: `½ k p²`; and back.
    #[test]
    fn the_work_of_a_tick_that_meets_a_wall_is_what_the_wall_stores() {
        for environment in [
            "wall.stiffness = 2000",
            "moving-wall = { stiffness = 2000, amplitude = 0, frequency = 1 }",
        ] {
            let law = law::<f64>(1, environment);
            let at = |time, x, v| flies(time, x, v, 0.0);
            let work = law.work(at(0.0, -0.0013, 0.5), at(0.01, 0.0037, 0.5), 0.01);
            assert_abs_diff_eq!(work, stored(0.0037), epsilon = 1e-15);
            let back = law.work(at(0.0, 0.0037, -0.5), at(0.01, -0.0013, -0.5), 0.01);
            assert_abs_diff_eq!(back, -stored(0.0037), epsilon = 1e-15);
        }
    }

    /// Out of a wall whose damper would pull from 1 mm on, at 0.5 m/s: the spring less what holds the damper's force.
    #[test]
    fn the_work_of_a_tick_in_which_the_force_is_cut_is_what_acted() {
        let law = law::<f64>(1, "wall = { stiffness = 2000, damping = 4 }");
        let at = |time, x| flies(time, x, -0.5, 0.0);
        let work = law.work(at(0.0, 0.0037), at(0.01, -0.0013), 0.01);
        assert_abs_diff_eq!(work, -stored(0.0027), epsilon = 1e-15);
    }

    /// The same, slanting, before solids: a spring stores by the depth alone, whatever the way to it.
    #[test]
    fn the_work_of_a_tick_that_meets_a_solid_is_what_the_solid_stores() {
        let plane = law::<Vector2<f64>>(
            2,
            "plane = { point = [0, 0], normal = [-3, 4], stiffness = 2000 }",
        );
        let normal = Vector2::new(-0.6, 0.8);
        let along = Vector2::new(0.8, 0.6);
        let [out, within] = [0.0013, -0.0037].map(|height| normal * height);
        let velocity = normal * -0.5 + along * 0.2;
        let fly = |time, place| flies(time, place, velocity, Vector2::zeros());
        let work = plane.work(fly(0.0, out), fly(0.01, within + along * 0.002), 0.01);
        assert_abs_diff_eq!(work, stored(0.0037), epsilon = 1e-15);

        for solid in [
            "sphere = { center = [0, 0, 0], radius = 0.05, stiffness = 2000 }",
            "box = { center = [0, 0, 0], half = [0.05, 0.05, 0.05], stiffness = 2000 }",
        ] {
            let law = law::<Vector3<f64>>(3, solid);
            let velocity = Vector3::new(-0.5, 0.0, 0.0);
            let fly = |time, x| flies(time, Vector3::new(x, 0.0, 0.0), velocity, Vector3::zeros());
            let work = law.work(fly(0.0, 0.0513), fly(0.01, 0.0463), 0.01);
            assert_abs_diff_eq!(work, stored(0.0037), epsilon = 1e-15);
        }
    }

    /// Ways through boxes store by the depth at their ends alone, though the nearest side changes on the way; and nothing is left
    /// of one from outside to outside.
    #[test]
    fn the_work_past_an_edge_of_a_box_is_what_the_box_stores() {
        let law = law::<Vector2<f64>>(
            2,
            "box = { center = [0, 0], half = [0.02, 0.015], stiffness = 2000 }",
        );
        let depth = |it: &Vector2<f64>| (0.02 - it.x.abs()).min(0.015 - it.y.abs()).max(0.0);
        for (from, to) in [
            ((-0.012, -0.016), (-0.021, -0.004)),
            ((0.0, -0.016), (0.021, 0.009)),
            ((-0.021, 0.013), (0.021, -0.013)),
            ((-0.019, 0.002), (0.019, 0.002)),
        ] {
            let [from, to] = [from, to].map(|(x, y)| Vector2::new(x, y));
            let velocity = (to - from) / 0.01;
            let fly = |time, place| flies(time, place, velocity, Vector2::zeros());
            let work = law.work(fly(0.0, from), fly(0.01, to), 0.01);
            let expected = stored(depth(&to)) - stored(depth(&from));
            assert_abs_diff_eq!(work, expected, epsilon = 1e-14);
        }
    }

    /// A slanting way to a ball, whose depth is no cubic: the error is the rule's own, no longer that of a kink.
    #[test]
    fn the_work_of_a_slanting_way_into_a_ball_is_what_it_stores() {
        let law =
            law::<Vector2<f64>>(2, "sphere = { center = [0, 0], radius = 0.05, stiffness = 2000 }");
        let velocity = Vector2::new(-0.5, 0.7);
        let [from, to] = [0.0, 0.01].map(|time| {
            flies(time, Vector2::new(0.0513, -0.002) + velocity * time, velocity, Vector2::zeros())
        });
        let depth = 0.05 - to.position.norm();
        assert!(depth > 0.003 && from.position.norm() > 0.051);
        assert_abs_diff_eq!(law.work(from, to, 0.01), stored(depth), epsilon = 1e-12);
    }
}
