//! What the device touches.

use schemars::JsonSchema;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use super::coordinates::Coordinates;
use super::quantity::{Finite, NonNegative, Positive};

/// What the device touches: in one dimension x - position > 0 is inside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Environment {
    /// A one-sided wall.
    Wall(Wall),
    /// A two-sided spring.
    Spring(Spring),
    /// A two-sided mass, spring and damper.
    MassSpringDamper(MassSpringDamper),
    /// A one-sided wall of two layers.
    LayeredWall(LayeredWall),
    /// A one-sided wall whose damping grows with its depth.
    HuntCrossley(HuntCrossley),
    /// A one-sided wall that swings.
    MovingWall(MovingWall),
    /// A two-sided spring whose stiffness swings.
    VaryingSpring(VaryingSpring),
    /// A half space; needs `space`.
    Plane(Plane),
    /// A ball; needs `space`.
    Sphere(Sphere),
    /// A box along the axes; needs `space`.
    #[serde(rename = "box")]
    Cuboid(Cuboid),
}

impl Environment {
    /// Its name in a scene file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Wall(_) => "wall",
            Self::Spring(_) => "spring",
            Self::MassSpringDamper(_) => "mass-spring-damper",
            Self::LayeredWall(_) => "layered-wall",
            Self::HuntCrossley(_) => "hunt-crossley",
            Self::MovingWall(_) => "moving-wall",
            Self::VaryingSpring(_) => "varying-spring",
            Self::Plane(_) => "plane",
            Self::Sphere(_) => "sphere",
            Self::Cuboid(_) => "box",
        }
    }

    /// Its vectors with their keys; none in one dimension.
    pub(super) fn vectors(&self) -> Vec<(&'static str, usize)> {
        match self {
            Self::Plane(it) => vec![
                ("environment.plane.point", it.point.len()),
                ("environment.plane.normal", it.normal.len()),
            ],
            Self::Sphere(it) => vec![("environment.sphere.center", it.center.len())],
            Self::Cuboid(it) => {
                vec![
                    ("environment.box.center", it.center.len()),
                    ("environment.box.half", it.half.len()),
                ]
            }
            _ => vec![],
        }
    }
}

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

/// A two-sided spring: f = k (x - position).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Position at which it is relaxed, in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m; a negative one pushes away; required.
    pub stiffness: Finite,
}

/// A two-sided mass, spring and damper: f = m a + b v + k (x - position), a the difference of v from one environment tick
/// to the next over their interval.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MassSpringDamper {
    /// Position at which its spring is relaxed, in m; default 0.
    pub position: Finite,
    /// Mass m in kg, 0 or more; default 0.
    pub mass: NonNegative,
    /// Damping b in N.s/m; a negative one drives the motion; default 0.
    pub damping: Finite,
    /// Stiffness k in N/m, 0 or more; default 0.
    pub stiffness: NonNegative,
}

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

/// Exactly two, in a list.
pub(crate) fn two<'de, D, T>(deserializer: D) -> Result<[T; 2], D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    <[T; 2]>::try_from(Vec::deserialize(deserializer)?).map_err(|list: Vec<T>| {
        D::Error::custom(format_args!("must be a list of two numbers, not of {}", list.len()))
    })
}

/// A one-sided wall after Hunt and Crossley: f = max(0, k p^e (1 + damping v)) for the depth p = x - position > 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HuntCrossley {
    /// Position of the surface in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m^e, 0 or more; required.
    pub stiffness: NonNegative,
    /// Exponent e, greater than 0: 1.5 for a ball on a flat surface; required.
    pub exponent: Positive,
    /// Damping in s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

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

/// A two-sided spring whose stiffness swings: k(t) = stiffness + amplitude sin(2 pi frequency t).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VaryingSpring {
    /// Position at which it is relaxed, in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Mean stiffness in N/m; required.
    pub stiffness: Finite,
    /// Amplitude of the stiffness in N/m; required.
    pub amplitude: Finite,
    /// Frequency of the stiffness in Hz, 0 or more; required.
    pub frequency: NonNegative,
}

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
