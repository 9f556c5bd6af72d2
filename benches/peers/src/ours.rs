//! Rows of this library: plants and ports composed by type.

use lyapunov::{
    OnePort, ParameterError, Plant,
    bodies::{Body, Impedance, IntegratedPlant},
    environments::Wall,
    integrators::{Oscillator, RungeKuttaNystrom4},
};

use crate::scene::{
    DAMPING, MASS, PERIOD, Positions, START, STIFFNESS, WALL_DAMPING, WALL_STIFFNESS,
};

const HAND: Impedance<f64> = Impedance { mass: MASS, damping: DAMPING, stiffness: STIFFNESS };

#[inline(always)]
fn rollout(positions: &mut Positions, mut plant: impl Plant<f64>) -> Result<(), ParameterError> {
    let mut port = Wall::new(WALL_STIFFNESS, WALL_DAMPING)?;
    let mut sample = plant.start();
    positions[0] = sample.position;
    for at in &mut positions[1..] {
        sample = plant.advance(port.respond(&sample));
        *at = sample.position;
    }
    Ok(())
}

/// Exact propagation by the map over a period, which every run computes anew.
#[inline(never)]
pub(crate) fn exact(positions: &mut Positions) -> Result<(), ParameterError> {
    rollout(positions, Body::new(HAND, PERIOD)?.starting(START, 0.0))
}

/// Classical method of order 4, generic over dynamics, port and scalar.
#[inline(never)]
pub(crate) fn runge_kutta_4(positions: &mut Positions, steps: u32) -> Result<(), ParameterError> {
    let hand = Oscillator::new(HAND)?;
    rollout(
        positions,
        IntegratedPlant::new(hand, RungeKuttaNystrom4, PERIOD, steps)?.starting(START, 0.0),
    )
}
