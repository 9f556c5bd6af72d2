//! What the device of a scene touches, and what of it a candidate may credit.

use lyapunov::{
    Contact, Cuboid, Dissipation, HuntCrossley, Impedance, LayeredWall, LyapunovCandidate,
    MassSpringDamper, MovingWall, OnePort, ParameterError, Plane, Requirement, Scalar, Signal,
    Sphere, Spring, VaryingSpring, Wall,
};
use nalgebra::SVector;

use super::{Port, Space};
use crate::scene::{Draft, Environment, Scene};

/// What is made of an environment and the term of its own damper, both of types that only the scene knows.
pub trait Render<V: Signal> {
    /// What is made of them.
    type Made;

    /// Makes it.
    ///
    /// # Errors
    /// Whatever the making meets.
    fn render(
        self,
        environment: impl OnePort<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError>;
}

/// The environment itself, boxed.
pub(crate) struct AsPort;

impl<V: Signal> Render<V> for AsPort {
    type Made = Port<V>;

    fn render(
        self,
        environment: impl OnePort<V> + 'static,
        _credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Port<V>, ParameterError> {
        Ok(Port::new(environment))
    }
}

pub(crate) fn on_a_line<T: Scalar, R: Render<T>>(
    scene: &Draft,
    to: R,
) -> Result<R::Made, ParameterError> {
    let nothing = Dissipation::of(T::zero())?;
    // Environments tick at their own rate, what is credited at the servo's. The one is taken from the other, because a
    // scene's two rates divide each other but for a billionth, which would add up.
    let rate = scene.servo_rate.get();
    let (slow, fast) = (T::of(rate / scene.environment_ratio() as f64), T::of(rate));
    match &scene.environment {
        Environment::Wall(it) => {
            let wall = Wall::new(of(it.stiffness), of(it.damping))?.at(of(it.position));
            to.render(wall, wall.dissipation())
        }
        Environment::Spring(it) => {
            to.render(Spring::<T>::new(of(it.stiffness))?.at(of(it.position)), nothing)
        }
        Environment::MassSpringDamper(it) => {
            let impedance = Impedance {
                mass: of(it.mass),
                damping: of(it.damping),
                stiffness: of(it.stiffness),
            };
            let body = MassSpringDamper::<T>::new(impedance)?.at(of(it.position));
            to.render(body, body.dissipation())
        }
        Environment::LayeredWall(it) => {
            let wall = LayeredWall::new(of(it.depth), it.stiffness.map(of), of(it.damping))?;
            let wall = wall.at(of(it.position));
            to.render(wall, wall.dissipation())
        }
        Environment::HuntCrossley(it) => {
            let wall = HuntCrossley::new(of(it.stiffness), of(it.exponent), of(it.damping))?;
            let wall = wall.at(of(it.position));
            to.render(wall, wall.dissipation())
        }
        Environment::MovingWall(it) => {
            let wall = Wall::new(of(it.stiffness), of(it.damping))?.at(of(it.position));
            let moving = MovingWall::new(wall, of(it.amplitude), of(it.frequency), slow)?;
            to.render(moving, moving.dissipation(fast)?)
        }
        Environment::VaryingSpring(it) => {
            let spring = Spring::<T>::new(of(it.stiffness))?.at(of(it.position));
            let amplitude = of(it.amplitude);
            to.render(VaryingSpring::new(spring, amplitude, of(it.frequency), slow)?, nothing)
        }
        Environment::Plane(_) | Environment::Sphere(_) | Environment::Cuboid(_) => {
            Err(elsewhere(1))
        }
    }
}

pub(super) fn in_space<T: Scalar + Space, const N: usize, R: Render<SVector<T, N>>>(
    scene: &Scene,
    to: R,
) -> Result<R::Made, ParameterError> {
    type Axes<T, const N: usize> = SVector<T, N>;
    match &scene.environment {
        Environment::Plane(it) => {
            let plane = Plane::new(Axes::<T, N>::at(&it.point), Axes::<T, N>::at(&it.normal))?;
            let contact = Contact::with(plane, of(it.stiffness), of(it.damping))?;
            to.render(contact, contact.dissipation())
        }
        Environment::Sphere(it) => {
            let sphere = Sphere::new(Axes::<T, N>::at(&it.center), of(it.radius))?;
            let contact = Contact::with(sphere, of(it.stiffness), of(it.damping))?;
            to.render(contact, contact.dissipation())
        }
        Environment::Cuboid(it) => {
            let half = Axes::<T, N>::from_fn(|axis, _| {
                it.half.get(axis).map_or(T::zero(), |half| of(*half))
            });
            let cuboid = Cuboid::new(Axes::<T, N>::at(&it.center), half)?;
            let contact = Contact::with(cuboid, of(it.stiffness), of(it.damping))?;
            to.render(contact, contact.dissipation())
        }
        _ => Err(elsewhere(N)),
    }
}

/// A quantity of a scene in the scalar of its loop.
pub(super) fn of<T: Scalar>(quantity: impl Into<f64>) -> T {
    T::of(quantity.into())
}

/// An environment that this space does not have.
fn elsewhere(dimensions: usize) -> ParameterError {
    let requirement = Requirement::InRange;
    ParameterError { parameter: "dimensions", value: dimensions as f64, requirement }
}
