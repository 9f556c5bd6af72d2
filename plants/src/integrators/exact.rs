//! The exact solution of linear motion.

use lyapunov_core::{Integrator, Signal, State};

use crate::LinearDynamics;

/// The exact motion of [linear dynamics](LinearDynamics) under a held effort, to rounding: the increments of the matrix
/// exponential ([`held_input`](crate::held_input)).
///
/// They are worked out where dynamics or interval are not those of the step before, and kept. That takes some
/// thousands of operations; a step that finds them kept takes as many multiplications as they have entries.
/// [`Body`](crate::Body) and [`Linked`](crate::Linked) have theirs from construction on.
#[derive(Clone, Copy, Debug)]
pub struct Exact<V: Signal, D: LinearDynamics<V>> {
    kept: Option<(D, V::Scalar, D::Increments)>,
}

impl<V: Signal, D: LinearDynamics<V>> Exact<V, D> {
    /// Exact motion.
    pub const fn new() -> Self {
        Self { kept: None }
    }
}

impl<V: Signal, D: LinearDynamics<V>> Default for Exact<V, D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<V: Signal, D: LinearDynamics<V> + Copy + PartialEq> Integrator<V, D> for Exact<V, D> {
    #[inline]
    fn step(
        &mut self,
        dynamics: &D,
        from: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates> {
        let increments = match &self.kept {
            Some((of, over, kept)) if of == dynamics && *over == interval => *kept,
            _ => {
                let new = dynamics.increments(interval);
                self.kept = Some((*dynamics, interval, new));
                new
            }
        };
        D::gain(&increments, from, effort)
    }
}
