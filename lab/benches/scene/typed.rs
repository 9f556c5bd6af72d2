//! The loops of the benchmark composed by type.

use lyapunov::{
    DampingLimit, OnePort, ParameterError, Plant, Popc, PortEnergy, Scalar,
    bodies::{Body, Impedance, PlantExt},
    effects::{Fallback, OnePortExt},
    environments::Wall,
    trajectories::{Constant, Pulse, Step},
};

const RATE: f64 = 1000.0;

fn parts<T: Scalar>(stiffness: f64, damping: f64) -> Impedance<T> {
    Impedance {
        mass: T::of(0.1 + 0.2),
        damping: T::of(damping + 0.001),
        stiffness: T::of(stiffness),
    }
}

fn body<T: Scalar>() -> Result<Body<T>, ParameterError> {
    let body = Body::new(parts(50.0, 0.2), T::of(1.0 / RATE))?;
    Ok(body.starting(T::of(-0.004), T::of(0.0)))
}

fn pushed<T: Scalar>(body: impl Plant<T>) -> Result<impl Plant<T>, ParameterError> {
    Ok(body.pushed(Constant::new(0.2)?).pushed(Pulse::new(1.0, 0.1, 0.1, RATE)?))
}

fn wall<T: Scalar>() -> Result<Wall<T>, ParameterError> {
    Wall::new(T::of(2000.0), T::of(1.0))
}

fn popc<T: Scalar>() -> Result<Popc<T>, ParameterError> {
    let limit = DampingLimit::of_mass(T::of(0.5), T::of(0.1 + 0.2), T::of(1.0 / RATE))?;
    Ok(Popc::new(PortEnergy, limit))
}

pub(crate) fn bare<T: Scalar>() -> Result<(impl Plant<T>, impl OnePort<T>), ParameterError> {
    Ok((body()?, wall()?.held(10)?.stabilized(popc()?).differenced()))
}

pub(crate) fn two<T: Scalar>() -> Result<(impl Plant<T>, impl OnePort<T>), ParameterError> {
    let port = wall()?.held(10)?.stabilized(popc()?).delayed::<4>(2)?;
    Ok((body()?, port.differenced().encoded(T::of(1e-5))?))
}

/// Effects that the larger sets have around the environment.
fn around<T: Scalar>(environment: impl OnePort<T>) -> Result<impl OnePort<T>, ParameterError> {
    let port = environment.held(10)?.stabilized(popc()?);
    let port = port.saturated(T::of(8.0))?.delayed::<4>(2)?;
    port.low_passed(T::of(200.0))?.encoded(T::of(1e-5))
}

pub(crate) fn four<T: Scalar>() -> Result<(impl Plant<T>, impl OnePort<T>), ParameterError> {
    Ok((body()?, around(wall()?)?))
}

pub(crate) fn eight<T: Scalar>() -> Result<(impl Plant<T>, impl OnePort<T>), ParameterError> {
    let led = body()?.led_by(Step::new(0.0, 0.001, 0.3, RATE)?);
    let gripped = led.gripped(parts(50.0, 0.2), [(500, parts(100.0, 0.4))])?;
    Ok((pushed(gripped)?, around(wall()?)?))
}

pub(crate) fn random<T: Scalar>() -> Result<(impl Plant<T>, impl OnePort<T>), ParameterError> {
    let environment = wall()?.dropped(T::of(0.1), Fallback::Hold, |_| 7)?;
    Ok((pushed(body()?)?, around(environment)?.noisy(T::of(2e-6), |_| 7)?))
}
