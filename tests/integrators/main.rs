//! Integrators: their orders, what they conserve, and the plant that each of them moves.

mod adaptive;
mod energy;
mod exact;
mod first_order;
mod lanes;
mod law;
mod located;
mod orders;
mod plant;

use lyapunov::{
    Scalar, Signal,
    bodies::{DampedMass, ElasticJoint, Impedance, IntegratedPlant, TwoMassParts},
    integrators::{Coordinates, Integrator, Mechanics},
};

/// Half a unit in the last place of one.
const U: f64 = f64::EPSILON / 2.0;

fn hand<T: Scalar>() -> Impedance<T> {
    Impedance { mass: T::of(0.3), damping: T::of(0.6), stiffness: T::of(50.0) }
}

fn pair<T: Scalar>() -> TwoMassParts<T> {
    TwoMassParts {
        operator: Impedance { mass: T::of(0.1), damping: T::of(0.2), stiffness: T::of(50.0) },
        device: DampedMass { mass: T::of(0.2), damping: T::of(0.1) },
        link: ElasticJoint { stiffness: T::of(30.0), damping: T::of(0.3) },
    }
}

fn moved<V, D, I>(
    dynamics: D,
    integrator: I,
    period: V::Scalar,
    steps: u32,
) -> IntegratedPlant<V, D, I>
where
    V: Signal,
    D: Mechanics<V, Coordinates: Coordinates<V>>,
    I: Integrator<V, D>,
{
    IntegratedPlant::new(dynamics, integrator, period, steps).expect("a plant")
}
