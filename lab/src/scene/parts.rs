//! The tables and words of a scene file.

use serde::{Deserialize, Serialize};

use super::quantity::{Cap, DelayTicks, Finite, NonNegative, Positive};

/// How the loop obtains the velocity v(n).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Velocity {
    /// v(n) = (xm(n) - xm(n-1)) / T from the measured position; 0 at n = 0.
    #[default]
    BackwardDifference,
    /// The plant's own velocity, untouched by the encoder, also at n = 0.
    Exact,
}

/// Number type that a run computes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scalar {
    /// Double precision.
    #[default]
    F64,
    /// Single precision.
    F32,
}

/// How the plant moves from one tick to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// The exact solution under the force held over the period.
    #[default]
    Exact,
}

/// The operator's hand: a mass, a damper and a spring to a point of rest, moving with the device as one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Operator {
    /// Mass in kg, 0 or more; default 0.
    pub mass: NonNegative,
    /// Damping in N·s/m, 0 or more; default 0.
    pub damping: NonNegative,
    /// Stiffness of the spring in N/m, 0 or more; default 0.
    pub stiffness: NonNegative,
    /// Position in m at which the spring is at rest; default 0.
    pub rest: Finite,
}

/// The haptic device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// Mass in kg, greater than 0; required.
    pub mass: Positive,
    /// Damping in N·s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

/// State of the plant at t = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Initial {
    /// Position in m; default 0.
    pub position: Finite,
    /// Velocity in m/s; default 0.
    pub velocity: Finite,
}

/// What the device touches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Environment {
    /// A one-sided wall.
    Wall(Wall),
}

/// A one-sided wall: f = max(0, k p + b v) for the depth p = x - position > 0, else 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// Position of the surface in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping b in N·s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

/// What watches the port and keeps the loop bounded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Stabilizer {
    /// The Lyapunov observer/controller.
    Lolc(Lolc),
    /// The passivity observer/controller.
    Popc(Popc),
}

/// The Lyapunov observer/controller, which credits what its candidate knows to be burnt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Lolc {
    /// How the port's work is booked; default: held.
    pub work: Work,
    /// What is credited beyond the port's work; default: the paper's mass-spring-damper.
    pub candidate: Candidate,
    /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5. A limit of 0 only
    /// observes.
    pub damping_cap: Cap,
}

/// The passivity observer/controller, whose candidate is the port's own energy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Popc {
    /// How the port's work is booked; default: held.
    pub work: Work,
    /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5. A limit of 0 only
    /// observes.
    pub damping_cap: Cap,
}

/// How the work at the port is booked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Work {
    /// f_act(n-1) · dx(n): what crossed the port under a held force.
    #[default]
    Held,
    /// (f_env(n) v(n) + alpha(n-1) v(n-1)²) T: the paper's step 4.
    Sampled,
}

/// What a Lyapunov observer credits beyond the port's work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Candidate {
    /// The wall's damping b v² T while the device is beyond the surface; the paper's.
    #[default]
    MassSpringDamper,
    /// The device's own damping b v² T at every tick.
    DeviceDamping,
    /// Nothing.
    Spring,
}

/// Imperfections of the loop; one that is absent is not simulated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Effects {
    /// The position is measured in steps.
    pub encoder: Option<Encoder>,
    /// The force acts late.
    pub delay: Option<Delay>,
    /// The force is limited.
    pub saturation: Option<Saturation>,
}

/// A position measured in steps: round(x / resolution) · resolution, ties away from zero.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Encoder {
    /// Size of a step in m, greater than 0; required.
    pub resolution: Positive,
}

/// A force that acts some ticks after it was commanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Delay {
    /// Delay in servo ticks, a whole number from 0 to 1024; required.
    pub ticks: DelayTicks,
}

/// A force limited to the same size in both directions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Saturation {
    /// Largest force in N, greater than 0; required.
    pub force: Positive,
}
