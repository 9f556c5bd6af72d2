//! A one-sided wall that swings.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{
    EnvironmentKind, Number, OnALine, Rates, StaticSpring, damped, spring_and_damper, swinging,
};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative};

/// A one-sided wall whose surface swings: position + amplitude sin(2 pi frequency t).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovingWall {
    /// Position about which the surface swings, in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping b in N.s/m, 0 or more, of the motion relative to the surface; default 0.
    #[serde(default)]
    pub damping: NonNegative,
    /// Amplitude of the surface in m; required.
    pub amplitude: Finite,
    /// Frequency of the surface in Hz, 0 or more; required.
    pub frequency: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.moving-wall",
        "",
        "[environment.moving-wall]\nstiffness = 2000.0  # N/m\namplitude = 0.001  # m\nfrequency = 2.0  # Hz",
    ),
    key("environment.moving-wall.position", "m", "position = 0.0  # m"),
    key("environment.moving-wall.stiffness", "N/m", "stiffness = 2000.0  # N/m"),
    key("environment.moving-wall.damping", "N.s/m", "damping = 2.0  # N.s/m"),
    key("environment.moving-wall.amplitude", "m", "amplitude = 0.001  # m"),
    key("environment.moving-wall.frequency", "Hz", "frequency = 2.0  # Hz"),
];

impl EnvironmentKind for MovingWall {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, self.damping))
    }

    fn impedance_note(&self) -> Option<&'static str> {
        Some("the wall is taken to stand; what moves may add energy of its own")
    }

    fn static_spring(&self) -> Option<StaticSpring> {
        Some(StaticSpring::new(self.stiffness, self.position))
    }

    fn frequency(&self) -> Option<f64> {
        swinging(self.amplitude, self.frequency)
    }

    fn words(&self, number: Number) -> String {
        let wall = damped(number, self.stiffness, self.damping);
        let (amplitude, frequency) = (1e3 * self.amplitude.get(), self.frequency.get());
        format!("{wall}, {} mm at {} Hz", number(amplitude), number(frequency))
    }
}

impl OnALine for MovingWall {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let wall = lyapunov::environments::Wall::new(
            each.each(|it| it.stiffness),
            each.each(|it| it.damping),
        )?;
        let (amplitude, frequency) = (each.each(|it| it.amplitude), each.each(|it| it.frequency));
        let wall = wall.at(each.each(|it| it.position));
        let moving = lyapunov::environments::MovingWall::new(
            wall,
            amplitude,
            frequency,
            T::of(rates.environment),
        )?;
        to.render(moving, moving.dissipation(T::of(rates.servo))?)
    }
}
