//! Runge-Kutta-Nyström method for equations of motion, order 4.

use lyapunov_core::{Integrator, Mechanics, Scalar, Signal, State};

/// The classical Runge-Kutta method in Nyström's form (Nyström 1925), for `ẍ = a(x, ẋ, f)`:
///
/// ```text
/// a₁ = a(x, v)                     v₂ = v + h/2 a₁
/// a₂ = a(x + h/2 v, v₂)            v₃ = v + h/2 a₂
/// a₃ = a(x + h/2 v₂, v₃)           v₄ = v + h a₃
/// a₄ = a(x + h v₃, v₄)
/// x' = x + h v + h²/6 (a₁ + a₂ + a₃)
/// v' = v + h/6 (a₁ + 2 a₂ + 2 a₃ + a₄)
/// ```
///
/// It is [`RungeKutta4`](crate::RungeKutta4) with the slopes of the positions substituted: the same method in fewer
/// operations, of the same order and stability, differing only by rounding. It keeps nothing exactly: without damping
/// the energy falls, in proportion to `(h ω)⁶ / 72` per step, and beyond `h ω = 2 √2` it grows (Hairer, Nørsett and
/// Wanner, Solving Ordinary Differential Equations I, 1993, II.1 and II.14; Hairer and Wanner, part II, 1996, IV.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RungeKuttaNystrom4;

impl<V: Signal, D: Mechanics<V>> Integrator<V, D> for RungeKuttaNystrom4 {
    #[inline]
    fn step(
        &mut self,
        dynamics: &D,
        State { position, velocity }: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates> {
        let half = interval * V::Scalar::of(0.5);
        let sixth = interval * V::Scalar::of(1.0 / 6.0);
        let at = |position, velocity| dynamics.acceleration(position, velocity, effort);

        let first = at(position, velocity);
        let second_velocity = velocity + first.scale(half);
        let second = at(position + velocity.scale(half), second_velocity);
        let third_velocity = velocity + second.scale(half);
        let third = at(position + second_velocity.scale(half), third_velocity);
        let fourth_velocity = velocity + third.scale(interval);
        let fourth = at(position + third_velocity.scale(interval), fourth_velocity);

        let inner = second + third;
        State {
            position: (velocity + (first + inner).scale(sixth)).scale(interval),
            velocity: (first + inner + inner + fourth).scale(sixth),
        }
    }
}
