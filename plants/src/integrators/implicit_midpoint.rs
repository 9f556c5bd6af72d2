//! Implicit midpoint rule: order 2, symplectic, stable at any step.

use lyapunov_core::{Integrator, Scalar, Signal, State};

use crate::ImplicitMechanics;

/// The implicit midpoint rule: the acceleration over the step is the one in its middle.
///
/// ```text
/// a = acceleration(x + h/2 v + h²/4 a, v + h/2 a, f)
/// x' = x + h (v + h/2 a)
/// v' = v + h a
/// ```
///
/// It has order 2, one evaluation and one division. It keeps every quadratic invariant, so the energy of linear motion
/// without damping stays constant, and it is A-stable: no decaying motion grows, at any step. A motion far faster than
/// the step does not decay either; it alternates (Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006,
/// IV.2; Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, IV.3).
///
/// Where `h ω` is above 1, its rounding error is about `h ω` units in the last place.
///
/// The dynamics solve the equation for `a` ([`ImplicitMechanics`]). The linear ones that ship solve it in closed form:
/// fixed-point iteration would converge only while `h ω < 2`, where the rule is not needed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImplicitMidpoint;

impl<V: Signal, D: ImplicitMechanics<V>> Integrator<V, D> for ImplicitMidpoint {
    #[inline]
    fn step(
        &mut self,
        dynamics: &D,
        State { position, velocity }: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates> {
        let half = interval * V::Scalar::of(0.5);
        let drifted = position + velocity.scale(half);
        let acceleration =
            dynamics.implicit_acceleration(drifted, velocity, effort, half * half, half);
        let middle = velocity + acceleration.scale(half);
        State { position: middle.scale(interval), velocity: acceleration.scale(interval) }
    }
}
