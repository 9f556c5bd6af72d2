//! A one-sided wall.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, OnALine, Rates, StaticSpring, spring_and_damper};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative};

/// A one-sided wall: f = max(0, k p + b v) for the depth p = x - position > 0, else 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// Position of the surface in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping b in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key("environment.wall", "", "[environment.wall]\nstiffness = 8000.0  # N/m"),
    key("environment.wall.stiffness", "N/m", "stiffness = 8000.0  # N/m"),
    key("environment.wall.position", "m", "position = 0.0  # m"),
    key("environment.wall.damping", "N.s/m", "damping = 2.0  # N.s/m"),
];

impl Wall {
    /// The library's wall.
    fn of_lanes<T: Scalar>(
        each: Lanes<'_, &Self>,
    ) -> Result<lyapunov::environments::Wall<T>, ParameterError> {
        let (stiffness, damping) = (each.each(|it| it.stiffness), each.each(|it| it.damping));
        let wall = lyapunov::environments::Wall::new(stiffness, damping)?;
        Ok(wall.at(each.each(|it| it.position)))
    }
}

impl EnvironmentKind for Wall {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, self.damping))
    }

    fn static_spring(&self) -> Option<StaticSpring> {
        Some(StaticSpring::new(self.stiffness, self.position))
    }
}

impl OnALine for Wall {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        _rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let wall = Self::of_lanes(each)?;
        to.render(wall, wall.dissipation())
    }
}
