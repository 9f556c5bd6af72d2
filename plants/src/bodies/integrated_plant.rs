//! Plant moved by an integrator.

use core::fmt::Debug;

use lyapunov_core::{
    HeldTick, Integrator, Mechanics, ParameterError, Plant, PortSample, Requirement, Scalar,
    Signal, State,
};

use crate::{Coordinates, FromParts, OperatedBody};

/// A plant that an [`Integrator`] moves along its [`Mechanics`], by equal steps over each period under the held effort.
///
/// The origin of the coordinates is the rest. The sample reports the port's displacement as the exact difference of two
/// positions, as [`Body`](crate::Body) does. The gains of a period's steps are summed apart and added to the state once, and no
/// time is summed.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{ParameterError, Plant};
/// use lyapunov_plants::{Impedance, Oscillator, RungeKuttaNystrom4, IntegratedPlant};
/// let hand = Oscillator::new(Impedance { mass: 0.3, damping: 0.2, stiffness: 50.0 })?;
/// let mut plant = IntegratedPlant::new(hand, RungeKuttaNystrom4, 1e-3, 4)?.starting(-0.004_f64, 0.0);
/// let sample = plant.advance(0.0);
/// // Over so short a time it falls freely: x₀ (1 − k T² / (2 m)).
/// assert_abs_diff_eq!(sample.position, -0.004 * (1.0 - 50.0 * 1e-6 / 0.6), epsilon = 1e-9);
/// # Ok::<(), ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct IntegratedPlant<V: Signal, D: Mechanics<V>, I> {
    dynamics: D,
    integrator: I,
    period: V::Scalar,
    interval: V::Scalar,
    steps: u32,
    rest: V,
    state: State<D::Coordinates>,
}

impl<V, D, I> IntegratedPlant<V, D, I>
where
    V: Signal,
    D: Mechanics<V, Coordinates: Coordinates<V>>,
    I: Integrator<V, D>,
{
    /// A plant at rest at the origin, moved by `period` s at a time in `steps` steps.
    ///
    /// The constructor tries one step from a state of ones, so the integrator's cache is ready before the first period.
    ///
    /// # Errors
    /// `period` not above 0 and finite; `steps` 0; a `period` over whose step the motion is out of the scalar's
    /// range.
    pub fn new(
        dynamics: D,
        mut integrator: I,
        period: V::Scalar,
        steps: u32,
    ) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        Requirement::AtLeast(1.0).check("steps", f64::from(steps))?;
        let interval = step_of(period, steps);
        tried(&dynamics, &mut integrator, period, interval)?;
        let (rest, state) = (V::zero(), State::splat(V::Scalar::of(0.0)));
        Ok(Self { dynamics, integrator, period, interval, steps, rest, state })
    }

    /// The same plant with the origin of its coordinates, and so the rest of its spring, at `rest`, m.
    #[must_use]
    pub fn resting_at(self, rest: V) -> Self {
        Self { rest, ..self }
    }

    /// The same plant with everything at `position` m, moving at `velocity` m/s.
    #[must_use]
    pub fn starting(self, position: V, velocity: V) -> Self {
        let position = D::Coordinates::all_at(position);
        self.starting_from(State { position, velocity: D::Coordinates::all_at(velocity) })
    }

    /// The same plant in `state`, in absolute positions, not relative to the rest.
    #[must_use]
    pub fn starting_from(self, state: State<D::Coordinates>) -> Self {
        Self { state, ..self }
    }

    /// The state, in absolute positions.
    #[inline]
    pub fn state(&self) -> State<D::Coordinates> {
        self.state
    }
}

fn step_of<T: Scalar>(period: T, steps: u32) -> T {
    period / T::of(f64::from(steps))
}

/// Tries one step.
fn tried<V: Signal, D: Mechanics<V>>(
    dynamics: &D,
    integrator: &mut impl Integrator<V, D>,
    period: V::Scalar,
    interval: V::Scalar,
) -> Result<(), ParameterError> {
    let one = V::Scalar::of(1.0);
    let gain = integrator.step(dynamics, State::splat(one), V::splat(one), interval);
    Requirement::InRange.require("period", period, gain.finite())
}

impl<V, D, I> Plant<V> for IntegratedPlant<V, D, I>
where
    V: Signal,
    D: Mechanics<V, Coordinates: Coordinates<V>>,
    I: Integrator<V, D>,
{
    #[inline]
    fn start(&self) -> PortSample<V> {
        let State { position, velocity } = self.state;
        PortSample::starting(self.period, position.at_port(), velocity.at_port())
    }

    #[inline]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let before = self.state.position.at_port();
        let origin = D::Coordinates::all_at(self.rest);
        // Apart: each gain of many short steps would be rounded to the size of the state.
        let (start, mut gained) = (self.state, State::splat(V::Scalar::of(0.0)));
        for _ in 0..self.steps {
            let State { position, velocity } = start + gained;
            let from = State { position: position - origin, velocity };
            gained = gained + self.integrator.step(&self.dynamics, from, effort, self.interval);
        }
        self.state = start + gained;
        let (position, velocity) = (self.state.position.at_port(), self.state.velocity.at_port());
        HeldTick {
            period: self.period,
            position,
            velocity,
            displacement: position - before,
            applied: effort,
        }
        .sample()
    }
}

impl<V, D, I> OperatedBody<V> for IntegratedPlant<V, D, I>
where
    V: Signal,
    D: Mechanics<V, Coordinates: Coordinates<V>> + FromParts,
    I: Integrator<V, D> + Copy,
{
    type Parts = D::Parts;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.rest = rest;
    }

    fn reshape(&mut self, parts: D::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        let period = Requirement::NonNegative.check("period", interval)?;
        let (dynamics, mut integrator) = (self.dynamics.made_of(parts)?, self.integrator);
        let interval = step_of(period, self.steps);
        tried(&dynamics, &mut integrator, period, interval)?;
        (self.dynamics, self.integrator) = (dynamics, integrator);
        (self.period, self.interval) = (period, interval);
        Ok(())
    }
}
