//! Plant behind its port, ready to run.

use std::ops::ControlFlow;

use lyapunov::{
    self as library, DampingLimit, Lolc, Mask, OnePort, Plant, Popc, PortEnergy, Scalar, Signal,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{
        AffinePlant, ControlAffine, Decay, LyapunovFunction, StateFeedback, WithState, decrease_of,
    },
    stabilizers::NoStabilizer,
};
use nalgebra::SVector;

use super::entrant::Entrant;
use crate::files::models::{Controller, Model, Stabilizer};
use crate::files::scene::Refused;

/// Longest delay of a controller, ticks.
const MOST_DELAY: usize = 1024;

/// Loop that any entrant can run, whatever the plant and the scalar.
pub(crate) trait Loop {
    /// V at the start.
    fn began(&self) -> f64;

    /// Runs under `entrant` until the end, until the range is left, or until `each` of the ticks breaks off.
    fn run(&self, entrant: Entrant, each: &mut dyn FnMut(Tick) -> ControlFlow<()>);
}

/// One tick of a run of a model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tick {
    /// V.
    pub(crate) value: f64,
    /// The size of the effort that acts from this tick on.
    pub(crate) effort: f64,
    /// The injected damping.
    pub(crate) alpha: f64,
    /// The debt that this tick cannot serve.
    pub(crate) shortfall: f64,
    /// Energy that the correction takes from V until the next tick.
    pub(crate) taken: f64,
}

/// Parts that differ from plant to plant.
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

/// A plant, the controller at its port and the parts of its stabilizers.
struct Rig<P, F, C, T, const N: usize, const M: usize> {
    plant: AffinePlant<P, F, RungeKutta4, T, N, M>,
    controller: C,
    function: F,
    decay: Decay<F, T>,
    limit: DampingLimit<T>,
    ticks: u64,
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
    Ok(Box::new(Rig { plant, controller, function, decay, limit, ticks: model.ticks() }))
}

impl<P, F, C, T, const N: usize, const M: usize> Rig<P, F, C, T, N, M>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>> + Copy + 'static,
{
    fn stabilizer(&self, entrant: Entrant) -> Box<dyn library::Stabilizer<WithState<T, N, M>>> {
        let decrease = decrease_of(self.function, self.plant.state());
        match entrant {
            Entrant::None => Box::new(NoStabilizer),
            Entrant::Popc => Box::new(Popc::new(PortEnergy, self.limit)),
            Entrant::Decrease => Box::new(Lolc::new(decrease, self.limit)),
            Entrant::Decay => Box::new(Lolc::new((decrease, self.decay), self.limit)),
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

    fn run(&self, entrant: Entrant, each: &mut dyn FnMut(Tick) -> ControlFlow<()>) {
        let mut stabilizer = self.stabilizer(entrant);
        let mut port = self.controller.clone().stabilized(&mut *stabilizer);
        let (mut plant, mut sample) = (self.plant, self.plant.start());
        for _ in 0..=self.ticks {
            let (flow, value) = (sample.velocity, plant.value().lane(0));
            if !(sample.position.finite().all() && value.is_finite()) {
                return;
            }
            let effort = port.respond(&sample);
            let correction = port.correction();
            sample = plant.advance(effort);
            let tick = Tick {
                value,
                effort: effort.inner(effort).sqrt().lane(0),
                alpha: correction.alpha.lane(0),
                shortfall: correction.shortfall.lane(0),
                taken: (correction.alpha * flow.inner(sample.displacement)).lane(0),
            };
            if each(tick).is_break() {
                return;
            }
        }
    }
}
