//! A two-sided spring that hardens.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{
    EnvironmentKind, Number, OnALine, Rates, StaticSpring, no_credit, spring_and_damper,
};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative};

/// A two-sided spring that hardens, as Duffing's: f = k d + c d^3 for d = x - position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CubicSpring {
    /// Position at which it is relaxed, in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k at rest in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Cubic stiffness c in N/m^3, 0 or more; required.
    pub cubic: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.cubic-spring",
        "",
        "[environment.cubic-spring]\nstiffness = 200.0  # N/m\ncubic = 1e6  # N/m^3",
    ),
    key("environment.cubic-spring.position", "m", "position = 0.0  # m"),
    key("environment.cubic-spring.stiffness", "N/m", "stiffness = 200.0  # N/m"),
    key("environment.cubic-spring.cubic", "N/m^3", "cubic = 1e6  # N/m^3"),
];

impl EnvironmentKind for CubicSpring {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, 0.0))
    }

    fn steepest(&self) -> Option<Impedance<f64>> {
        self.impedance().filter(|_| self.cubic.get() == 0.0)
    }

    fn impedance_note(&self) -> Option<&'static str> {
        Some("the stiffness is that at rest; farther out the spring is stiffer")
    }

    fn static_spring(&self) -> Option<StaticSpring> {
        let straight = self.cubic.get() == 0.0;
        straight.then(|| StaticSpring::new(self.stiffness, self.position))
    }

    fn words(&self, number: Number) -> String {
        let (stiffness, cubic) = (number(self.stiffness.get()), number(self.cubic.get()));
        format!("{stiffness} N/m, {cubic} N/m^3")
    }
}

impl OnALine for CubicSpring {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        _rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let spring = lyapunov::environments::CubicSpring::<T>::new(
            each.each(|it| it.stiffness),
            each.each(|it| it.cubic),
        )?;
        to.render(spring.at(each.each(|it| it.position)), no_credit()?)
    }
}
