//! Dormand-Prince pair of order 5, with an estimate of order 4.

use lyapunov_core::{Dynamics, Integrator, Signal};

use super::embedded_pair::{Row, stages, summed};
use crate::EmbeddedPair;

/// Dormand and Prince's pair of orders 5 and 4 (Dormand and Prince 1980; Hairer, Nørsett and Wanner, Solving Ordinary
/// Differential Equations I, 1993, II.5, table 5.2).
///
/// By itself it takes steps of the given length, with 6 evaluations each; [`Adaptive`](crate::Adaptive) chooses them,
/// with 7. The last evaluation is not reused in the next step, whose effort is another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DormandPrince5;

const ROWS: [Row; 6] = [
    &[(0, 1.0 / 5.0)],
    &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)],
    &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)],
    &[(0, 19372.0 / 6561.0), (1, -25360.0 / 2187.0), (2, 64448.0 / 6561.0), (3, -212.0 / 729.0)],
    &[
        (0, 9017.0 / 3168.0),
        (1, -355.0 / 33.0),
        (2, 46732.0 / 5247.0),
        (3, 49.0 / 176.0),
        (4, -5103.0 / 18656.0),
    ],
    GAIN,
];

const GAIN: Row = &[
    (0, 35.0 / 384.0),
    (2, 500.0 / 1113.0),
    (3, 125.0 / 192.0),
    (4, -2187.0 / 6784.0),
    (5, 11.0 / 84.0),
];

/// The gain of order 5 less that of order 4.
const ERROR: Row = &[
    (0, 71.0 / 57600.0),
    (2, -71.0 / 16695.0),
    (3, 71.0 / 1920.0),
    (4, -17253.0 / 339200.0),
    (5, 22.0 / 525.0),
    (6, -1.0 / 40.0),
];

impl<U: Signal, D: Dynamics<U>> Integrator<U, D> for DormandPrince5 {
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        let stages: [_; 6] = stages(dynamics, from, input, interval, &ROWS);
        summed(&stages, GAIN, interval)
    }
}

impl<U: Signal, D: Dynamics<U>> EmbeddedPair<U, D> for DormandPrince5 {
    const ESTIMATE: u32 = 5;

    fn attempt(
        &self,
        dynamics: &D,
        from: D::State,
        input: U,
        interval: U::Scalar,
        size: impl Fn(D::State, D::State) -> U::Scalar,
    ) -> (D::State, U::Scalar) {
        let stages: [_; 7] = stages(dynamics, from, input, interval, &ROWS);
        let gain = summed(&stages, GAIN, interval);
        (gain, size(gain, summed(&stages, ERROR, interval)))
    }
}
