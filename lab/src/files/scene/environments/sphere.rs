//! A ball.

use lyapunov::{ParameterError, Scalar, bodies::Impedance, environments::Solid};
use nalgebra::SVector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, InSpace, spring_and_damper};
use crate::files::scene::book::{Key, key};
use crate::files::scene::coordinates::Coordinates;
use crate::files::scene::quantity::{Finite, NonNegative, Positive, of};

/// A ball, pushed from outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Its middle, m; required.
    #[schemars(with = "Vec<Finite>", length(min = 2, max = 3))]
    pub center: Coordinates,
    /// Radius in m, greater than 0; required.
    pub radius: Positive,
    /// Stiffness k in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping b in N.s/m, 0 or more, along the normal; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.sphere",
        "",
        "[environment.sphere]\ncenter = [0.0, 0.0]  # m\nradius = 0.02  # m\nstiffness = 2000.0  # N/m",
    ),
    key("environment.sphere.center", "m", "center = [0.0, 0.0]  # m"),
    key("environment.sphere.radius", "m", "radius = 0.02  # m"),
    key("environment.sphere.stiffness", "N/m", "stiffness = 2000.0  # N/m"),
    key("environment.sphere.damping", "N.s/m", "damping = 2.0  # N.s/m"),
];

impl EnvironmentKind for Sphere {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, self.damping))
    }

    fn vectors(&self) -> Vec<(&'static str, usize)> {
        vec![("center", self.center.len())]
    }
}

impl InSpace for Sphere {
    fn solid<T: Scalar, const N: usize>(
        &self,
    ) -> Result<impl Solid<SVector<T, N>> + Copy + 'static, ParameterError> {
        lyapunov::environments::Sphere::new(self.center.vector::<T, N>(), of(self.radius))
    }
}
