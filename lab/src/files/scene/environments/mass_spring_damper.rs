//! A two-sided mass, spring and damper.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, Number, OnALine, Rates, StaticSpring, damped};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative};

/// A two-sided mass, spring and damper: f = m a + b v + k (x - position), a the difference of v from one environment tick
/// to the next over their interval.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MassSpringDamper {
    /// Position at which its spring is relaxed, in m; default 0.
    pub position: Finite,
    /// Mass m in kg, 0 or more; default 0.
    pub mass: NonNegative,
    /// Damping b in N.s/m; a negative one drives the motion; default 0.
    pub damping: Finite,
    /// Stiffness k in N/m, 0 or more; default 0.
    pub stiffness: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.mass-spring-damper",
        "",
        "[environment.mass-spring-damper]\nmass = 0.05  # kg\ndamping = 1.0  # N.s/m\nstiffness = 500.0  # N/m",
    ),
    key("environment.mass-spring-damper.position", "m", "position = 0.0  # m"),
    key("environment.mass-spring-damper.mass", "kg", "mass = 0.05  # kg"),
    key("environment.mass-spring-damper.damping", "N.s/m", "damping = 1.0  # N.s/m"),
    key("environment.mass-spring-damper.stiffness", "N/m", "stiffness = 500.0  # N/m"),
];

impl MassSpringDamper {
    fn parts<T: Scalar>(each: Lanes<'_, &Self>) -> Impedance<T> {
        Impedance {
            mass: each.each(|it| it.mass),
            damping: each.each(|it| it.damping),
            stiffness: each.each(|it| it.stiffness),
        }
    }
}

impl EnvironmentKind for MassSpringDamper {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(Self::parts(Lanes::new(&[self])))
    }

    fn static_spring(&self) -> Option<StaticSpring> {
        Some(StaticSpring::new(self.stiffness, self.position))
    }

    fn words(&self, number: Number) -> String {
        let rest = damped(number, self.stiffness, self.damping);
        format!("{} kg, {rest}", number(self.mass.get()))
    }
}

impl OnALine for MassSpringDamper {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        _rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let body = lyapunov::environments::MassSpringDamper::<T>::new(Self::parts(each))?
            .at(each.each(|it| it.position));
        to.render(body, body.dissipation())
    }
}
