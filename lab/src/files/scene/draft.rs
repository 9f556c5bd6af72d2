//! The values of a scene, checked or not.

use serde::{Deserialize, Serialize};

use super::written::Keys;
use super::{
    Device, Effects, Environment, Initial, Integrator, Link, Operator, Positive, Scalar, Space,
    Stabilizer, Velocity,
};

/// One simulated run: two bodies that move as one, an environment at the port, at most one stabilizer, and the effects
/// of the sampled loop.
///
/// The type of each value holds the rule of that value; [`Draft::check`] checks the rules between values and makes a
/// [`Scene`](super::Scene).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Keys", into = "Keys")]
pub struct Draft {
    /// Simulated time in s, greater than 0; required.
    pub duration: Positive,
    /// Rate of the servo loop in Hz, greater than 0; required.
    pub servo_rate: Positive,
    /// Rate at which the environment is evaluated in Hz, the servo rate divided by a whole number; default: the servo
    /// rate.
    pub environment_rate: Option<Positive>,
    /// Velocity source of the loop; default: backward difference.
    pub velocity: Velocity,
    /// Number type the run computes in; default: f64.
    pub scalar: Scalar,
    /// Integrator of the plant between two ticks; default: exact.
    pub integrator: Integrator,
    /// The operator's hand; default: all zero.
    pub operator: Operator,
    /// The haptic device; required.
    pub device: Device,
    /// Link between operator and device; default: they move as one.
    pub link: Option<Link>,
    /// Space of the scene; default: a line.
    pub space: Option<Space>,
    /// State of the plant at t = 0; default: at rest at 0.
    pub initial: Initial,
    /// Environment that the device touches, exactly one; required.
    pub environment: Environment,
    /// Stabilizer, which keeps the loop bounded; default: none.
    pub stabilizer: Option<Stabilizer>,
    /// Imperfections of the loop; default: none.
    pub effects: Effects,
}

impl Draft {
    /// Number of the last tick, N = round(duration · servo_rate), from 0 to 1e9; the run has N + 1 ticks.
    pub fn ticks(&self) -> u64 {
        // The conversion saturates, so that an unchecked draft cannot panic here.
        (self.duration.get() * self.servo_rate.get()).round() as u64
    }

    /// Time of the last tick, N / servo_rate, in s.
    pub fn end(&self) -> f64 {
        self.ticks() as f64 / self.servo_rate.get()
    }

    /// Servo period T = 1 / servo_rate, in s.
    pub fn period(&self) -> f64 {
        self.servo_rate.get().recip()
    }

    /// Rate at which the environment is evaluated, in Hz, with its default in place.
    pub fn environment_rate(&self) -> f64 {
        self.environment_rate.unwrap_or(self.servo_rate).get()
    }

    /// Servo ticks from one evaluation of the environment to the next, r = servo_rate / environment_rate, at least 1.
    pub fn environment_ratio(&self) -> u64 {
        (self.servo_rate.get() / self.environment_rate()).round() as u64
    }

    /// One count of the encoder where the velocity is the plain difference of two of its positions, m.
    pub fn plain_count(&self) -> Option<f64> {
        let is_plain =
            self.velocity == Velocity::BackwardDifference && self.effects.filter.is_none();
        self.effects.encoder.filter(|_| is_plain).map(|it| it.resolution.get())
    }

    /// Dimensions of the space: 1, 2 or 3.
    pub fn dimensions(&self) -> usize {
        self.space.map_or(1, |space| space.dimensions.get().into())
    }

    /// The first tick at which an event at an instant in s has taken effect: ceil(instant servo_rate - 1e-9).
    pub fn tick_of(&self, instant: f64) -> u64 {
        lyapunov::trajectories::tick_of(instant, self.servo_rate.get())
    }
}
