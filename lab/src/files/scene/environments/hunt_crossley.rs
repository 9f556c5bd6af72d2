//! A one-sided wall after Hunt and Crossley.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{EnvironmentKind, Number, OnALine, Rates, spring_and_damper};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative, Positive};

/// A one-sided wall after Hunt and Crossley: f = max(0, k p^e (1 + damping v)) for the depth p = x - position > 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HuntCrossley {
    /// Position of the surface in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Stiffness k in N/m^e, 0 or more; required.
    pub stiffness: NonNegative,
    /// Exponent e, greater than 0: 1.5 for a ball on a flat surface; required.
    pub exponent: Positive,
    /// Damping in s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.hunt-crossley",
        "",
        "[environment.hunt-crossley]\nstiffness = 2e5  # N/m^e\nexponent = 1.5",
    ),
    key("environment.hunt-crossley.position", "m", "position = 0.0  # m"),
    key("environment.hunt-crossley.stiffness", "N/m^e", "stiffness = 2e5  # N/m^e"),
    key("environment.hunt-crossley.exponent", "", "exponent = 1.5"),
    key("environment.hunt-crossley.damping", "s/m", "damping = 0.5  # s/m"),
];

impl EnvironmentKind for HuntCrossley {
    fn impedance(&self) -> Option<Impedance<f64>> {
        // The damper does not act at the surface, where the depth is 0.
        (self.exponent.get() == 1.0).then(|| spring_and_damper(self.stiffness, 0.0))
    }

    fn steepest(&self) -> Option<Impedance<f64>> {
        self.impedance().filter(|_| self.damping.get() == 0.0)
    }

    fn impedance_note(&self) -> Option<&'static str> {
        let note = "the wall's damper grows with the depth and is left out, as at the surface";
        self.impedance().map(|_| note)
    }

    fn is_double(&self) -> bool {
        true
    }

    fn words(&self, number: Number) -> String {
        let (exponent, damping) = (number(self.exponent.get()), number(self.damping.get()));
        format!("{} N/m^{exponent}, {damping} s/m", number(self.stiffness.get()))
    }
}

impl OnALine for HuntCrossley {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        _rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let (stiffness, exponent) = (each.each(|it| it.stiffness), each.each(|it| it.exponent));
        let wall = lyapunov::environments::HuntCrossley::new(
            stiffness,
            exponent,
            each.each(|it| it.damping),
        )?;
        let wall = wall.at(each.each(|it| it.position));
        to.render(wall, wall.dissipation())
    }
}
