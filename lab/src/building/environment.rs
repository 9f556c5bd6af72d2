//! What the device of a scene touches, and what of it a candidate may credit.

use std::fmt;

use lyapunov::{
    Contact, Cuboid, Dissipation, Drive, HuntCrossley, Impedance, LayeredWall, LyapunovCandidate,
    MassSpringDamper, MovingWall, OnePort, ParameterError, Plane, Requirement, Scalar, Signal,
    Sphere, Spring, VaryingSpring, Wall,
};
use nalgebra::SVector;

use super::{Port, Space};
use crate::scene::{Environment, Scene};

/// Any term of a candidate, boxed.
pub struct AnyTerm<V: Signal>(Box<dyn LyapunovCandidate<V>>);

impl<V: Signal> AnyTerm<V> {
    fn new(term: impl LyapunovCandidate<V> + 'static) -> Self {
        Self(Box::new(term))
    }

    fn nothing() -> Result<Self, ParameterError> {
        Ok(Self::new(Dissipation::of(V::Scalar::of(0.0))?))
    }
}

impl<V: Signal> fmt::Debug for AnyTerm<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyTerm").finish_non_exhaustive()
    }
}

impl<V: Signal> LyapunovCandidate<V> for AnyTerm<V> {
    fn decrease(&mut self, drive: &Drive<V>) -> V::Scalar {
        self.0.decrease(drive)
    }
}

/// An environment and the term of its own damper, which sees the port at `rate` Hz.
struct Rendered<V: Signal> {
    port: Port<V>,
    credit: AnyTerm<V>,
}

impl<V: Signal> Rendered<V> {
    fn new(
        port: impl OnePort<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self, ParameterError> {
        Ok(Self { port: Port::new(port), credit: AnyTerm::new(credit) })
    }

    fn without_damper(port: impl OnePort<V> + 'static) -> Result<Self, ParameterError> {
        Ok(Self { port: Port::new(port), credit: AnyTerm::nothing()? })
    }
}

pub(super) fn on_a_line<T: Scalar>(scene: &Scene) -> Result<Port<T>, ParameterError> {
    Ok(line(scene)?.port)
}

pub(super) fn credit_on_a_line<T: Scalar>(scene: &Scene) -> Result<AnyTerm<T>, ParameterError> {
    Ok(line(scene)?.credit)
}

pub(super) fn in_space<T: Scalar + Send, const N: usize>(
    scene: &Scene,
) -> Result<Port<SVector<T, N>>, ParameterError> {
    Ok(solid(scene)?.port)
}

pub(super) fn credit_in_space<T: Scalar + Send, const N: usize>(
    scene: &Scene,
) -> Result<AnyTerm<SVector<T, N>>, ParameterError> {
    Ok(solid(scene)?.credit)
}

fn line<T: Scalar>(scene: &Scene) -> Result<Rendered<T>, ParameterError> {
    // Environments tick at their own rate, what is credited at the servo's. The one is taken from the other, because a
    // scene's two rates divide each other but for a billionth, which would add up.
    let rate = scene.servo_rate.get();
    let (slow, fast) = (T::of(rate / scene.environment_ratio() as f64), T::of(rate));
    match &scene.environment {
        Environment::Wall(it) => {
            let wall = Wall::new(of(it.stiffness), of(it.damping))?.at(of(it.position));
            Rendered::new(wall, wall.dissipation())
        }
        Environment::Spring(it) => {
            Rendered::without_damper(Spring::<T>::new(of(it.stiffness))?.at(of(it.position)))
        }
        Environment::MassSpringDamper(it) => {
            let impedance = Impedance {
                mass: of(it.mass),
                damping: of(it.damping),
                stiffness: of(it.stiffness),
            };
            let body = MassSpringDamper::<T>::new(impedance)?.at(of(it.position));
            Rendered::new(body, body.dissipation())
        }
        Environment::LayeredWall(it) => {
            let wall = LayeredWall::new(of(it.depth), it.stiffness.map(of), of(it.damping))?;
            let wall = wall.at(of(it.position));
            Rendered::new(wall, wall.dissipation())
        }
        Environment::HuntCrossley(it) => {
            let wall = HuntCrossley::new(of(it.stiffness), of(it.exponent), of(it.damping))?;
            let wall = wall.at(of(it.position));
            Rendered::new(wall, wall.dissipation())
        }
        Environment::MovingWall(it) => {
            let wall = Wall::new(of(it.stiffness), of(it.damping))?.at(of(it.position));
            let moving = MovingWall::new(wall, of(it.amplitude), of(it.frequency), slow)?;
            Rendered::new(moving, moving.dissipation(fast)?)
        }
        Environment::VaryingSpring(it) => {
            let spring = Spring::<T>::new(of(it.stiffness))?.at(of(it.position));
            let amplitude = of(it.amplitude);
            Rendered::without_damper(VaryingSpring::new(spring, amplitude, of(it.frequency), slow)?)
        }
        Environment::Plane(_) | Environment::Sphere(_) | Environment::Cuboid(_) => {
            Err(elsewhere(1))
        }
    }
}

fn solid<T: Scalar + Send, const N: usize>(
    scene: &Scene,
) -> Result<Rendered<SVector<T, N>>, ParameterError> {
    type Axes<T, const N: usize> = SVector<T, N>;
    match &scene.environment {
        Environment::Plane(it) => {
            let plane = Plane::new(Axes::<T, N>::at(&it.point), Axes::<T, N>::at(&it.normal))?;
            let contact = Contact::with(plane, of(it.stiffness), of(it.damping))?;
            Rendered::new(contact, contact.dissipation())
        }
        Environment::Sphere(it) => {
            let sphere = Sphere::new(Axes::<T, N>::at(&it.center), of(it.radius))?;
            let contact = Contact::with(sphere, of(it.stiffness), of(it.damping))?;
            Rendered::new(contact, contact.dissipation())
        }
        Environment::Cuboid(it) => {
            let half = Axes::<T, N>::from_fn(|axis, _| {
                it.half.get(axis).map_or(T::zero(), |half| of(*half))
            });
            let cuboid = Cuboid::new(Axes::<T, N>::at(&it.center), half)?;
            let contact = Contact::with(cuboid, of(it.stiffness), of(it.damping))?;
            Rendered::new(contact, contact.dissipation())
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
