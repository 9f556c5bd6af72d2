//! The plant of a scene.

use std::fmt;
use std::sync::Arc;

use lyapunov::{
    ParameterError, Plant, PortSample, Scalar, Signal,
    bodies::{
        Body, DampedMass, ElasticJoint, Friction, Impedance, IntegratedPlant, IsotropicFriction,
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
use crate::files::scene::{self, Motion, NonNegative, Scene, of};
use crate::simulate::building::Space;

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

    /// The parts, with the operator's stiffness and damping as given.
    fn parts(scene: &Scene, stiffness: NonNegative, damping: NonNegative) -> Self::Parts;

    /// The body where `scene` starts it.
    fn body(scene: &Scene, parts: Self::Parts) -> Result<Self::Body, ParameterError>;
}

/// Operator and device as one mass.
struct Joined;

impl<V: Space> Kind<V> for Joined {
    type Parts = Impedance<V::Scalar>;
    type Body = Body<V>;

    fn parts(scene: &Scene, stiffness: NonNegative, damping: NonNegative) -> Self::Parts {
        // Added in f64, so that the sum of two values of a scene is rounded once.
        Impedance {
            mass: of(scene.operator.mass.get() + scene.device.mass.get()),
            damping: of(damping.get() + scene.device.damping.get()),
            stiffness: of(stiffness),
        }
    }

    fn body(scene: &Scene, parts: Self::Parts) -> Result<Body<V>, ParameterError> {
        let start = (V::at(&scene.initial.position), V::at(&scene.initial.velocity));
        let body = Body::new(parts, of(scene.period()))?;
        Ok(body.resting_at(V::at(&scene.operator.rest)).starting(start.0, start.1))
    }
}

/// Operator and device as two masses joined by a link.
struct Apart;

impl<V: Space> Kind<V> for Apart {
    type Parts = TwoMassParts<V::Scalar>;
    type Body = TwoMassBody<V>;

    fn parts(scene: &Scene, stiffness: NonNegative, damping: NonNegative) -> Self::Parts {
        // A scene without a link has no two-mass body; the link's zeros are then never used.
        let link = scene.link.map_or((0.0, 0.0), |it| (it.stiffness.get(), it.damping.get()));
        TwoMassParts {
            operator: Impedance {
                mass: of(scene.operator.mass),
                damping: of(damping),
                stiffness: of(stiffness),
            },
            device: DampedMass { mass: of(scene.device.mass), damping: of(scene.device.damping) },
            link: ElasticJoint { stiffness: of(link.0), damping: of(link.1) },
        }
    }

    fn body(scene: &Scene, parts: Self::Parts) -> Result<TwoMassBody<V>, ParameterError> {
        let start = (V::at(&scene.initial.position), V::at(&scene.initial.velocity));
        let body = TwoMassBody::new(parts, of(scene.period()))?;
        Ok(body.resting_at(V::at(&scene.operator.rest)).starting(start.0, start.1))
    }
}

/// The plant of a scene on a line, where friction has a sign.
pub(super) fn on_a_line<T: Scalar + Space>(
    scene: &Scene,
    seen: &Operator<T>,
) -> Result<AnyPlant<T>, ParameterError> {
    let Some(friction) = scene.effects.friction else {
        return frictionless(scene, seen);
    };
    let law = stribeck(friction);
    if let Some((integrator, steps)) = AnyIntegrator::of(scene.integrator)? {
        // Behind a link only exact motion takes friction: a scene that asks for both is not built.
        let parts =
            <Joined as Kind<T>>::parts(scene, scene.operator.stiffness, scene.operator.damping);
        let dynamics = StickSlipOscillator::new(parts, law)?;
        let body = moved(scene, dynamics, EventLocating::new(integrator), steps)?;
        return disturbed::<T, Joined>(scene, AnyBody::new(body));
    }
    if scene.link.is_some() {
        let (body, parts) = start::<T, Apart>(scene)?;
        let body = Watched::new(Friction::new(body, parts, law)?, seen);
        disturbed::<T, Apart>(scene, AnyBody::new(body))
    } else {
        let (body, parts) = start::<T, Joined>(scene)?;
        disturbed::<T, Joined>(scene, AnyBody::new(Friction::new(body, parts, law)?))
    }
}

/// The plant of a scene in a space, where friction opposes the velocity as a vector: one mass, moved exactly, since a scene
/// that asks for another is not built.
pub(super) fn in_space<T: Scalar + Space, const N: usize>(
    scene: &Scene,
    seen: &Operator<SVector<T, N>>,
) -> Result<AnyPlant<SVector<T, N>>, ParameterError> {
    let Some(friction) = scene.effects.friction else {
        return frictionless(scene, seen);
    };
    let (body, parts) = start::<SVector<T, N>, Joined>(scene)?;
    let body = IsotropicFriction::new(body, parts, stribeck(friction))?;
    disturbed::<SVector<T, N>, Joined>(scene, AnyBody::new(body))
}

fn stribeck<T: Scalar>(friction: scene::Friction) -> Stribeck<T> {
    Stribeck {
        coulomb: of(friction.coulomb),
        breakaway: of(friction.breakaway()),
        // Where both friction forces are equal, any velocity will do.
        stribeck_velocity: friction.stribeck_velocity.map_or(T::one(), of),
    }
}

/// The plant of any scene without friction.
pub(super) fn frictionless<V: Space>(
    scene: &Scene,
    seen: &Operator<V>,
) -> Result<AnyPlant<V>, ParameterError> {
    if let Some((integrator, steps)) = AnyIntegrator::of(scene.integrator)? {
        return stepped(scene, seen, integrator, steps);
    }
    if scene.link.is_some() {
        let body = Watched::new(start::<V, Apart>(scene)?.0, seen);
        disturbed::<V, Apart>(scene, AnyBody::new(body))
    } else {
        disturbed::<V, Joined>(scene, AnyBody::new(start::<V, Joined>(scene)?.0))
    }
}

/// The same plant, moved by `integrator` in `steps` steps per period.
pub(super) fn stepped<V, I>(
    scene: &Scene,
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
    let (stiffness, damping) = (scene.operator.stiffness, scene.operator.damping);
    if scene.link.is_some() {
        let parts = <Apart as Kind<V>>::parts(scene, stiffness, damping);
        let body = moved(scene, CoupledOscillators::new(parts)?, integrator, steps)?;
        disturbed::<V, Apart>(scene, AnyBody::new(Watched::new(body, seen)))
    } else {
        let parts = <Joined as Kind<V>>::parts(scene, stiffness, damping);
        let body = moved(scene, Oscillator::new(parts)?, integrator, steps)?;
        disturbed::<V, Joined>(scene, AnyBody::new(body))
    }
}

/// A plant that moves along `dynamics` from where `scene` starts it.
fn moved<V, D, I>(
    scene: &Scene,
    dynamics: D,
    integrator: I,
    steps: u32,
) -> Result<IntegratedPlant<V, D, I>, ParameterError>
where
    V: Space,
    D: Mechanics<V, Coordinates: Coordinates<V>>,
    I: Integrator<V, D>,
{
    let start = (V::at(&scene.initial.position), V::at(&scene.initial.velocity));
    let body = IntegratedPlant::new(dynamics, integrator, of(scene.period()), steps)?;
    Ok(body.resting_at(V::at(&scene.operator.rest)).starting(start.0, start.1))
}

fn start<V: Space, K: Kind<V>>(scene: &Scene) -> Result<(K::Body, K::Parts), ParameterError> {
    let parts = K::parts(scene, scene.operator.stiffness, scene.operator.damping);
    Ok((K::body(scene, parts)?, parts))
}

/// The body with everything that disturbs it, innermost first: jitter, motion, grip, load and pulse.
fn disturbed<V: Space, K: Kind<V>>(
    scene: &Scene,
    mut body: AnyBody<V, K::Parts>,
) -> Result<AnyPlant<V>, ParameterError> {
    let (effects, rate) = (&scene.effects, scene.servo_rate.get());
    let parts = K::parts(scene, scene.operator.stiffness, scene.operator.damping);
    if let Some(jitter) = effects.jitter {
        let mut random = Random::new(|_| jitter.seed.get(), Source::Jitter);
        let normal = move || random.normal::<V::Scalar>();
        body = AnyBody::new(body.jittered(parts, of(jitter.deviation), normal)?);
    }
    if let Some(motion) = &scene.operator.motion {
        body = led(scene, motion, body)?;
    }
    if let Some(grip) = &scene.operator.grip {
        let rows = grip.times.iter().zip(&grip.stiffness).zip(&grip.damping);
        let table: Arc<[_]> = rows
            .map(|((time, stiffness), damping)| {
                (scene.tick_of(time.get()), K::parts(scene, *stiffness, *damping))
            })
            .collect();
        body = AnyBody::new(body.gripped(parts, table)?);
    }
    let load = effects.load.map(|load| Constant::new(load.force.get())).transpose()?;
    let pulse = effects.pulse.map(|pulse| {
        let (start, duration) = (pulse.start.get(), pulse.duration.get());
        Pulse::new(pulse.force.get(), start, duration, rate)
    });
    Ok(pushed(body, load, pulse.transpose()?))
}

/// The body with the forces that push it, all in one box.
fn pushed<V: Space, P: Copy + 'static>(
    body: AnyBody<V, P>,
    load: Option<Constant>,
    pulse: Option<Pulse>,
) -> AnyPlant<V> {
    let load = load.map(|load| FirstAxis::of(load, V::zero()));
    let pulse = pulse.map(|pulse| FirstAxis::of(pulse, V::zero()));
    match (load, pulse) {
        (None, None) => body.into_plant(),
        (Some(load), None) => AnyPlant::new(body.pushed(load)),
        (None, Some(pulse)) => AnyPlant::new(body.pushed(pulse)),
        (Some(load), Some(pulse)) => AnyPlant::new(body.pushed(load).pushed(pulse)),
    }
}

/// The body with `motion` leading its operator's spring along the first axis.
fn led<V: Space, P: Copy + 'static>(
    scene: &Scene,
    motion: &Motion,
    body: AnyBody<V, P>,
) -> Result<AnyBody<V, P>, ParameterError> {
    let (rest, rate) = (scene.operator.rest.get(), scene.servo_rate.get());
    let others = V::at(&scene.operator.rest);
    Ok(match motion {
        Motion::Step { at, to } => {
            let trajectory = Step::new(rest, to.get(), at.get(), rate)?;
            AnyBody::new(body.led_by(FirstAxis::of(trajectory, others)))
        }
        Motion::Ramp { at, to, rate: speed } => {
            let (to, at) = (to.get(), at.get());
            let parts = RampParts { from: rest, to, rate: speed.get(), at };
            let trajectory = Ramp::new(parts, rate)?;
            AnyBody::new(body.led_by(FirstAxis::of(trajectory, others)))
        }
        Motion::Sine { amplitude, frequency } => {
            let trajectory = Sine::new(rest, amplitude.get(), frequency.get(), rate)?;
            AnyBody::new(body.led_by(FirstAxis::of(trajectory, others)))
        }
        Motion::File { samples, .. } => {
            let trajectory = Samples::new(Arc::clone(samples), rate)?;
            AnyBody::new(body.led_by(FirstAxis::of(trajectory, others)))
        }
    })
}
