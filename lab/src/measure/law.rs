//! The environment's law in continuous time.

use std::fmt;

use lyapunov::Signal;
use lyapunov::environments::{ForceLaw, Kinematics, Time};

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
pub(crate) struct Law<V: Signal>(Option<Box<dyn ForceLaw<V>>>);

impl<V: Signal> fmt::Debug for Law<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Law").finish_non_exhaustive()
    }
}

/// Parts of a tick, for what has a kink within it.
const PARTS: u32 = 8;

/// Halvings of a part on the way to where it crosses a surface: what is left of it has no digit of the tick.
const HALVINGS: u32 = 50;

/// Gauss's three points: exact where force and motion are those of a spring and a cubic.
const POINTS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

impl<V: Space<Scalar = f64>> Law<V> {
    pub(crate) fn of(scene: &Scene) -> Self {
        Self(V::render(Scenes::of(scene), Boxed).ok())
    }

    /// The force on this motion, N.
    pub(crate) fn force(&self, at: Motion<V>) -> V {
        self.0.as_ref().map_or(V::zero(), |law| law.force(&at.into()))
    }

    /// The work over a tick, `∫ f v dt`, J, on the cubic that meets position and velocity at both ends.
    pub(crate) fn work(&self, from: Motion<V>, to: Motion<V>) -> f64 {
        let span = to.time - from.time;
        let parts = (0..PARTS).flat_map(|index| self.pieces(from, to, index));
        parts
            .flat_map(|[start, width]| {
                POINTS.map(|(place, weight)| (start + width * place, width * weight))
            })
            .map(|(share, weight)| {
                let at = between(from, to, share);
                self.force(at).scale(weight * span).inner(at.velocity)
            })
            .sum()
    }

    /// Where the pieces of a part of the tick start and how wide they are: one, or two where it crosses the surface.
    fn pieces(&self, from: Motion<V>, to: Motion<V>, part: u32) -> impl Iterator<Item = [f64; 2]> {
        let width = f64::from(PARTS).recip();
        let start = width * f64::from(part);
        let inside = |share| self.is_inside(between(from, to, share));
        let crossing = match (inside(start), inside(start + width)) {
            (Some(first), Some(last)) if first != last => {
                let [mut low, mut high] = [start, start + width];
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if inside(middle) == Some(first) { low = middle } else { high = middle }
                }
                Some(high)
            }
            _ => None,
        };
        let first = crossing.map_or(width, |crossing| crossing - start);
        let second = crossing.map(|crossing| [crossing, start + width - crossing]);
        [[start, first]].into_iter().chain(second)
    }

    /// Whether a motion is beyond the surface; none without one.
    fn is_inside(&self, at: Motion<V>) -> Option<bool> {
        let surface = self.0.as_ref()?.surface(Time::Seconds(at.time))?;
        Some(at.position.sum() > surface.position.sum())
    }
}

/// The motion on Hermite's cubic at a share of the way.
fn between<V: Signal<Scalar = f64>>(from: Motion<V>, to: Motion<V>, share: f64) -> Motion<V> {
    let span = to.time - from.time;
    let (moved, s) = (to.position - from.position, share);
    let (start, end) = (from.velocity, to.velocity);
    let mean = moved.map(|axis| axis / span);
    // x = x₀ + span (v₀ s + (3 mean − 2 v₀ − v₁) s² + (v₀ + v₁ − 2 mean) s³)
    let (second, third) = (mean.scale(3.0) - start.scale(2.0) - end, start + end - mean.scale(2.0));
    Motion {
        time: from.time + s * span,
        position: from.position + (start + (second + third.scale(s)).scale(s)).scale(span * s),
        velocity: start + (second.scale(2.0) + third.scale(3.0).scale(s)).scale(s),
        acceleration: (second.scale(2.0) + third.scale(6.0).scale(s)).map(|axis| axis / span),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// A tick that flies at 0.5 m/s from 1.3 mm before a wall of 2 kN/m to 3.7 mm in it: `½ k p²`.
    #[test]
    fn the_work_of_a_tick_that_meets_a_wall_is_what_the_wall_stores() {
        let text =
            "duration = 1\nservo_rate = 100\ndevice.mass = 1\nenvironment.wall.stiffness = 2000\n";
        let scene = Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        let at = |time, position| Motion { time, position, velocity: 0.5, acceleration: 0.0 };
        let law = Law::<f64>::of(&scene);
        let stored = 0.5 * 2000.0 * 0.0037 * 0.0037;
        let (outside, inside) = (at(0.0, -0.0013), at(0.01, 0.0037));
        assert_abs_diff_eq!(law.work(outside, inside), stored, epsilon = 1e-15);
    }
}
