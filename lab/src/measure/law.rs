//! The environment's law in continuous time.

use std::fmt;

use lyapunov::environments::{ForceLaw, Kinematics, Time};

use crate::files::Scene;

/// Position, velocity and acceleration of the plant at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Motion {
    /// s.
    pub(crate) time: f64,
    /// m.
    pub(crate) position: f64,
    /// m/s.
    pub(crate) velocity: f64,
    /// m/s².
    pub(crate) acceleration: f64,
}

impl From<Motion> for Kinematics<f64> {
    fn from(Motion { time, position, velocity, acceleration }: Motion) -> Self {
        Self { time: Time::Seconds(time), position, velocity, acceleration }
    }
}

/// The law of a scene's environment; none for an environment that is not on a line.
pub(crate) struct Law(Option<Box<dyn ForceLaw<f64>>>);

impl fmt::Debug for Law {
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

impl Law {
    pub(crate) fn of(scene: &Scene) -> Self {
        Self(scene.law())
    }

    /// The force on this motion, N.
    pub(crate) fn force(&self, at: Motion) -> f64 {
        self.0.as_ref().map_or(0.0, |law| law.force(&at.into()))
    }

    /// The work over a tick, `∫ f v dt`, J, on the cubic that meets position and velocity at both ends.
    pub(crate) fn work(&self, from: Motion, to: Motion) -> f64 {
        let span = to.time - from.time;
        let part = f64::from(PARTS).recip();
        let parts = (0..PARTS).flat_map(|index| {
            POINTS.map(|(place, weight)| (part * (f64::from(index) + place), part * weight))
        });
        parts
            .map(|(share, weight)| {
                let at = between(from, to, share);
                weight * span * self.force(at) * at.velocity
            })
            .sum()
    }
}

/// The motion on Hermite's cubic at a share of the way.
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
