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
use super::{AnyPlant, AnyStabilizer, AnyWrapper, Fitted, Port, Scenes, Space};
use crate::files::scene::{Filter, Pace, Policy, Render, Scene, Velocity};

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
        Self::on(Scenes::of(scene))
    }

    /// The loop of the scenes, alike in all but numbers, with the stabilizers they name.
    ///
    /// # Errors
    /// As [`Assembly::of`].
    pub(crate) fn on(scenes: Scenes<'_>) -> Result<Self, ParameterError> {
        let tables: Vec<_> = scenes.values().iter().map(|scene| scene.stabilizer).collect();
        Self::put_together(scenes, None, Fitted::on(scenes, &tables)?)
    }

    /// The loop of `scene` with `stabilizer` instead of the scene's own.
    ///
    /// # Errors
    /// As [`Assembly::of`].
    pub fn stabilized_by(
        scene: &Scene,
        stabilizer: AnyStabilizer<V>,
    ) -> Result<Self, ParameterError> {
        Self::put_together(Scenes::of(scene), None, Fitted::Behind(stabilizer))
    }

    /// One tick; returns the effort that acts until the next.
    #[inline]
    pub fn tick(&mut self, sample: &mut PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        self.plant.advance_into(effort, sample);
        effort
    }

    /// The loop of the scenes behind what is `fitted`; `seen`, if any, records what the stabilizer and the port do.
    ///
    /// # Errors
    /// As [`Assembly::of`].
    pub(crate) fn put_together(
        scenes: Scenes<'_>,
        seen: Option<&Seen<V>>,
        fitted: Fitted<V>,
    ) -> Result<Self, ParameterError> {
        let port = V::port(scenes, fitted, seen)?;
        let unseen = Operator::default();
        let plant = V::plant(scenes, seen.map_or(&unseen, |seen| &seen.operator))?;
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
        let scenes = Scenes::of(scene);
        let port = V::port(scenes, Fitted::of(scene)?, None)?;
        let plant = stepped(scenes, &Operator::default(), integrator, 1)?;
        Ok(Self { plant, port })
    }
}

/// The port that answers the motion, stabilizer and effects included.
pub(super) fn answering<V: Space>(
    scenes: Scenes<'_>,
    seen: Option<&Seen<V>>,
    fitted: Fitted<V>,
) -> Result<Port<V>, ParameterError> {
    let around = fitted.around(Pace::Environment);
    let port = V::render(scenes, AtServoRate { scenes, around, seen })?;
    let (port, stabilizer) = match fitted {
        Fitted::Behind(stabilizer) => (port, stabilizer),
        Fitted::Around(wrapper) => {
            let port = match wrapper.pace() {
                Pace::Environment => port,
                Pace::Servo => {
                    wrapper.around(port, V::Scalar::of(scenes.common().period()), seen)?
                }
            };
            (port, AnyStabilizer::called(Passing))
        }
    };
    let port = match seen {
        None => stabilizer.on(port, scenes)?,
        Some(seen) => measured(scenes, port.stabilized(seen.stabilizer(stabilizer)))?,
    };
    commanded(scenes, seen, port)
}

/// Rendering of the environment at the servo's rate, in one box with its hold, or with a port around it.
struct AtServoRate<'a, V: Signal> {
    scenes: Scenes<'a>,
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
        let Self { scenes, around, seen } = self;
        match around {
            None => received(scenes, scenes.part::<V, _>(environment)),
            Some(wrapper) => {
                let period = V::Scalar::of(
                    scenes.common().environment_ratio() as f64 * scenes.common().period(),
                );
                received(scenes, wrapper.around(scenes.port(environment), period, seen)?)
            }
        }
    }
}

/// The environment's port as far as its answers arrive.
fn received<V: Space>(
    scenes: Scenes<'_>,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    match scenes.common().effects.dropout {
        None => held(scenes, port),
        Some(dropout) => {
            let fallback = match dropout.policy {
                Policy::Hold => Fallback::Hold,
                Policy::Zero => Fallback::Zero,
            };
            let probability =
                scenes.each(|it| it.effects.dropout.map_or(0.0, |it| it.probability.get()));
            let dropout = |lane: usize| scenes.lane(lane).effects.dropout;
            let seed = |lane| dropout(lane).map_or(0, |it| it.seed.get());
            held(scenes, scenes.port(port.dropped(probability, fallback, seed)?))
        }
    }
}

fn held<V: Space>(
    scenes: Scenes<'_>,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    // A scene has fewer ticks than this, so longer holds act alike.
    let ticks = u32::try_from(scenes.common().environment_ratio()).unwrap_or(u32::MAX);
    Ok(if ticks > 1 { scenes.port(port.held(ticks)?) } else { scenes.port(port) })
}

/// The port whose efforts reach the plant clipped and delayed.
///
/// Neighbours share a box unless a recorder stands between them: every box costs a call through a table and a sample
/// that passes through memory.
fn commanded<V: Space>(
    scenes: Scenes<'_>,
    seen: Option<&Seen<V>>,
    mut port: Port<V>,
) -> Result<Port<V>, ParameterError> {
    let common = scenes.common();
    let delay = common.effects.delay.map(|delay| u32::from(delay.ticks.get()));
    if common.effects.saturation.is_some() {
        let force = |it: &Scene| it.effects.saturation.map_or(0.0, |it| it.force.get());
        let clipped = port.saturated(scenes.each(force))?;
        port = match (seen, delay) {
            (Some(seen), _) => scenes.port(seen.command(clipped)),
            (None, Some(ticks)) => return Ok(scenes.port(clipped.delayed::<DELAY>(ticks)?)),
            (None, None) => scenes.port(clipped),
        };
    } else if let Some(seen) = seen {
        port = scenes.port(seen.command(port));
    }
    Ok(match delay {
        None => port,
        Some(ticks) => scenes.port(port.delayed::<DELAY>(ticks)?),
    })
}

/// The port that measures the motion: velocity from positions, positions from an encoder, noise on top.
///
/// It wraps the stabilizer itself: saturation and delay pass samples on unchanged, so it does not matter that the
/// contract puts them farther in. Most scenes have a plain difference with or without an encoder: it shares a box with
/// the stabilizer. Every further combination would be compiled for every stabilizer.
pub(super) fn measured<V: Space>(
    scenes: Scenes<'_>,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    let effects = &scenes.common().effects;
    let port = match (scenes.common().velocity, effects.filter) {
        (Velocity::Exact, _) => counted(scenes, scenes.port(port))?,
        (_, None) => counted(scenes, scenes.part::<V, _>(port).differenced())?,
        (_, Some(filter)) => filtered(scenes, filter, scenes.port(port))?,
    };
    if effects.noise.is_none() {
        return Ok(port);
    }
    let noise = |lane: usize| scenes.lane(lane).effects.noise;
    let deviation = scenes.each(|it| it.effects.noise.map_or(0.0, |it| it.deviation.get()));
    Ok(scenes.port(port.noisy(deviation, |lane| noise(lane).map_or(0, |it| it.seed.get()))?))
}

fn filtered<V: Space>(
    scenes: Scenes<'_>,
    filter: Filter,
    port: Port<V>,
) -> Result<Port<V>, ParameterError> {
    match filter {
        Filter::Cutoff(_) => {
            let cutoff = scenes.each(|it| match it.effects.filter {
                Some(Filter::Cutoff(cutoff)) => cutoff.get(),
                _ => 0.0,
            });
            counted(scenes, port.low_passed(cutoff)?)
        }
        Filter::Window(ticks) => {
            // A straight motion and its encoder counts differ by less than a step.
            let band = scenes.each(resolution);
            counted(scenes, port.windowed::<WINDOW>(ticks.get().into(), band)?)
        }
    }
}

/// The step of the encoder; 0 without one.
fn resolution(scene: &Scene) -> f64 {
    scene.effects.encoder.map_or(0.0, |encoder| encoder.resolution.get())
}

/// The port behind an encoder, if there is one; both in one box.
fn counted<V: Space>(
    scenes: Scenes<'_>,
    port: impl OnePort<V> + 'static,
) -> Result<Port<V>, ParameterError> {
    Ok(match scenes.common().effects.encoder {
        None => scenes.port(port),
        Some(_) => scenes.port(port.encoded(scenes.each(resolution))?),
    })
}
