//! Environments, which answer a motion with a force.

mod body_points;
mod cubic_spring;
mod dissipation_of;
mod force_law;
mod hunt_crossley;
mod layered_wall;
mod mass_spring_damper;
mod moving_wall;
mod one_sided;
mod orientation_spring;
mod oscillation;
mod solids;
mod spring;
mod varying_spring;
mod wall;

use lyapunov_core::{Scalar, Signal};

pub use body_points::BodyPoints;
pub use cubic_spring::CubicSpring;
pub use dissipation_of::DissipationOf;
pub use force_law::{ForceLaw, Kinematics, Surface, Time};
pub use hunt_crossley::HuntCrossley;
pub use layered_wall::LayeredWall;
pub use mass_spring_damper::MassSpringDamper;
pub use moving_wall::MovingWall;
pub use orientation_spring::OrientationSpring;
pub use solids::{Contact, Cuboid, NearestPoint, Plane, Solid, Sphere};
pub use spring::Spring;
pub use varying_spring::VaryingSpring;
pub use wall::Wall;

lyapunov_core::without_memory! {
    impl[T: Scalar] Wall<T>;
    impl[T: Scalar] LayeredWall<T>;
    impl[T: Scalar] HuntCrossley<T>;
    impl[T: Scalar] OrientationSpring<T>;
    impl[V: Signal] Spring<V>;
    impl[V: Signal] CubicSpring<V>;
    impl[S, T: Scalar] Contact<S, T>;
    impl[L, T: Scalar, const N: usize] BodyPoints<L, T, N>;
}
