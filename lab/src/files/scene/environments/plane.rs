//! A half space.

use lyapunov::{ParameterError, Scalar, bodies::Impedance, environments::Solid};
use nalgebra::SVector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, InSpace, spring_and_damper};
use crate::files::scene::book::{Key, key};
use crate::files::scene::check::Conflict;
use crate::files::scene::coordinates::Coordinates;
use crate::files::scene::quantity::{Finite, NonNegative};

/// A half space, pushed from outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// A point of the surface, m; required.
    #[schemars(with = "Vec<Finite>", length(min = 2, max = 3))]
    pub point: Coordinates,
    /// Direction out of the solid, of any length but 0; required.
    #[schemars(with = "Vec<Finite>", length(min = 2, max = 3))]
    pub normal: Coordinates,
    /// Stiffness k in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping b in N.s/m, 0 or more, along the normal; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.plane",
        "",
        "[environment.plane]\npoint = [0.0, 0.0]  # m\nnormal = [0.0, 1.0]\nstiffness = 2000.0  # N/m",
    ),
    key("environment.plane.point", "m", "point = [0.0, 0.0]  # m"),
    key("environment.plane.normal", "", "normal = [0.0, 1.0]"),
    key("environment.plane.stiffness", "N/m", "stiffness = 2000.0  # N/m"),
    key("environment.plane.damping", "N.s/m", "damping = 2.0  # N.s/m"),
];

impl EnvironmentKind for Plane {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, self.damping))
    }

    fn normal(&self) -> Option<Coordinates> {
        Some(self.normal.clone())
    }

    fn vectors(&self) -> Vec<(&'static str, usize)> {
        vec![("point", self.point.len()), ("normal", self.normal.len())]
    }

    fn check(&self) -> Result<(), Conflict> {
        if (0..3).any(|axis| self.normal.axis(axis) != 0.0) {
            return Ok(());
        }
        Err(Conflict::new(
            "environment.plane.normal",
            "`environment.plane.normal` is 0 along every axis and has no direction",
            "give the direction out of the solid, for example [0.0, 1.0]",
        ))
    }
}

impl InSpace for Plane {
    fn solid<T: Scalar, const N: usize>(
        &self,
    ) -> Result<impl Solid<SVector<T, N>> + Copy + 'static, ParameterError> {
        lyapunov::environments::Plane::new(self.point.vector::<T, N>(), self.normal.vector())
    }
}
