//! Integrators of a scene's plant.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Scalar;
use super::check::Conflict;
use super::quantity::{Positive, StepsPerTick};

/// The method that moves the plant from one tick to the next, and its accuracy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Integrator {
    /// The exact solution under the force held over the period.
    #[default]
    Exact,
    /// The semi-implicit Euler method, order 1.
    SemiImplicitEuler {
        /// Equal steps over each period.
        steps_per_tick: StepsPerTick,
    },
    /// The implicit midpoint rule, order 2.
    ImplicitMidpoint {
        /// Equal steps over each period.
        steps_per_tick: StepsPerTick,
    },
    /// The classical Runge-Kutta method, order 4.
    Rk4 {
        /// Equal steps over each period.
        steps_per_tick: StepsPerTick,
    },
    /// Dormand and Prince's pair of orders 5 and 4, with adaptive steps.
    Dopri5 {
        /// Largest estimated error of a step: absolute in m and m/s, and relative to the size of each position and
        /// velocity.
        tolerance: Positive,
    },
    /// Dormand and Prince's method of order 8, with adaptive steps.
    Dop853 {
        /// Largest estimated error of a step: absolute in m and m/s, and relative to the size of each position and
        /// velocity.
        tolerance: Positive,
    },
}

/// How the plant moves from one tick to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Integrator")]
pub(super) enum Method {
    /// The exact solution under the force held over the period.
    #[default]
    Exact,
    /// The semi-implicit Euler method, order 1, in `steps_per_tick` steps.
    SemiImplicitEuler,
    /// The implicit midpoint rule, order 2, in `steps_per_tick` steps.
    ImplicitMidpoint,
    /// The classical Runge-Kutta method, order 4, in `steps_per_tick` steps.
    Rk4,
    /// Dormand and Prince's pair of orders 5 and 4, steps by `tolerance`.
    Dopri5,
    /// Dormand and Prince's method of order 8, steps by `tolerance`.
    Dop853,
}

impl Integrator {
    /// The integrator given by three keys of a scene in `scalar`.
    pub(super) fn of(
        method: Method,
        steps: Option<StepsPerTick>,
        tolerance: Option<Positive>,
        scalar: Scalar,
    ) -> Result<Self, Conflict> {
        let stepped = |named: fn(StepsPerTick) -> Self| match tolerance {
            Some(_) => Err(astray("tolerance", method, "leave it out, or give `steps_per_tick`")),
            None => Ok(named(steps.unwrap_or_default())),
        };
        let adaptive = |named: fn(Positive) -> Self| match steps {
            Some(_) => Err(astray("steps_per_tick", method, "leave it out, or give `tolerance`")),
            None => Ok(named(tolerance.unwrap_or_else(|| default_tolerance(scalar)))),
        };
        match method {
            Method::Exact if steps.is_some() => Err(astray("steps_per_tick", method, FIXED)),
            Method::Exact if tolerance.is_some() => Err(astray("tolerance", method, ADAPTIVE)),
            Method::Exact => Ok(Self::Exact),
            Method::SemiImplicitEuler => {
                stepped(|steps_per_tick| Self::SemiImplicitEuler { steps_per_tick })
            }
            Method::ImplicitMidpoint => {
                stepped(|steps_per_tick| Self::ImplicitMidpoint { steps_per_tick })
            }
            Method::Rk4 => stepped(|steps_per_tick| Self::Rk4 { steps_per_tick }),
            Method::Dopri5 => adaptive(|tolerance| Self::Dopri5 { tolerance }),
            Method::Dop853 => adaptive(|tolerance| Self::Dop853 { tolerance }),
        }
    }

    /// The values of its three keys.
    pub(super) fn keys(self) -> (Method, Option<StepsPerTick>, Option<Positive>) {
        match self {
            Self::Exact => (Method::Exact, None, None),
            Self::SemiImplicitEuler { steps_per_tick } => {
                (Method::SemiImplicitEuler, Some(steps_per_tick), None)
            }
            Self::ImplicitMidpoint { steps_per_tick } => {
                (Method::ImplicitMidpoint, Some(steps_per_tick), None)
            }
            Self::Rk4 { steps_per_tick } => (Method::Rk4, Some(steps_per_tick), None),
            Self::Dopri5 { tolerance } => (Method::Dopri5, None, Some(tolerance)),
            Self::Dop853 { tolerance } => (Method::Dop853, None, Some(tolerance)),
        }
    }

    /// The conflict of an integrator that cannot follow the motion over one period.
    pub(super) fn overtaxed(self, scalar: &str) -> Conflict {
        let (limit, remedy) = match self.tolerance() {
            Some(_) => ("it takes more than 100000 steps, or ", "give a larger `tolerance`"),
            None => ("it ", "give more `steps_per_tick`"),
        };
        Conflict::new(
            "integrator",
            format!(
                "`integrator` = \"{}\" cannot follow the motion within one period: {limit}leaves the range of {scalar}",
                self.name()
            ),
            format!(
                "take `integrator = \"exact\"`, or {remedy}; or give masses and stiffnesses nearer to 1"
            ),
        )
    }

    /// Its word in a scene file.
    pub fn name(self) -> &'static str {
        self.keys().0.word()
    }

    /// Equal steps over each period; none if it does not take such steps.
    pub fn steps_per_tick(self) -> Option<u32> {
        self.keys().1.map(StepsPerTick::get)
    }

    /// The tolerance; none if the integrator is not adaptive.
    pub fn tolerance(self) -> Option<f64> {
        self.keys().2.map(Positive::get)
    }
}

const FIXED: &str = "leave it out, or take `integrator` = \"semi-implicit-euler\", \"implicit-midpoint\" or \"rk4\"";

const ADAPTIVE: &str = "leave it out, or take `integrator` = \"dopri5\" or \"dop853\"";

impl Method {
    fn word(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::SemiImplicitEuler => "semi-implicit-euler",
            Self::ImplicitMidpoint => "implicit-midpoint",
            Self::Rk4 => "rk4",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
        }
    }
}

/// The conflict of a key that does not apply to `method`.
fn astray(key: &str, method: Method, remedy: &str) -> Conflict {
    let steps = match method {
        Method::Exact => "takes one step of any length",
        Method::Dopri5 | Method::Dop853 => "chooses its own steps by `tolerance`",
        _ => "takes equal steps",
    };
    Conflict::new(
        key,
        format!("`{key}` does not apply: `integrator` = \"{}\" {steps}", method.word()),
        remedy,
    )
}

/// The tolerance of an adaptive integrator for which the scene gives none.
fn default_tolerance(scalar: Scalar) -> Positive {
    const DOUBLE: Positive = Positive::known(1e-9);
    const SINGLE: Positive = Positive::known(1e-6);
    match scalar {
        Scalar::F64 => DOUBLE,
        Scalar::F32 => SINGLE,
    }
}
