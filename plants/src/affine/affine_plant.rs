//! A control-affine plant behind its port.

use lyapunov_core::{
    HeldTick, Integrator, LyapunovFunction, ParameterError, Plant, PortSample, Requirement, Scalar,
    exact_sums,
};
use nalgebra::SVector;
use num_traits::Zero;

use crate::{ControlAffine, WithFlow, WithState};

/// A [`ControlAffine`] plant, seen from the port at which its input feeds a [`LyapunovFunction`].
///
/// ```text
/// ẋ = f(x) − g(x) e        e the effort, held over the period: the input is u = −e
/// y = L_g V(x)             the flow
/// V̇ = L_f V − e · y        so e · ∫ y dt is what V loses to the effort, on each input exactly
/// ```
///
/// The sample reports `y`, `∫ y dt` over the period and the state ([`WithState`]). Summed by
/// [`PortEnergy`](lyapunov_core::PortEnergy), it gives what the input took from `V`, without the drift; summed by
/// [`decrease_of`](crate::decrease_of), all that `V` lost.
///
/// ```
/// use lyapunov_core::{OnePort, ParameterError, Plant};
/// use lyapunov_plants::{AffinePlant, QuadraticForm, RungeKutta4, StateFeedback, VanDerPol};
/// use nalgebra::{Vector1, Vector2};
/// let circle = QuadraticForm::sum_of_squares();
/// let start = Vector2::new(0.5, 0.0);
/// let mut plant =
///     AffinePlant::new(VanDerPol::new(1.0)?, circle, RungeKutta4, 0.01, 1)?.starting(start);
/// let mut port = StateFeedback::new(|x: Vector2<f64>| Vector1::new(-2.0 * x[1]));
/// let mut sample = plant.start();
/// for _ in 0..1000 {
///     sample = plant.advance(port.respond(&sample));
/// }
/// assert!(plant.state().norm() < 0.01); // the feedback damps more than the oscillator feeds
/// # Ok::<(), ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct AffinePlant<P, F, I, T, const N: usize, const M: usize> {
    dynamics: WithFlow<P, F, N>,
    integrator: I,
    period: T,
    interval: T,
    steps: u32,
    at: WithState<T, N, M>,
    /// The rest of the way that the position has no digits for.
    left: SVector<T, M>,
}

impl<P, F, I, T, const N: usize, const M: usize> AffinePlant<P, F, I, T, N, M>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>>,
    I: Integrator<SVector<T, M>, WithFlow<P, F, N>>,
{
    /// `plant` at rest, moved by `period` s at a time in `steps` steps.
    ///
    /// # Errors
    /// `period` not above 0 and finite; `steps` 0.
    pub fn new(
        plant: P,
        function: F,
        integrator: I,
        period: T,
        steps: u32,
    ) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        Requirement::AtLeast(1.0).check("steps", f64::from(steps))?;
        let interval = period / T::of(f64::from(steps));
        let dynamics = WithFlow { plant, function };
        Ok(Self {
            dynamics,
            integrator,
            period,
            interval,
            steps,
            at: WithState::zero(),
            left: SVector::zeros(),
        })
    }

    /// The same plant in `state`.
    #[must_use]
    pub fn starting(self, state: SVector<T, N>) -> Self {
        let none = SVector::zeros();
        Self { at: WithState { input: none, state }, left: none, ..self }
    }

    /// The state `x`.
    #[inline]
    pub fn state(&self) -> SVector<T, N> {
        self.at.state
    }

    /// The value `V(x)` of the function.
    #[inline]
    pub fn value(&self) -> T {
        self.dynamics.function.value(self.at.state)
    }

    #[inline]
    fn flow(&self) -> WithState<T, N, M> {
        let WithFlow { plant, function } = &self.dynamics;
        WithState::of_input(plant.flow(function, self.at.state))
    }
}

impl<P, F, I, T, const N: usize, const M: usize> Plant<WithState<T, N, M>>
    for AffinePlant<P, F, I, T, N, M>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>>,
    I: Integrator<SVector<T, M>, WithFlow<P, F, N>>,
{
    #[inline]
    fn start(&self) -> PortSample<WithState<T, N, M>> {
        PortSample::starting(self.period, self.at, self.flow())
    }

    #[inline]
    fn advance(&mut self, effort: WithState<T, N, M>) -> PortSample<WithState<T, N, M>> {
        let before = self.at;
        // Apart: each gain of many short steps would be rounded to the size of the state.
        let mut gained = WithState::zero();
        for _ in 0..self.steps {
            let at = before + gained;
            let gain = self.integrator.step(&self.dynamics, at, effort.input, self.interval);
            gained = gained + gain;
        }
        let (input, left) = exact_sums(before.input, gained.input + self.left);
        (self.at, self.left) = (WithState { input, state: before.state + gained.state }, left);
        HeldTick {
            period: self.period,
            position: self.at,
            velocity: self.flow(),
            displacement: WithState { state: self.at.state - before.state, ..gained },
            applied: effort,
        }
        .sample()
    }
}
