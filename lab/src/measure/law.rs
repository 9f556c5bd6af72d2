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

/// Parts of a tick, for a surface met within it.
const PARTS: u32 = 8;

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
        let part = f64::from(PARTS).recip();
        let parts = (0..PARTS).flat_map(|index| {
            POINTS.map(|(place, weight)| (part * (f64::from(index) + place), part * weight))
        });
        parts
            .map(|(share, weight)| {
                let at = between(from, to, share);
                self.force(at).scale(weight * span).inner(at.velocity)
            })
            .sum()
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
