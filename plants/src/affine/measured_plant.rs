//! Port of a real plant, from measurements of its state.

use lyapunov_core::{
    EffortRange, LyapunovFunction, ParameterError, PortSample, Requirement, Scalar, Signal,
    careful, exact_sums,
};
use nalgebra::SVector;

use crate::{ControlAffine, WithState};

/// The samples of a plant that is measured rather than simulated: for a stabilizer in your own loop.
///
/// Only `g` of the model is used, for the flow `y = L_g V(x)`. The trapezoidal rule integrates the flow,
/// `∫ y dt ≈ T/2 (y(n−1) + y(n))`, with an error of `T³ ÿ / 12` at most. This matters only to
/// [`PortEnergy`](lyapunov_core::PortEnergy); [`decrease_of`](crate::decrease_of) needs no integral.
///
/// A state or an input that is not finite goes into its sample as it is, with a work of NaN, for the stabilizer to reject
/// and to book nothing. The next sound one spans the gap: its work is `−u ∫ y dt` if one input was held, and with several
/// the least of that over all of them, input by input. That is a lower bound where the flow did not turn round within the
/// gap, up to the error of the rule over the whole of it. An input that is not finite counts as one of those before it. Its
/// velocity is, input by input, the smaller in magnitude of the flow and the mean `∫ y dt / t` over the gap, and 0 where their
/// directions differ, so that no damper is credited with more than the mean dissipated. Where the state at the start is not
/// finite, the first sound sample starts anew, without displacement and work and over one period.
///
/// ```
/// use lyapunov_core::ParameterError;
/// use lyapunov_plants::{MeasuredPlant, QuadraticForm, VanDerPol};
/// use nalgebra::{Vector1, Vector2};
/// let circle = QuadraticForm::sum_of_squares();
/// let mut port = MeasuredPlant::new(VanDerPol::new(1.0)?, circle, 0.01, Vector2::new(0.5, 0.0))?;
/// let first = port.start();
/// // On the next tick: the state measured, and the input that really applied since the last one.
/// let sample = port.tell(Vector2::new(0.5, -0.005), Vector1::new(0.0));
/// assert_eq!(sample.velocity.input[0], -0.005);
/// # Ok::<(), ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPlant<P, F, T, const N: usize, const M: usize> {
    plant: P,
    function: F,
    period: T,
    /// Time since the last sound sample, s.
    gap: T,
    at: WithState<T, N, M>,
    /// The rest of the way that the position has no digits for.
    left: SVector<T, M>,
    flow: SVector<T, M>,
    /// The range of the efforts since then.
    efforts: EffortRange<SVector<T, M>>,
}

impl<P, F, T, const N: usize, const M: usize> MeasuredPlant<P, F, T, N, M>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>>,
{
    /// A plant first measured in `state`, then every `period` s.
    ///
    /// # Errors
    /// `period` not above 0 and finite.
    pub fn new(
        plant: P,
        function: F,
        period: T,
        state: SVector<T, N>,
    ) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        let flow = plant.flow(&function, state);
        let none = SVector::zeros();
        let at = WithState { input: none, state };
        let efforts = EffortRange::of(none);
        Ok(Self { plant, function, period, gap: T::of(0.0), at, left: none, flow, efforts })
    }

    /// The sample of the first tick.
    #[inline]
    pub fn start(&self) -> PortSample<WithState<T, N, M>> {
        PortSample::starting(self.period, self.at, WithState::of_input(self.flow))
    }

    /// The sample of a tick on which `state` is measured, after a period in which `input` applied.
    #[inline]
    pub fn tell(
        &mut self,
        state: SVector<T, N>,
        input: SVector<T, M>,
    ) -> PortSample<WithState<T, N, M>> {
        let known = self.at.finite() & self.flow.finite();
        let before = WithState { state: Signal::choose(known, self.at.state, state), ..self.at };
        let flow = self.plant.flow(&self.function, state);
        let gap = self.gap + self.period;
        let integral = (self.flow + flow).scale(T::of(0.5) * gap);
        let integral = Signal::choose(known, integral, SVector::zeros());
        let (sum, left) = exact_sums(before.input, integral + self.left);
        let at = WithState { input: sum, state };
        let sound = at.finite() & flow.finite() & input.finite();
        let efforts = self.efforts_with(-input);
        let mean = flow.zip(integral, |flow, moved| careful(flow, moved / gap));
        let late = sound & self.gap.above(T::of(0.0));
        let velocity = Signal::choose(late, mean, flow);
        let work = efforts.least_work(integral);
        self.at = WithState::choose(sound, at, self.at);
        self.left = Signal::choose(sound, left, self.left);
        self.flow = Signal::choose(sound, flow, self.flow);
        self.gap = T::choose(sound | !known, T::of(0.0), gap);
        self.efforts = efforts;
        PortSample {
            period: T::choose(sound, gap, self.period),
            position: at,
            velocity: WithState::of_input(velocity),
            displacement: WithState { input: integral, state: state - before.state },
            applied: WithState::of_input(-input),
            work: WithState::choose(
                sound,
                WithState::of_input(work),
                WithState::splat(T::of(f64::NAN)),
            ),
        }
    }

    /// The range of the efforts since the last sound sample, `applied` included.
    #[inline]
    fn efforts_with(&self, applied: SVector<T, M>) -> EffortRange<SVector<T, M>> {
        let applied = Signal::choose(applied.finite(), applied, self.efforts.least);
        let missing = self.gap.above(T::of(0.0));
        EffortRange::choose(missing, self.efforts.with(applied), EffortRange::of(applied))
    }
}
