//! The keys of a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::check::Conflict;
use super::integrator::Method;
use super::{
    Device, Draft, Effects, Environment, Initial, Integrator, Link, Operator, Positive, Scalar,
    Space, Stabilizer, StepsPerTick, Velocity,
};

/// The keys of a scene file, three of which give one value of a [`Draft`]: its integrator.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    title = "A scene of lyapunov",
    description = "One simulated run: an operator's hand and a device, an environment at the port, at most one \
                   stabilizer, and what else is simulated of the sampled loop. SI units."
)]
pub(crate) struct Keys {
    /// Simulated time in s, greater than 0; required.
    duration: Positive,
    /// Rate of the servo loop in Hz, greater than 0; required.
    servo_rate: Positive,
    /// Rate at which the environment is evaluated in Hz, the servo rate divided by a whole number; default: the servo
    /// rate.
    #[serde(default)]
    environment_rate: Option<Positive>,
    /// Source of the velocity; default: backward difference.
    #[serde(default)]
    velocity: Velocity,
    /// Number type the run computes in; default: f64.
    #[serde(default)]
    scalar: Scalar,
    /// Propagation of the plant between two ticks; default: exact.
    #[serde(default)]
    integrator: Method,
    /// Equal steps from one tick to the next, a whole number from 1 to 1000000, of an integrator that takes such;
    /// default: 1.
    #[serde(default)]
    steps_per_tick: Option<StepsPerTick>,
    /// Most estimated error of each step of an adaptive integrator, greater than 0: in m and m/s, plus as much of the
    /// size of each place and velocity; default: 1e-9, with scalar f32 1e-6.
    #[serde(default)]
    tolerance: Option<Positive>,
    /// The operator's hand; default: all zero.
    #[serde(default)]
    operator: Operator,
    /// The haptic device; required.
    device: Device,
    /// Elastic joint of the two; default: they move as one.
    #[serde(default)]
    link: Option<Link>,
    /// The space that the scene is in; default: a line.
    #[serde(default)]
    space: Option<Space>,
    /// State of the plant at t = 0; default: at rest at 0.
    #[serde(default)]
    initial: Initial,
    /// Environment that the device touches, exactly one; required.
    environment: Environment,
    /// Stabilizer, which keeps the loop bounded; default: none.
    #[serde(default)]
    stabilizer: Option<Stabilizer>,
    /// Imperfections of the loop; default: none.
    #[serde(default)]
    effects: Effects,
}

impl TryFrom<Keys> for Draft {
    type Error = Conflict;

    fn try_from(keys: Keys) -> Result<Self, Conflict> {
        let Keys { integrator, steps_per_tick, tolerance, scalar, .. } = keys;
        Ok(Self {
            integrator: Integrator::of(integrator, steps_per_tick, tolerance, scalar)?,
            duration: keys.duration,
            servo_rate: keys.servo_rate,
            environment_rate: keys.environment_rate,
            velocity: keys.velocity,
            scalar,
            operator: keys.operator,
            device: keys.device,
            link: keys.link,
            space: keys.space,
            initial: keys.initial,
            environment: keys.environment,
            stabilizer: keys.stabilizer,
            effects: keys.effects,
        })
    }
}

impl From<Draft> for Keys {
    /// All keys with every default in place, for reports and for maps, which vary what is there.
    fn from(scene: Draft) -> Self {
        Self { stabilizer: with_cap(&scene), ..Self::of(scene) }
    }
}

impl Draft {
    /// The same scene to be written and read again: a cap that is left out stays left out, so that it follows a delay that
    /// is added later.
    pub fn as_written(&self) -> impl Serialize + use<> {
        Keys::of(self.clone())
    }
}

impl Keys {
    fn of(scene: Draft) -> Self {
        let (integrator, steps_per_tick, tolerance) = scene.integrator.keys();
        let dimensions = scene.dimensions();
        let Initial { position, velocity } = scene.initial;
        let initial = Initial {
            position: position.written_in(dimensions),
            velocity: velocity.written_in(dimensions),
        };
        let rest = scene.operator.rest.written_in(dimensions);
        let operator = Operator { rest, ..scene.operator };
        Self {
            integrator,
            steps_per_tick,
            tolerance,
            duration: scene.duration,
            servo_rate: scene.servo_rate,
            environment_rate: scene.environment_rate,
            velocity: scene.velocity,
            scalar: scene.scalar,
            operator,
            device: scene.device,
            link: scene.link,
            space: scene.space,
            initial,
            environment: scene.environment,
            stabilizer: scene.stabilizer,
            effects: scene.effects,
        }
    }
}

/// The stabilizer of `scene` with its cap in place, unless the scene has a delay that sets it.
fn with_cap(scene: &Draft) -> Option<Stabilizer> {
    let mut stabilizer = scene.stabilizer?;
    if scene.effects.delay.is_none() && scene.written_cap().is_none() {
        // The key allows every default, and a table without the key stays as it is.
        let _ = stabilizer.write("damping_cap", scene.default_cap());
    }
    Some(stabilizer)
}
