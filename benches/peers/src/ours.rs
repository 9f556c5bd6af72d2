//! This library: plants and ports composed by type.

use lyapunov::{
    Body, Impedance, OnePort, Oscillator, ParameterError, Plant, RungeKuttaNystrom4, Stepped, Wall,
};

use crate::scene::{
    DAMPING, MASS, PERIOD, Positions, START, STIFFNESS, WALL_DAMPING, WALL_STIFFNESS,
};

const HAND: Impedance<f64> = Impedance { mass: MASS, damping: DAMPING, stiffness: STIFFNESS };

#[inline(always)]
fn rollout(positions: &mut Positions, mut plant: impl Plant<f64>) -> Result<(), ParameterError> {
    let mut port = Wall::new(WALL_STIFFNESS, WALL_DAMPING)?;
    let mut drive = plant.start();
    positions[0] = drive.position;
    for at in &mut positions[1..] {
        drive = plant.advance(port.respond(&drive));
        *at = drive.position;
    }
    Ok(())
}

/// Exact, by the map over a period, which is worked out in every run.
#[inline(never)]
pub(crate) fn exact(positions: &mut Positions) -> Result<(), ParameterError> {
    rollout(positions, Body::new(HAND, PERIOD)?.starting(START, 0.0))
}

/// The classical method of order 4, generic over dynamics, port and scalar.
#[inline(never)]
pub(crate) fn runge_kutta_4(positions: &mut Positions, steps: u32) -> Result<(), ParameterError> {
    let hand = Oscillator::new(HAND)?;
    rollout(positions, Stepped::new(hand, RungeKuttaNystrom4, PERIOD, steps)?.starting(START, 0.0))
}
