//! The plant of a scene.

use std::fmt;
use std::sync::Arc;

use lyapunov::{
    ParameterError, Plant, PortSample, Scalar, Signal,
    bodies::{
        self, Body, DampedMass, ElasticJoint, Impedance, IntegratedPlant, IsotropicFriction,
        OperatedBody, PlantExt, Stribeck, TwoMassBody, TwoMassParts,
    },
    effects::{Random, Source},
    integrators::{
        Coordinates, CoupledOscillators, EventLocating, Integrator, Mechanics, Oscillator,
        StickSlipOscillator,
    },
    trajectories::{Constant, FirstAxis, Pulse, Ramp, RampParts, Samples, Sine, Step},
};

use nalgebra::SVector;

use super::body::{AnyBody, Watched};
use super::integrator::AnyIntegrator;
use super::seen::Operator;
use super::{Scenes, Space};
use crate::files::scene::{Friction, Link, Motion, NonNegative, Positive, Scene, of};

/// Any plant, boxed.
pub struct AnyPlant<V: Signal>(Box<dyn Plant<V>>);

impl<V: Signal> AnyPlant<V> {
    /// Boxes `plant`.
    pub fn new(plant: impl Plant<V> + 'static) -> Self {
        Self(Box::new(plant))
    }

    pub(super) fn boxed(plant: Box<dyn Plant<V>>) -> Self {
        Self(plant)
    }
}

impl<V: Signal> fmt::Debug for AnyPlant<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyPlant").finish_non_exhaustive()
    }
}

impl<V: Signal> Plant<V> for AnyPlant<V> {
    fn start(&self) -> PortSample<V> {
        self.0.start()
    }

    #[inline]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        self.0.advance(effort)
    }

    #[inline]
    fn advance_into(&mut self, effort: V, sample: &mut PortSample<V>) {
        self.0.advance_into(effort, sample);
    }
}

/// A kind of body: its parts, and how a scene makes it.
trait Kind<V: Space> {
    type Parts: Copy + 'static;
    type Body: OperatedBody<V, Parts = Self::Parts> + Copy + 'static;

    /// The parts, with the operator's damping and stiffness as given.
    fn parts(scenes: Scenes<'_>, grip: impl Fn(&Scene) -> [NonNegative; 2]) -> Self::Parts;

    /// The body where the scenes start it.
    fn body(scenes: Scenes<'_>, parts: Self::Parts) -> Result<Self::Body, ParameterError>;
}

/// Operator and device as one mass.
struct Joined;

impl<V: Space> Kind<V> for Joined {
    type Parts = Impedance<V::Scalar>;
    type Body = Body<V>;

    fn parts(scenes: Scenes<'_>, grip: impl Fn(&Scene) -> [NonNegative; 2]) -> Self::Parts {
        // Added in f64, so that the sum of two values of a scene is rounded once.
        Impedance {
            mass: scenes.each(|it| it.operator.mass.get() + it.device.mass.get()),
            damping: scenes.each(|it| grip(it)[0].get() + it.device.damping.get()),
            stiffness: scenes.each(|it| grip(it)[1]),
        }
    }

    fn body(scenes: Scenes<'_>, parts: Self::Parts) -> Result<Body<V>, ParameterError> {
        let [rest, position, velocity] = places(scenes);
        let body = Body::new(parts, of(scenes.common().period()))?;
        Ok(body.resting_at(rest).starting(position, velocity))
    }
}

/// Operator and device as two masses joined by a link.
struct Apart;

impl<V: Space> Kind<V> for Apart {
    type Parts = TwoMassParts<V::Scalar>;
    type Body = TwoMassBody<V>;

    fn parts(scenes: Scenes<'_>, grip: impl Fn(&Scene) -> [NonNegative; 2]) -> Self::Parts {
        // A scene without a link has no two-mass body; the link's zeros are then never used.
        let link = |number: fn(Link) -> f64| scenes.each(|it| it.link.map_or(0.0, number));
        TwoMassParts {
            operator: Impedance {
                mass: scenes.each(|it| it.operator.mass),
                damping: scenes.each(|it| grip(it)[0]),
                stiffness: scenes.each(|it| grip(it)[1]),
            },
            device: DampedMass {
                mass: scenes.each(|it| it.device.mass),
                damping: scenes.each(|it| it.device.damping),
            },
            link: ElasticJoint {
                stiffness: link(|it| it.stiffness.get()),
                damping: link(|it| it.damping.get()),
            },
        }
    }

    fn body(scenes: Scenes<'_>, parts: Self::Parts) -> Result<TwoMassBody<V>, ParameterError> {
        let [rest, position, velocity] = places(scenes);
        let body = TwoMassBody::new(parts, of(scenes.common().period()))?;
        Ok(body.resting_at(rest).starting(position, velocity))
    }
}

/// The operator's damping and stiffness.
fn held(scene: &Scene) -> [NonNegative; 2] {
    [scene.operator.damping, scene.operator.stiffness]
}

/// Rest of the operator's spring, and position and velocity at the start.
fn places<V: Space>(scenes: Scenes<'_>) -> [V; 3] {
    [
        V::at(scenes, |it| &it.operator.rest),
        V::at(scenes, |it| &it.initial.position),
        V::at(scenes, |it| &it.initial.velocity),
    ]
}

/// The plant of scenes on a line, where friction has a sign.
pub(super) fn on_a_line<T: Scalar + Space>(
    scenes: Scenes<'_>,
    seen: &Operator<T>,
) -> Result<AnyPlant<T>, ParameterError> {
    let common = scenes.common();
    if common.effects.friction.is_none() {
        return frictionless(scenes, seen);
    }
    let law = stribeck(scenes);
    if let Some((integrator, steps)) = AnyIntegrator::of(common.integrator)? {
        // Behind a link only exact motion takes friction: a scene that asks for both is not built.
        let dynamics = StickSlipOscillator::new(<Joined as Kind<T>>::parts(scenes, held), law)?;
        let body = moved(scenes, dynamics, EventLocating::new(integrator), steps)?;
        return disturbed::<T, Joined>(scenes, scenes.body(body));
    }
    if common.link.is_some() {
        let (body, parts) = start::<T, Apart>(scenes)?;
        let body = Watched::new(bodies::Friction::new(body, parts, law)?, seen);
        disturbed::<T, Apart>(scenes, scenes.body(body))
    } else {
        let (body, parts) = start::<T, Joined>(scenes)?;
        disturbed::<T, Joined>(scenes, scenes.body(bodies::Friction::new(body, parts, law)?))
    }
}

/// The plant of scenes in a space, where friction opposes the velocity as a vector: one mass, moved exactly, since a scene
/// that asks for another is not built.
pub(super) fn in_space<T: Scalar + Space, const N: usize>(
    scenes: Scenes<'_>,
    seen: &Operator<SVector<T, N>>,
) -> Result<AnyPlant<SVector<T, N>>, ParameterError>
where
    SVector<T, N>: Space<Scalar = T>,
{
    if scenes.common().effects.friction.is_none() {
        return frictionless(scenes, seen);
    }
    let (body, parts) = start::<SVector<T, N>, Joined>(scenes)?;
    let body = IsotropicFriction::new(body, parts, stribeck(scenes))?;
    disturbed::<SVector<T, N>, Joined>(scenes, scenes.body(body))
}

fn stribeck<T: Scalar>(scenes: Scenes<'_>) -> Stribeck<T> {
    // Where both friction forces are equal, any velocity will do.
    let velocity = |it: Friction| it.stribeck_velocity.map_or(1.0, Positive::get);
    let number =
        |of: &dyn Fn(Friction) -> f64| scenes.each(|it| it.effects.friction.map_or(0.0, of));
    Stribeck {
        coulomb: number(&|it| it.coulomb.get()),
        breakaway: number(&|it| it.breakaway()),
        stribeck_velocity: number(&velocity),
    }
}

/// The plant of any scenes without friction.
pub(super) fn frictionless<V: Space>(
    scenes: Scenes<'_>,
    seen: &Operator<V>,
) -> Result<AnyPlant<V>, ParameterError> {
    if let Some((integrator, steps)) = AnyIntegrator::of(scenes.common().integrator)? {
        return stepped(scenes, seen, integrator, steps);
    }
    if scenes.common().link.is_some() {
        let body = Watched::new(start::<V, Apart>(scenes)?.0, seen);
        disturbed::<V, Apart>(scenes, scenes.body(body))
    } else {
        disturbed::<V, Joined>(scenes, scenes.body(start::<V, Joined>(scenes)?.0))
    }
}

/// The same plant, moved by `integrator` in `steps` steps per period.
pub(super) fn stepped<V, I>(
    scenes: Scenes<'_>,
    seen: &Operator<V>,
    integrator: I,
    steps: u32,
) -> Result<AnyPlant<V>, ParameterError>
where
    V: Space,
    I: Integrator<V, Oscillator<V::Scalar>>
        + Integrator<V, CoupledOscillators<V::Scalar>>
        + Copy
        + 'static,
{
    if scenes.common().link.is_some() {
        let parts = <Apart as Kind<V>>::parts(scenes, held);
        let body = moved(scenes, CoupledOscillators::new(parts)?, integrator, steps)?;
        disturbed::<V, Apart>(scenes, scenes.body(Watched::new(body, seen)))
    } else {
        let parts = <Joined as Kind<V>>::parts(scenes, held);
        let body = moved(scenes, Oscillator::new(parts)?, integrator, steps)?;
        disturbed::<V, Joined>(scenes, scenes.body(body))
    }
}

/// A plant that moves along `dynamics` from where the scenes start it.
fn moved<V, D, I>(
    scenes: Scenes<'_>,
    dynamics: D,
    integrator: I,
    steps: u32,
) -> Result<IntegratedPlant<V, D, I>, ParameterError>
where
    V: Space,
    D: Mechanics<V, Coordinates: Coordinates<V>>,
    I: Integrator<V, D>,
{
    let [rest, position, velocity] = places(scenes);
    let period = of(scenes.common().period());
    let body = IntegratedPlant::new(dynamics, integrator, period, steps)?;
    Ok(body.resting_at(rest).starting(position, velocity))
}

fn start<V: Space, K: Kind<V>>(scenes: Scenes<'_>) -> Result<(K::Body, K::Parts), ParameterError> {
    let parts = K::parts(scenes, held);
    Ok((K::body(scenes, parts)?, parts))
}

/// The body with everything that disturbs it, innermost first: jitter, motion, grip, load and pulse.
fn disturbed<V: Space, K: Kind<V>>(
    scenes: Scenes<'_>,
    mut body: AnyBody<V, K::Parts>,
) -> Result<AnyPlant<V>, ParameterError> {
    let common = scenes.common();
    let effects = &common.effects;
    let parts = K::parts(scenes, held);
    if effects.jitter.is_some() {
        let jitter = |lane: usize| scenes.lane(lane).effects.jitter;
        let seed = |lane| jitter(lane).map_or(0, |it| it.seed.get());
        let mut random = Random::new(seed, Source::Jitter);
        let normal = move || random.normal::<V::Scalar>();
        let deviation = |it: &Scene| it.effects.jitter.map_or(0.0, |it| it.deviation.get());
        body = scenes.body(body.jittered(parts, scenes.each(deviation), normal)?);
    }
    if let Some(motion) = &common.operator.motion {
        body = led(scenes, motion, body)?;
    }
    if let Some(grip) = &common.operator.grip {
        let row = |index: usize| {
            let tick = common.tick_of(grip.times[index].get());
            (tick, K::parts(scenes, |it| gripped(it, index)))
        };
        let table: Arc<[_]> = (0..grip.times.len()).map(row).collect();
        body = scenes.body(body.gripped(parts, table)?);
    }
    let load = effects.load.map(|load| Constant::new(load.force.get())).transpose()?;
    let pulse = effects.pulse.map(|it| it.on_ticks(common.servo_rate.get())).transpose()?;
    Ok(pushed(scenes, body, load, pulse))
}

/// Damping and stiffness of row `index` of the operator's grip.
fn gripped(scene: &Scene, index: usize) -> [NonNegative; 2] {
    let grip = scene.operator.grip.as_ref();
    let row = grip.and_then(|it| Some([*it.damping.get(index)?, *it.stiffness.get(index)?]));
    row.unwrap_or_else(|| held(scene))
}

/// The body with the forces that push it, all in one box.
fn pushed<V: Space, P: Copy + 'static>(
    scenes: Scenes<'_>,
    body: AnyBody<V, P>,
    load: Option<Constant>,
    pulse: Option<Pulse>,
) -> AnyPlant<V> {
    let load = load.map(|load| FirstAxis::of(load, V::zero()));
    let pulse = pulse.map(|pulse| FirstAxis::of(pulse, V::zero()));
    match (load, pulse) {
        (None, None) => body.into_plant(),
        (Some(load), None) => scenes.plant(body.pushed(load)),
        (None, Some(pulse)) => scenes.plant(body.pushed(pulse)),
        (Some(load), Some(pulse)) => scenes.plant(body.pushed(load).pushed(pulse)),
    }
}

/// The body with `motion` leading its operator's spring along the first axis.
fn led<V: Space, P: Copy + 'static>(
    scenes: Scenes<'_>,
    motion: &Motion,
    body: AnyBody<V, P>,
) -> Result<AnyBody<V, P>, ParameterError> {
    let common = scenes.common();
    let (rest, rate) = (common.operator.rest.get(), common.servo_rate.get());
    let others = V::at(scenes, |it| &it.operator.rest);
    Ok(match motion {
        Motion::Step { at, to } => {
            let trajectory = Step::new(rest, to.get(), at.get(), rate)?;
            scenes.body(body.led_by(FirstAxis::of(trajectory, others)))
        }
        Motion::Ramp { at, to, rate: speed } => {
            let (to, at) = (to.get(), at.get());
            let parts = RampParts { from: rest, to, rate: speed.get(), at };
            let trajectory = Ramp::new(parts, rate)?;
            scenes.body(body.led_by(FirstAxis::of(trajectory, others)))
        }
        Motion::Sine { amplitude, frequency } => {
            let trajectory = Sine::new(rest, amplitude.get(), frequency.get(), rate)?;
            scenes.body(body.led_by(FirstAxis::of(trajectory, others)))
        }
        Motion::File { samples, .. } => {
            let trajectory = Samples::new(Arc::clone(samples), rate)?;
            scenes.body(body.led_by(FirstAxis::of(trajectory, others)))
        }
    })
}
