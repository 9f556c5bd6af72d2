//! A two-sided spring.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{
    EnvironmentKind, Number, OnALine, Rates, StaticSpring, no_credit, spring_and_damper,
};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::Finite;

/// A two-sided spring: f = k (x - position).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Position at which it is relaxed, in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m; a negative one pushes away; required.
    pub stiffness: Finite,
}

pub(super) const KEYS: &[Key] = &[
    key("environment.spring", "", "[environment.spring]\nstiffness = 500.0  # N/m"),
    key("environment.spring.position", "m", "position = 0.0  # m"),
    key("environment.spring.stiffness", "N/m", "stiffness = 500.0  # N/m"),
];

impl EnvironmentKind for Spring {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, 0.0))
    }

    fn static_spring(&self) -> Option<StaticSpring> {
        Some(StaticSpring::new(self.stiffness, self.position))
    }

    fn words(&self, number: Number) -> String {
        format!("{} N/m", number(self.stiffness.get()))
    }
}

impl OnALine for Spring {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        _rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let spring = lyapunov::environments::Spring::<T>::new(each.each(|it| it.stiffness))?
            .at(each.each(|it| it.position));
        to.render(spring, no_credit()?)
    }
}
