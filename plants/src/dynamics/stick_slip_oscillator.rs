//! One mass under dry friction.

use lyapunov_core::{Mechanics, ParameterError, Scalar, State};

use crate::{FromParts, Impedance, ImplicitMechanics, Oscillator, Stribeck, Switching};

/// Newton's iterations for the friction at the end of an implicit step.
const ITERATIONS: usize = 8;

/// An [`Oscillator`] under [`Stribeck`] friction: `m ẍ = g − F(|ẋ|) sgn ẋ` while it slides, with `g` all other forces,
/// and at rest as long as `|g| ≤ static`.
///
/// It is the counterpart, on one mass and for integrators, of [`Friction`](crate::Friction) for exact bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StickSlipOscillator<T> {
    oscillator: Oscillator<T>,
    law: Stribeck<T>,
}

/// An oscillator that slides one way under friction, or sticks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StickSlipPhase<T> {
    oscillator: Oscillator<T>,
    law: Stribeck<T>,
    /// The direction in which it slides, ±1; 0 where it sticks.
    sense: T,
}

impl<T: Scalar> StickSlipOscillator<T> {
    /// The oscillator made of `parts` under friction of `law`.
    ///
    /// # Errors
    /// Those of [`Oscillator::new`] and [`Friction::new`](crate::Friction::new).
    pub fn new(parts: Impedance<T>, law: Stribeck<T>) -> Result<Self, ParameterError> {
        Ok(Self { oscillator: Oscillator::new(parts)?, law: law.checked()? })
    }

    /// The direction in which it leaves rest at `position`; 0 where friction holds it.
    fn leaving(&self, position: T, effort: T) -> T {
        let force = self.oscillator.force_at_rest(position, effort);
        let held = !force.magnitude().above(self.law.breakaway);
        T::choose(held, T::of(0.0), sign(force))
    }

    fn sliding(&self, sense: T) -> StickSlipPhase<T> {
        StickSlipPhase { oscillator: self.oscillator, law: self.law, sense }
    }
}

/// 1, −1, or 0 for 0.
fn sign<T: Scalar>(value: T) -> T {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    T::choose(value.above(zero), one, T::choose(value.below(zero), -one, zero))
}

impl<T: Scalar> FromParts for StickSlipOscillator<T> {
    type Parts = Impedance<T>;

    fn made_of(&self, parts: Impedance<T>) -> Result<Self, ParameterError> {
        Self::new(parts, self.law)
    }
}

impl<T: Scalar> Mechanics<T> for StickSlipOscillator<T> {
    type Coordinates = T;

    #[inline]
    fn acceleration(&self, position: T, velocity: T, effort: T) -> T {
        self.phase(State { position, velocity }, effort).acceleration(position, velocity, effort)
    }
}

impl<T: Scalar> StickSlipPhase<T> {
    #[inline]
    fn unless_stuck(&self, acceleration: T) -> T {
        let zero = T::of(0.0);
        T::choose(self.sense.magnitude().above(zero), acceleration, zero)
    }
}

impl<T: Scalar> Mechanics<T> for StickSlipPhase<T> {
    type Coordinates = T;

    /// Friction is even in the velocity, and so is its continuation beyond the end of sliding.
    #[inline]
    fn acceleration(&self, position: T, velocity: T, effort: T) -> T {
        let friction = self.sense * self.law.force(velocity);
        self.unless_stuck(self.oscillator.acceleration(position, velocity, effort + friction))
    }
}

impl<T: Scalar> ImplicitMechanics<T> for StickSlipPhase<T> {
    /// Uses a fixed count of Newton's iterations for `a`, with the friction at `v + β a`; the first guess is already
    /// exact where friction does not depend on the speed.
    fn implicit_acceleration(&self, position: T, velocity: T, effort: T, alpha: T, beta: T) -> T {
        let one = T::of(1.0);
        let under = |friction: T| {
            let effort = effort + self.sense * friction;
            self.oscillator.implicit_acceleration(position, velocity, effort, alpha, beta)
        };
        let mobility = self.oscillator.mobility(alpha, beta);
        let mut acceleration = under(self.law.force(velocity));
        for _ in 0..ITERATIONS {
            let reached = velocity + beta * acceleration;
            let missed = acceleration - under(self.law.force(reached));
            let slope = one + self.sense * mobility * beta * self.law.slope(reached);
            // Where friction falls faster than the step resolves, a slope of 1/2 keeps the iteration on its way.
            acceleration -= missed / slope.larger(T::of(0.5));
        }
        self.unless_stuck(acceleration)
    }
}

impl<T: Scalar> Switching<T> for StickSlipOscillator<T> {
    type Phase = StickSlipPhase<T>;

    fn phase(&self, state: State<T>, effort: T) -> StickSlipPhase<T> {
        let moving = state.velocity.magnitude().above(T::of(0.0));
        let leaving = self.leaving(state.position, effort);
        self.sliding(T::choose(moving, sign(state.velocity), leaving))
    }

    fn reserve(&self, phase: &StickSlipPhase<T>, state: State<T>) -> T {
        state.velocity * phase.sense
    }

    /// Stops the motion and continues from rest. A motion that would go on in its old direction left rest by rounding
    /// only: it sticks.
    fn switched(
        &self,
        phase: &StickSlipPhase<T>,
        state: State<T>,
        effort: T,
    ) -> (StickSlipPhase<T>, State<T>) {
        let leaving = self.leaving(state.position, effort);
        let reversed = (leaving * phase.sense).below(T::of(0.0));
        let next = self.sliding(T::choose(reversed, leaving, T::of(0.0)));
        (next, State { position: T::of(0.0), velocity: -state.velocity })
    }

    fn chosen(mask: T::Mask, yes: StickSlipPhase<T>, no: StickSlipPhase<T>) -> StickSlipPhase<T> {
        StickSlipPhase { sense: T::choose(mask, yes.sense, no.sense), ..no }
    }
}
