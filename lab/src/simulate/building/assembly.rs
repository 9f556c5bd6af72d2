//! The whole loop of a scene.

use lyapunov::{
    LyapunovCandidate, OnePort, ParameterError, Plant, PortSample, Scalar, Signal,
    effects::{Fallback, OnePortExt},
    environments::ForceLaw,
    integrators::{CoupledOscillators, Integrator, Oscillator},
};

use super::plant::stepped;
use super::seen::{Operator, Seen};
use super::wrapper::Passing;
use super::{AnyPlant, AnyStabilizer, AnyWrapper, Fitted, Port};
use crate::files::scene::{Filter, Pace, Policy, Positive, Render, Scene, Velocity, of};
use crate::simulate::building::Space;

/// Room for a scene's delay, ticks.
const DELAY: usize = 1024;

/// Room for a scene's window, ticks.
const WINDOW: usize = 256;

/// The two halves of a loop: the plant, and the port that answers its motion.
#[derive(Debug)]
pub struct Assembly<V: Signal> {
    /// The moving plant.
    pub plant: AnyPlant<V>,
    /// The port that answers the motion, stabilizer and effects included.
    pub port: Port<V>,
}

impl<V: Space> Assembly<V> {
    /// The loop of `scene` with the stabilizer it names, in the scalar of `V`, whatever scalar `scene` names.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others.
    pub fn of(scene: &Scene) -> Result<Self, ParameterError> {
        Self::put_together(scene, None, Fitted::of(scene)?)
    }

    /// The same loop, with `seen` recording what the stabilizer and the port do.
    pub(crate) fn watched(
        scene: &Scene,
        seen: &Seen<V>,
        fitted: Fitted<V>,
    ) -> Result<Self, ParameterError> {
        Self::put_together(scene, Some(seen), fitted)
    }

    /// The loop of `scene` with `stabilizer` instead of the scene's own.
    ///
    /// # Errors
    /// As [`Assembly::of`].
    pub fn stabilized_by(
        scene: &Scene,
        stabilizer: AnyStabilizer<V>,
    ) -> Result<Self, ParameterError> {
        Self::put_together(scene, None, Fitted::Behind(stabilizer))
    }

    /// One tick; returns the effort that acts until the next.
    #[inline]
    pub fn tick(&mut self, sample: &mut PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        self.plant.advance_into(effort, sample);
        effort
    }

    fn put_together(
        scene: &Scene,
        seen: Option<&Seen<V>>,
        fitted: Fitted<V>,
    ) -> Result<Self, ParameterError> {
        let port = answering(scene, seen, fitted)?;
        let unseen = Operator::default();
        let plant = V::plant(scene, seen.map_or(&unseen, |seen| &seen.operator))?;
        Ok(Self { plant, port })
    }

    /// The loop of a frictionless `scene`, moved by `integrator` instead of its own.
    pub(crate) fn moved_by<I>(scene: &Scene, integrator: I) -> Result<Self, ParameterError>
    where
        I: Integrator<V, Oscillator<V::Scalar>>
            + Integrator<V, CoupledOscillators<V::Scalar>>
            + Copy
            + 'static,
    {
        let port = answering(scene, None, Fitted::of(scene)?)?;
        let plant = stepped(scene, &Operator::default(), integrator, 1)?;
        Ok(Self { plant, port })
    }
}

/// The port that answers the motion, stabilizer and effects included.
fn answering<V: Space>(
    scene: &Scene,
    seen: Option<&Seen<V>>,
    fitted: Fitted<V>,
) -> Result<Port<V>, ParameterError> {
    let around = fitted.around(Pace::Environment);
    let port = V::render(scene, AtServoRate { scene, around, seen })?;
    let (port, stabilizer) = match fitted {
        Fitted::Behind(stabilizer) => (port, stabilizer),
        Fitted::Around(wrapper) => {
            let port = match wrapper.pace() {
                Pace::Environment => port,
                Pace::Servo => wrapper.around(port, V::Scalar::of(scene.period()), seen)?,
            };
            (port, AnyStabilizer::called(Passing))
        }
    };
    let port = match seen {
        None => stabilizer.on(port, scene)?,
        Some(seen) => measured(scene, port.stabilized(seen.stabilizer(stabilizer)))?,
    };
    commanded(scene, seen, port)
}

/// Rendering of the environment at the servo's rate, in one box with its hold, or with a port around it.
struct AtServoRate<'a, V: Signal> {
    scene: &'a Scene,
    around: Option<&'a AnyWrapper<V>>,
    seen: Option<&'a Seen<V>>,
}

impl<V: Space> Render<V> for AtServoRate<'_, V> {
    type Made = Port<V>;

    fn render(
        self,
        environment: impl ForceLaw<V> + 'static,
        _credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Port<V>, ParameterError> {
        let Self { scene, around, seen } = self;
        match around {
            None => received(scene, environment),
            Some(wrapper) => {
                let period = V::Scalar::of(scene.environment_ratio() as f64 * scene.period());
                received(scene, wrapper.around(Port::new(environment), period, seen)?)
            }
        }
    }
}

/// The environment's port as far as its answers arrive.
fn received<V: Space>(
    scene: &Scene,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    match scene.effects.dropout {
        None => held(scene, port),
        Some(dropout) => {
            let fallback = match dropout.policy {
                Policy::Hold => Fallback::Hold,
                Policy::Zero => Fallback::Zero,
            };
            let (probability, seed) = (of(dropout.probability), |_| dropout.seed.get());
            held(scene, Port::new(port.dropped(probability, fallback, seed)?))
        }
    }
}

fn held<V: Space>(
    scene: &Scene,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    // A scene has fewer ticks than this, so longer holds act alike.
    let ticks = u32::try_from(scene.environment_ratio()).unwrap_or(u32::MAX);
    Ok(if ticks > 1 { Port::new(port.held(ticks)?) } else { Port::new(port) })
}

/// The port whose efforts reach the plant clipped and delayed.
///
/// Neighbours share a box unless a recorder stands between them: every box costs a call through a table and a sample
/// that passes through memory.
fn commanded<V: Space>(
    scene: &Scene,
    seen: Option<&Seen<V>>,
    mut port: Port<V>,
) -> Result<Port<V>, ParameterError> {
    let delay = scene.effects.delay.map(|delay| usize::from(delay.ticks.get()));
    if let Some(saturation) = scene.effects.saturation {
        let clipped = port.saturated(of(saturation.force))?;
        port = match (seen, delay) {
            (Some(seen), _) => Port::new(seen.command(clipped)),
            (None, Some(ticks)) => return Ok(Port::new(clipped.delayed::<DELAY>(ticks)?)),
            (None, None) => Port::new(clipped),
        };
    } else if let Some(seen) = seen {
        port = Port::new(seen.command(port));
    }
    Ok(match delay {
        None => port,
        Some(ticks) => Port::new(port.delayed::<DELAY>(ticks)?),
    })
}

/// The port that measures the motion: velocity from positions, positions from an encoder, noise on top.
///
/// It wraps the stabilizer itself: saturation and delay pass samples on unchanged, so it does not matter that the
/// contract puts them farther in. Most scenes have a plain difference with or without an encoder: it shares a box with
/// the stabilizer. Every further combination would be compiled for every stabilizer.
pub(super) fn measured<V: Space>(
    scene: &Scene,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    let effects = &scene.effects;
    let resolution = effects.encoder.map(|encoder| encoder.resolution);
    let port = match (scene.velocity, effects.filter) {
        (Velocity::Exact, _) => counted(Port::new(port), resolution)?,
        (_, None) => counted(port.differenced(), resolution)?,
        (_, Some(filter)) => filtered(filter, Port::new(port), resolution)?,
    };
    Ok(match effects.noise {
        None => port,
        Some(noise) => Port::new(port.noisy(of(noise.deviation), |_| noise.seed.get())?),
    })
}

fn filtered<V: Space>(
    filter: Filter,
    port: Port<V>,
    resolution: Option<Positive>,
) -> Result<Port<V>, ParameterError> {
    match filter {
        Filter::Cutoff(cutoff) => counted(port.low_passed(of(cutoff))?, resolution),
        Filter::Window(ticks) => {
            // A straight motion and its encoder counts differ by less than a step.
            let band = resolution.map_or(0.0, Positive::get);
            counted(port.windowed::<WINDOW>(ticks.get().into(), of(band))?, resolution)
        }
    }
}

/// The port behind an encoder, if there is one; both in one box.
fn counted<V: Space>(
    port: impl OnePort<V> + 'static,
    resolution: Option<Positive>,
) -> Result<Port<V>, ParameterError> {
    Ok(match resolution {
        None => Port::new(port),
        Some(resolution) => Port::new(port.encoded(of(resolution))?),
    })
}
