//! The closed loop of a scene, tick by tick.

use lyapunov::{Adapt, Body, Drive, Impedance, OnePort, ParameterError, Plant, Scalar, Stabilizer};

use crate::port::Tap;
use crate::scene::{Environment, Scene, Velocity};
use crate::stabilizer::wall;
use crate::{AnyStabilizer, Port};

/// Room for the delay of a scene, in ticks.
const DELAY: usize = 1024;

/// One servo tick, in SI units: the columns of `lyapunov run --csv`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Time, s.
    pub t: f64,
    /// The plant's true position, m.
    pub x: f64,
    /// The position as measured, m.
    pub x_measured: f64,
    /// The velocity as estimated, m/s.
    pub v: f64,
    /// The environment's force, N.
    pub f_env: f64,
    /// The controller's force, N.
    pub f_ctl: f64,
    /// The force commanded, after saturation, N.
    pub f_out: f64,
    /// The force on the plant until the next tick, after delay, N.
    pub f_act: f64,
    /// The observer sum before this tick's correction, J.
    pub observer: f64,
    /// The damping injected, N·s/m.
    pub alpha: f64,
    /// The debt that this tick's correction cannot serve, J.
    pub shortfall: f64,
    /// Whether the stabilizer accepted the sample.
    pub accepted: bool,
}

impl Row {
    /// The numbers of the row, in the order of the columns, without the last.
    pub(crate) fn numbers(&self) -> [f64; 11] {
        [
            self.t,
            self.x,
            self.x_measured,
            self.v,
            self.f_env,
            self.f_ctl,
            self.f_out,
            self.f_act,
            self.observer,
            self.alpha,
            self.shortfall,
        ]
    }

    fn in_range(&self) -> bool {
        self.accepted && self.numbers().iter().all(|number| number.is_finite())
    }
}

/// The rows of a scene, from tick 0 to the last, computed as they are asked for.
///
/// Ends early, after the last tick on which everything is finite, if the motion leaves the range of the scalar.
#[derive(Debug)]
pub struct Rollout<T: Scalar = f64> {
    rate: f64,
    tick: u64,
    last: u64,
    plant: Body<T>,
    port: Port<T>,
    environment: Tap<T>,
    command: Tap<T>,
    drive: Drive<T>,
}

impl<T: Scalar> Rollout<T> {
    /// The loop of `scene` with the stabilizer it names, in the scalar `T` whatever the scene says of it.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of `T`, alone or together with others.
    pub fn of(scene: &Scene) -> Result<Self, ParameterError> {
        match AnyStabilizer::of(scene)? {
            None => Self::assemble(scene, Ok),
            Some(stabilizer) => Self::stabilized_by(scene, stabilizer),
        }
    }

    /// The loop of `scene` with `stabilizer` in the place of the scene's own.
    ///
    /// # Errors
    /// As [`Rollout::of`].
    pub fn stabilized_by(
        scene: &Scene,
        stabilizer: impl Stabilizer<T> + 'static,
    ) -> Result<Self, ParameterError> {
        Self::assemble(scene, |port| Ok(Port::new(port.stabilized(stabilizer))))
    }

    /// What the plant tells of the coming tick, before anything measures it.
    pub(crate) fn drive(&self) -> &Drive<T> {
        &self.drive
    }

    /// What stood before the stabilizer on the last tick: the drive as measured, and the environment's effort.
    pub(crate) fn seen(&self) -> Option<(Drive<T>, T)> {
        self.environment.get()
    }

    fn assemble(
        scene: &Scene,
        stabilize: impl FnOnce(Port<T>) -> Result<Port<T>, ParameterError>,
    ) -> Result<Self, ParameterError> {
        let (environment, command) = (Tap::default(), Tap::default());
        let Environment::Wall(parameters) = scene.environment;
        let mut port = Port::new(wall::<T>(parameters)?);
        if scene.environment_ratio() > 1 {
            // A scene has fewer ticks than this, so a longer hold is the same hold.
            let ticks = u32::try_from(scene.environment_ratio()).unwrap_or(u32::MAX);
            port = Port::new(port.held(ticks)?);
        }
        port = stabilize(port.tapped(&environment))?;
        if let Some(saturation) = scene.effects.saturation {
            port = Port::new(port.saturated(T::of(saturation.force.get()))?);
        }
        port = port.tapped(&command);
        if let Some(delay) = scene.effects.delay {
            port = Port::new(port.delayed::<DELAY>(delay.ticks.get().into())?);
        }
        if scene.velocity == Velocity::BackwardDifference {
            port = Port::new(port.differenced());
        }
        if let Some(encoder) = scene.effects.encoder {
            port = Port::new(port.encoded(T::of(encoder.resolution.get()))?);
        }
        let plant = body(scene)?;
        let (rate, last, drive) = (scene.servo_rate.get(), scene.ticks(), plant.start());
        Ok(Self { rate, tick: 0, last, plant, port, environment, command, drive })
    }

    fn row(&mut self) -> Option<Row> {
        let acted = self.port.respond(&self.drive);
        let action = self.port.action();
        let (measured, environment) = self.environment.get()?;
        let (_, command) = self.command.get()?;
        let row = Row {
            t: self.tick as f64 / self.rate,
            x: self.drive.position.lane(0),
            x_measured: measured.position.lane(0),
            v: measured.velocity.lane(0),
            f_env: environment.lane(0),
            f_ctl: (action.alpha * measured.velocity).lane(0),
            f_out: command.lane(0),
            f_act: acted.lane(0),
            observer: action.sum.lane(0),
            alpha: action.alpha.lane(0),
            shortfall: action.shortfall.lane(0),
            accepted: lyapunov::Mask::all(action.accepted),
        };
        self.drive = self.plant.advance(acted);
        row.in_range().then_some(row)
    }
}

impl<T: Scalar> Iterator for Rollout<T> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        if self.tick > self.last {
            return None;
        }
        let row = self.row();
        self.tick = if row.is_some() { self.tick + 1 } else { u64::MAX };
        row
    }
}

fn body<T: Scalar>(scene: &Scene) -> Result<Body<T>, ParameterError> {
    let operator = Impedance {
        mass: scene.operator.mass.get(),
        damping: scene.operator.damping.get(),
        stiffness: scene.operator.stiffness.get(),
    };
    let device = Impedance {
        mass: scene.device.mass.get(),
        damping: scene.device.damping.get(),
        stiffness: 0.0,
    };
    let Impedance { mass, damping, stiffness } = operator + device;
    let joined =
        Impedance { mass: T::of(mass), damping: T::of(damping), stiffness: T::of(stiffness) };
    let body = Body::new(joined, T::of(scene.period()))?;
    let start = (T::of(scene.initial.position.get()), T::of(scene.initial.velocity.get()));
    Ok(body.resting_at(T::of(scene.operator.rest.get())).starting(start.0, start.1))
}
