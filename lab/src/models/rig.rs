//! A plant behind its port, ready to run.

use lyapunov::{
    self as library, DampingLimit, Lolc, Mask, OnePort, ParameterError, Plant, Popc, PortEnergy,
    Scalar, Signal,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{
        AffinePlant, ControlAffine, Decay, LyapunovFunction, StateFeedback, WithState, decrease_of,
    },
    stabilizers::NoStabilizer,
};
use nalgebra::SVector;

use super::contestant::Contestant;
use super::controller::Controller;
use super::meter::{Meter, Tick};
use super::model::Model;
use super::outcome::Outcome;
use super::stabilizer::Stabilizer;
use crate::subjects::{CompareError, Watch};

/// The longest delay of a controller in ticks.
const MOST_DELAY: usize = 1024;

/// Steps of the integrator between two reports of progress, or one tick where that has more.
const BREATH: u64 = 1 << 14;

/// A loop that any contestant can run, whatever the plant and the scalar.
pub(super) trait Loop {
    /// V at the start.
    fn began(&self) -> f64;

    /// What `contestant` comes to.
    fn run(&self, contestant: Contestant, watch: &Watch<'_>) -> Result<Outcome, CompareError>;
}

/// A part of a model that cannot be built: the key that is to be changed, and why.
pub(super) type Refused = (&'static str, ParameterError);

/// What differs from plant to plant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts<P, F, T, const M: usize> {
    pub(super) plant: P,
    /// V.
    pub(super) function: F,
    /// The least apparent mass of the port.
    pub(super) mass: T,
    /// The inputs that act at rest.
    pub(super) holding: SVector<T, M>,
}

/// A plant, the controller at its port and what its stabilizers are made of.
struct Rig<P, F, C, T, const N: usize, const M: usize> {
    plant: AffinePlant<P, F, RungeKutta4, T, N, M>,
    controller: C,
    function: F,
    decay: Decay<F, T>,
    limit: DampingLimit<T>,
    ticks: u64,
    servo_rate: f64,
    /// Ticks between two reports of progress.
    breath: u64,
}

/// The loop of `model` around these `parts`.
pub(super) fn rig<P, F, T, const N: usize, const M: usize>(
    model: &Model,
    parts: Parts<P, F, T, M>,
) -> Result<Box<dyn Loop>, Refused>
where
    T: Scalar,
    P: ControlAffine<T, N, M> + Copy + 'static,
    F: LyapunovFunction<SVector<T, N>> + Copy + 'static,
{
    let Parts { plant, function, mass, holding } = parts;
    let period = T::of(model.servo_rate.get().recip());
    let start = SVector::from_fn(|row, _| T::of(model.initial.get(row).map_or(0.0, |x| x.get())));
    let plant = AffinePlant::new(plant, function, RungeKutta4, period, model.steps_per_tick.get())
        .map_err(|error| ("servo_rate", error))?
        .starting(start);
    let Stabilizer { damping_cap, decay } = model.stabilizer;
    let limit = DampingLimit::of_mass(T::of(damping_cap.get()), mass, period)
        .map_err(|error| ("stabilizer.damping_cap", error))?;
    let decay =
        Decay::new(function, T::of(decay.get())).map_err(|error| ("stabilizer.decay", error))?;
    let Controller { proportional, derivative, hold, delay } = &model.controller;
    let [proportional, derivative] = [proportional, derivative]
        .map(|gains| SVector::<T, M>::from_fn(|input, _| T::of(gains.axis(input))));
    let law = move |x: SVector<T, N>| {
        SVector::<T, M>::from_fn(|input, _| {
            holding[input] - proportional[input] * x[input] - derivative[input] * x[M + input]
        })
    };
    let controller = StateFeedback::new(law)
        .held(hold.get().into())
        .map_err(|error| ("controller.hold", error))?
        .delayed::<MOST_DELAY>(delay.get().into())
        .map_err(|error| ("controller.delay", error))?;
    let (ticks, servo_rate) = (model.ticks(), model.servo_rate.get());
    let breath = (BREATH / u64::from(model.steps_per_tick.get())).max(1);
    Ok(Box::new(Rig { plant, controller, function, decay, limit, ticks, servo_rate, breath }))
}

impl<P, F, C, T, const N: usize, const M: usize> Rig<P, F, C, T, N, M>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>> + Copy + 'static,
{
    fn stabilizer(
        &self,
        contestant: Contestant,
    ) -> Box<dyn library::Stabilizer<WithState<T, N, M>>> {
        let decrease = decrease_of(self.function, self.plant.state());
        match contestant {
            Contestant::None => Box::new(NoStabilizer),
            Contestant::Popc => Box::new(Popc::new(PortEnergy, self.limit)),
            Contestant::Decrease => Box::new(Lolc::new(decrease, self.limit)),
            Contestant::Decay => Box::new(Lolc::new((decrease, self.decay), self.limit)),
        }
    }
}

impl<P, F, C, T, const N: usize, const M: usize> Loop for Rig<P, F, C, T, N, M>
where
    T: Scalar,
    P: ControlAffine<T, N, M> + Copy,
    F: LyapunovFunction<SVector<T, N>> + Copy + 'static,
    C: OnePort<WithState<T, N, M>> + Clone,
{
    fn began(&self) -> f64 {
        self.plant.value().lane(0)
    }

    fn run(&self, contestant: Contestant, watch: &Watch<'_>) -> Result<Outcome, CompareError> {
        let mut stabilizer = self.stabilizer(contestant);
        let mut port = self.controller.clone().stabilized(&mut *stabilizer);
        let (mut plant, mut sample) = (self.plant, self.plant.start());
        let mut meter = Meter::new(self.ticks, self.servo_rate, self.began());
        for tick in 1..=self.ticks + 1 {
            let (flow, value) = (sample.velocity, plant.value().lane(0));
            if !(sample.position.finite().all() && value.is_finite()) {
                break;
            }
            let effort = port.respond(&sample);
            let correction = port.correction();
            sample = plant.advance(effort);
            meter.add(Tick {
                value,
                effort: effort.inner(effort).sqrt().lane(0),
                alpha: correction.alpha.lane(0),
                shortfall: correction.shortfall.lane(0),
                taken: (correction.alpha * flow.inner(sample.displacement)).lane(0),
            });
            if tick % self.breath == 0 && watch(self.breath).is_break() {
                return Err(CompareError::Stopped);
            }
        }
        // What was not run counts as done: a run that leaves the range has no more ticks.
        let told = meter.ticks() / self.breath * self.breath;
        let ended = watch(self.ticks + 1 - told);
        if ended.is_break() { Err(CompareError::Stopped) } else { Ok(meter.finish(contestant)) }
    }
}
