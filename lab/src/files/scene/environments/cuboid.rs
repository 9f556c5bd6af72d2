//! A box along the axes.

use lyapunov::{ParameterError, Scalar, bodies::Impedance, environments::Solid};
use nalgebra::SVector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, Face, InSpace, spring_and_damper};
use crate::files::scene::book::{Key, key};
use crate::files::scene::coordinates::Coordinates;
use crate::files::scene::quantity::{Finite, NonNegative, Positive, of};

/// A box along the axes, pushed from outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cuboid {
    /// Its middle, m; required.
    #[schemars(with = "Vec<Finite>", length(min = 2, max = 3))]
    pub center: Coordinates,
    /// Half its edges in m, each greater than 0; required.
    #[schemars(length(min = 2, max = 3))]
    pub half: Vec<Positive>,
    /// Stiffness k in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping b in N.s/m, 0 or more, along the normal; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.box",
        "",
        "[environment.box]\ncenter = [0.0, 0.0]  # m\nhalf = [0.02, 0.01]  # m\nstiffness = 2000.0  # N/m",
    ),
    key("environment.box.center", "m", "center = [0.0, 0.0]  # m"),
    key("environment.box.half", "m", "half = [0.02, 0.01]  # m"),
    key("environment.box.stiffness", "N/m", "stiffness = 2000.0  # N/m"),
    key("environment.box.damping", "N.s/m", "damping = 2.0  # N.s/m"),
];

impl EnvironmentKind for Cuboid {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, self.damping))
    }

    fn faces(&self) -> Vec<Face> {
        let halves = self.half.iter().enumerate();
        let faces = halves.flat_map(|(axis, half)| {
            let face = |outward: f64| {
                let position = self.center.axis(axis) + outward * half.get();
                Face { axis, outward, position }
            };
            [face(-1.0), face(1.0)]
        });
        faces.collect()
    }

    fn vectors(&self) -> Vec<(&'static str, usize)> {
        vec![("center", self.center.len()), ("half", self.half.len())]
    }
}

impl InSpace for Cuboid {
    fn solid<T: Scalar, const N: usize>(
        &self,
    ) -> Result<impl Solid<SVector<T, N>> + Copy + 'static, ParameterError> {
        let half = |axis: usize| self.half.get(axis).map_or(T::zero(), |half| of(*half));
        let half = SVector::from_fn(|axis, _| half(axis));
        lyapunov::environments::Cuboid::new(self.center.vector::<T, N>(), half)
    }
}
