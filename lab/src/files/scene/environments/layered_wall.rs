//! A one-sided wall of two layers.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, Number, OnALine, Rates, spring_and_damper};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative, two};

/// A one-sided wall of two layers: a spring force k1 p down to `depth`, k1 depth + k2 (p - depth) below, plus b v, never
/// below 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LayeredWall {
    /// Position of the surface in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Depth of the upper layer in m, 0 or more; required.
    pub depth: NonNegative,
    /// Stiffnesses [k1, k2] of the upper and the lower layer in N/m, 0 or more; required.
    #[serde(deserialize_with = "two")]
    pub stiffness: [NonNegative; 2],
    /// Damping b in N.s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.layered-wall",
        "",
        "[environment.layered-wall]\ndepth = 0.002  # m\nstiffness = [500.0, 8000.0]  # N/m",
    ),
    key("environment.layered-wall.position", "m", "position = 0.0  # m"),
    key("environment.layered-wall.depth", "m", "depth = 0.002  # m"),
    key("environment.layered-wall.stiffness", "N/m", "stiffness = [500.0, 8000.0]  # N/m"),
    key("environment.layered-wall.damping", "N.s/m", "damping = 2.0  # N.s/m"),
];

impl EnvironmentKind for LayeredWall {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness[0], self.damping))
    }

    fn impedance_note(&self) -> Option<&'static str> {
        Some("the stiffness is the first layer's")
    }

    fn steepest(&self) -> Option<Impedance<f64>> {
        let [upper, lower] = self.stiffness.map(NonNegative::get);
        Some(spring_and_damper(upper.max(lower), self.damping))
    }

    fn words(&self, number: Number) -> String {
        let [upper, lower] = self.stiffness.map(|stiffness| number(stiffness.get()));
        let (depth, damping) = (number(1e3 * self.depth.get()), number(self.damping.get()));
        format!("{upper} N/m to {depth} mm, {lower} N/m below, {damping} N.s/m")
    }
}

impl OnALine for LayeredWall {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        _rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let (depth, stiffness) =
            (each.each(|it| it.depth), [0, 1].map(|layer| each.each(|it| it.stiffness[layer])));
        let wall =
            lyapunov::environments::LayeredWall::new(depth, stiffness, each.each(|it| it.damping))?;
        let wall = wall.at(each.each(|it| it.position));
        to.render(wall, wall.dissipation())
    }
}
