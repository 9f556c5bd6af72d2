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

use lyapunov_core::{Angle, Axes, OnePort, PortSample, Scalar, Signal, WithPose};

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

/// Ports that answer with the force of a law without memory.
macro_rules! answers {
    ($(impl[$($parameters:tt)*] $law:ty, to $signal:ty);+ $(;)?) => {$(
        impl<$($parameters)*> OnePort<$signal> for $law {
            #[inline(always)]
            fn respond(&mut self, sample: &PortSample<$signal>) -> $signal {
                self.force(&Kinematics::of(sample))
            }
        }
    )+};
}

answers! {
    impl[T: Scalar] Wall<T>, to T;
    impl[T: Scalar] LayeredWall<T>, to T;
    impl[T: Scalar] HuntCrossley<T>, to T;
    impl[T: Angle, F: Axes] OrientationSpring<T>, to WithPose<T, F>;
    impl[V: Signal] Spring<V>, to V;
    impl[V: Signal] CubicSpring<V>, to V;
    impl[V: Signal, S: Solid<V>] Contact<S, V::Scalar>, to V;
}

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
