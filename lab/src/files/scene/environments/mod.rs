//! The environments that a device touches.
//!
//! Each kind has its own file: its keys, the library's environment made from them, and the properties that the lab
//! needs besides the force law. The force law itself is in the library only. The table below lists the kinds.

mod cubic_spring;
mod cuboid;
mod hunt_crossley;
mod kind;
mod layered_wall;
mod mass_spring_damper;
mod moving_wall;
mod plane;
mod render;
mod sphere;
mod spring;
mod varying_spring;
mod wall;

use lyapunov::{
    ParameterError, Requirement, Scalar,
    environments::{self, ForceLaw, Solid, Time},
};
use nalgebra::SVector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::files::scene::book::{Key, count, joined};
use crate::files::scene::quantity::of;
use crate::files::scene::{Draft, Lanes};
use kind::{InSpace, OnALine};

pub(crate) use kind::{EnvironmentKind, Face, Rates, StaticSpring};
pub(crate) use render::Boxed;
pub use render::Render;

macro_rules! environments {
    (
        on a line { $($(#[$about:meta])* $line:ident = $line_name:literal in $line_file:ident;)* }
        in space { $($(#[$solid_about:meta])* $solid:ident = $solid_name:literal in $solid_file:ident;)* }
    ) => {
        $(pub use $line_file::$line;)*
        $(pub use $solid_file::$solid;)*

        /// Environment that the device touches: in one dimension x - position > 0 is inside.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
        pub enum Environment {
            $($(#[$about])* #[serde(rename = $line_name)] $line($line),)*
            $($(#[$solid_about])* #[serde(rename = $solid_name)] $solid($solid),)*
        }

        /// The names of the environments of one dimension, and of several.
        pub(super) const NAMES: [&[&str]; 2] = [&[$($line_name),*], &[$($solid_name),*]];

        const TABLES: &[&[Key]] = &[$($line_file::KEYS,)* $($solid_file::KEYS,)*];

        impl Environment {
            /// Its name in a scene file.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$line(_) => $line_name,)*
                    $(Self::$solid(_) => $solid_name,)*
                }
            }

            /// The interface of its kind.
            pub(crate) fn kind(&self) -> &dyn EnvironmentKind {
                match self {
                    $(Self::$line(it) => it,)*
                    $(Self::$solid(it) => it,)*
                }
            }

            /// The result of `to` for the library's environment of one dimension, with the numbers of each lane.
            pub(crate) fn on_a_line<T: Scalar, R: Render<T>>(
                each: &[&Self],
                rates: Rates,
                to: R,
            ) -> Result<R::Made, ParameterError> {
                match Lanes::new(each).common() {
                    $(Self::$line(_) => {
                        let mut kinds = Vec::with_capacity(each.len());
                        for one in each {
                            let Self::$line(kind) = one else { return Err(elsewhere(1)) };
                            kinds.push(kind);
                        }
                        $line::make(Lanes::new(&kinds), rates, to)
                    })*
                    _ => Err(elsewhere(1)),
                }
            }

            /// The result of `to` for the library's environment of several dimensions.
            pub(crate) fn in_space<T: Scalar, const N: usize, R: Render<SVector<T, N>>>(
                &self,
                to: R,
            ) -> Result<R::Made, ParameterError> {
                match self {
                    $(Self::$solid(it) => it.make(to),)*
                    _ => Err(elsewhere(N)),
                }
            }

            /// The solid that the device touches in several dimensions; none in one.
            pub(crate) fn solid_in_space<T: Scalar, const N: usize>(
                &self,
            ) -> Option<Box<dyn Solid<SVector<T, N>>>> {
                match self {
                    $(Self::$solid(it) => Some(Box::new(it.solid::<T, N>().ok()?)),)*
                    _ => None,
                }
            }
        }
    };
}

environments! {
    on a line {
        /// A one-sided wall.
        Wall = "wall" in wall;
        /// A two-sided spring.
        Spring = "spring" in spring;
        /// A two-sided mass, spring and damper.
        MassSpringDamper = "mass-spring-damper" in mass_spring_damper;
        /// A one-sided wall of two layers.
        LayeredWall = "layered-wall" in layered_wall;
        /// A one-sided wall whose damping grows with its depth.
        HuntCrossley = "hunt-crossley" in hunt_crossley;
        /// A one-sided wall that swings.
        MovingWall = "moving-wall" in moving_wall;
        /// A two-sided spring whose stiffness swings.
        VaryingSpring = "varying-spring" in varying_spring;
        /// A two-sided spring that hardens.
        CubicSpring = "cubic-spring" in cubic_spring;
    }
    in space {
        /// A half space; needs `space`.
        Plane = "plane" in plane;
        /// A ball; needs `space`.
        Sphere = "sphere" in sphere;
        /// A box along the axes; needs `space`.
        Cuboid = "box" in cuboid;
    }
}

/// The keys of all environments, for messages.
pub(super) const KEYS: &[Key] = &joined::<{ count(TABLES) }>(TABLES);

impl Environment {
    /// Whether it needs several dimensions.
    pub(super) fn is_solid(&self) -> bool {
        NAMES[1].contains(&self.name())
    }

    /// The wall, if it is one, for measures that apply to walls only.
    pub(crate) fn wall(&self) -> Option<&Wall> {
        if let Self::Wall(wall) = self { Some(wall) } else { None }
    }

    /// The solid that the device touches on a line, a wall's half space; none of another environment.
    pub(crate) fn solid_on_a_line<T: Scalar>(&self) -> Option<Box<dyn Solid<T>>> {
        let surface = of(self.wall()?.position);
        Some(Box::new(environments::Plane::new(surface, -T::one()).ok()?))
    }

    /// The stiffness with which a wall or a solid answers the depth below its surface, N/m; none of another environment.
    pub(crate) fn surface_stiffness(&self) -> Option<f64> {
        let has_surface = self.wall().is_some() || self.is_solid();
        self.kind().impedance().filter(|_| has_surface).map(|it| it.stiffness)
    }

    /// The wall, if it is one, to be changed.
    pub(crate) fn wall_mut(&mut self) -> Option<&mut Wall> {
        if let Self::Wall(wall) = self { Some(wall) } else { None }
    }
}

impl Draft {
    /// The force law of the environment in `f64`; none in more than one dimension.
    pub(crate) fn law(&self) -> Option<Box<dyn ForceLaw<f64>>> {
        Environment::on_a_line(&[&self.environment], Rates::of(self), Boxed).ok()
    }

    /// The place of the environment's surface at the start, m; none without one and in more than one dimension.
    pub(crate) fn surface(&self) -> Option<f64> {
        // Maps ask it of a wall for every cell, which needs no box.
        match self.environment.wall() {
            Some(wall) => Some(wall.position.get()),
            None => self.law()?.surface(Time::Seconds(0.0)).map(|surface| surface.position),
        }
    }
}

/// The error of an environment that does not exist in this number of dimensions.
fn elsewhere(dimensions: usize) -> ParameterError {
    let requirement = Requirement::InRange;
    ParameterError { parameter: "dimensions", value: dimensions as f64, requirement }
}

#[cfg(test)]
mod tests {
    use crate::files::scene::Scene;
    use crate::files::shipped::SCENES;
    use lyapunov::environments::{Kinematics, Time};

    /// Differences of the force along a motion, at many places and times, are at most those of the steepest spring, and come
    /// near them.
    #[test]
    fn no_force_rises_faster_than_the_steepest_spring() {
        let mut springs = 0;
        for shipped in SCENES {
            // Its motion is in a file beside it.
            if shipped.name == "motion-file" {
                continue;
            }
            let scene = Scene::parse(shipped.text, shipped.name).unwrap();
            let (Some(law), Some(steepest)) = (scene.law(), scene.environment.kind().steepest())
            else {
                continue;
            };
            let force = |time: f64, position: f64| {
                let still = Kinematics::at(position, 0.0);
                law.force(&Kinematics { time: Time::Seconds(time), ..still })
            };
            let surface = scene.surface().unwrap_or(0.0);
            let rise = |at: u32| {
                let (time, position) =
                    (0.01 * f64::from(at % 101), surface + 1e-4 * f64::from(at / 101) - 0.02);
                let [from, to] = [position, position + 1e-4].map(|it| force(time, it));
                // A damper pushes at once where a surface is met.
                if from == 0.0 || to == 0.0 { 0.0 } else { (to - from) / 1e-4 }
            };
            let most = (0..101 * 400).map(rise).map(f64::abs).fold(0.0, f64::max);
            let share = most / steepest.stiffness.abs();
            assert!((0.9..1.0 + 1e-6).contains(&share), "{}: {share}", shipped.name);
            springs += 1;
        }
        assert!(springs > 8, "{springs}");
    }
}
