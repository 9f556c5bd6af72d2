//! Rows of this library: plants and ports composed by type.

use lyapunov::{
    OnePort, ParameterError, Plant, Scalar,
    bodies::{Body, Impedance, IntegratedPlant},
    environments::Wall,
    integrators::{Oscillator, RungeKuttaNystrom4},
    lanes::AutoF64x8,
};
use pulp::{Arch, NullaryFnOnce};

use crate::scene::{
    DAMPING, MASS, PERIOD, PERIODS, Positions, START, STIFFNESS, WALL_DAMPING, WALL_STIFFNESS,
};

/// The hand, alike in all lanes.
fn hand<T: Scalar>() -> Impedance<T> {
    let [mass, damping, stiffness] = [MASS, DAMPING, STIFFNESS].map(T::of);
    Impedance { mass, damping, stiffness }
}

#[inline(always)]
fn rollout<T: Scalar>(
    positions: &mut [T; PERIODS + 1],
    mut plant: impl Plant<T>,
) -> Result<(), ParameterError> {
    let mut port = Wall::new(T::of(WALL_STIFFNESS), T::of(WALL_DAMPING))?;
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
    rollout(positions, Body::new(hand(), PERIOD)?.starting(START, 0.0))
}

/// Rollouts side by side in [`exact_on_lanes`].
pub(crate) const LANES: u32 = AutoF64x8::LANES as u32;

/// The same rollout in each of eight lanes, every one with a map of its own and its positions kept, on the best instructions that the
/// processor has; `positions` are the last lane's.
#[inline(never)]
pub(crate) fn exact_on_lanes(positions: &mut Positions) -> Result<(), ParameterError> {
    Arch::new().dispatch(SideBySide { positions })
}

struct SideBySide<'a> {
    positions: &'a mut Positions,
}

impl NullaryFnOnce for SideBySide<'_> {
    type Output = Result<(), ParameterError>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let [start, none, period] = [START, 0.0, PERIOD].map(AutoF64x8::of);
        let mut kept = [none; PERIODS + 1];
        rollout(&mut kept, Body::new(hand(), period)?.starting(start, none))?;
        for (at, kept) in self.positions.iter_mut().zip(&kept) {
            *at = kept.lane(AutoF64x8::LANES - 1);
        }
        Ok(())
    }
}

/// Classical method of order 4, generic over dynamics, port and scalar.
#[inline(never)]
pub(crate) fn runge_kutta_4(positions: &mut Positions, steps: u32) -> Result<(), ParameterError> {
    let hand = Oscillator::new(hand())?;
    rollout(
        positions,
        IntegratedPlant::new(hand, RungeKuttaNystrom4, PERIOD, steps)?.starting(START, 0.0),
    )
}
