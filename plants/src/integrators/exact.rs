//! Exact solution of linear equations.

use lyapunov_core::{Integrator, Signal};

use crate::LinearDynamics;

/// The exact solution of [linear dynamics](LinearDynamics) under a held input, to rounding: the increments of the matrix
/// exponential ([`held_input`](crate::held_input)).
///
/// The increments are computed when dynamics or interval differ from those of the step before, and kept. That takes
/// some thousands of operations; a step with kept increments takes as many multiplications as they have entries.
/// [`Body`](crate::Body) and [`TwoMassBody`](crate::TwoMassBody) compute theirs at construction.
#[derive(Clone, Copy, Debug)]
pub struct Exact<U: Signal, D: LinearDynamics<U>> {
    kept: Option<(D, U::Scalar, D::Increments)>,
}

impl<U: Signal, D: LinearDynamics<U>> Exact<U, D> {
    /// The exact solution.
    pub const fn new() -> Self {
        Self { kept: None }
    }
}

impl<U: Signal, D: LinearDynamics<U>> Default for Exact<U, D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<U: Signal, D: LinearDynamics<U> + Copy + PartialEq> Integrator<U, D> for Exact<U, D> {
    #[inline]
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        let increments = match &self.kept {
            Some((of, over, kept)) if of == dynamics && *over == interval => *kept,
            _ => {
                let new = dynamics.increments(interval);
                self.kept = Some((*dynamics, interval, new));
                new
            }
        };
        D::gain(&increments, from, input)
    }
}
