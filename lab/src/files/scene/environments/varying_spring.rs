//! A two-sided spring whose stiffness swings.

use lyapunov::{ParameterError, Scalar, bodies::Impedance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kind::{
    EnvironmentKind, Number, OnALine, Rates, StaticSpring, no_credit, spring_and_damper, swinging,
};
use super::render::Render;
use crate::files::scene::Lanes;
use crate::files::scene::book::{Key, key};
use crate::files::scene::quantity::{Finite, NonNegative};

/// A two-sided spring whose stiffness swings: k(t) = stiffness + amplitude sin(2 pi frequency t).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VaryingSpring {
    /// Position at which it is relaxed, in m; default 0.
    #[serde(default)]
    pub position: Finite,
    /// Mean stiffness in N/m; required.
    pub stiffness: Finite,
    /// Amplitude of the stiffness in N/m; required.
    pub amplitude: Finite,
    /// Frequency of the stiffness in Hz, 0 or more; required.
    pub frequency: NonNegative,
}

pub(super) const KEYS: &[Key] = &[
    key(
        "environment.varying-spring",
        "",
        "[environment.varying-spring]\nstiffness = 500.0  # N/m\namplitude = 100.0  # N/m\nfrequency = 2.0  # Hz",
    ),
    key("environment.varying-spring.position", "m", "position = 0.0  # m"),
    key("environment.varying-spring.stiffness", "N/m", "stiffness = 500.0  # N/m"),
    key("environment.varying-spring.amplitude", "N/m", "amplitude = 100.0  # N/m"),
    key("environment.varying-spring.frequency", "Hz", "frequency = 2.0  # Hz"),
];

impl EnvironmentKind for VaryingSpring {
    fn impedance(&self) -> Option<Impedance<f64>> {
        Some(spring_and_damper(self.stiffness, 0.0))
    }

    fn steepest(&self) -> Option<Impedance<f64>> {
        let most = self.stiffness.get().abs() + self.amplitude.get().abs();
        Some(spring_and_damper(most, 0.0))
    }

    fn impedance_note(&self) -> Option<&'static str> {
        Some("the stiffness is the spring's mean; what swings may add energy of its own")
    }

    fn static_spring(&self) -> Option<StaticSpring> {
        Some(StaticSpring::new(self.stiffness, self.position))
    }

    fn frequency(&self) -> Option<f64> {
        swinging(self.amplitude, self.frequency)
    }

    fn words(&self, number: Number) -> String {
        let (stiffness, amplitude) = (number(self.stiffness.get()), number(self.amplitude.get()));
        format!("{stiffness} +- {amplitude} N/m at {} Hz", number(self.frequency.get()))
    }
}

impl OnALine for VaryingSpring {
    fn make<T: Scalar, R: Render<T>>(
        each: Lanes<'_, &Self>,
        rates: Rates,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let spring = lyapunov::environments::Spring::<T>::new(each.each(|it| it.stiffness))?
            .at(each.each(|it| it.position));
        let (amplitude, frequency) = (each.each(|it| it.amplitude), each.each(|it| it.frequency));
        let spring = lyapunov::environments::VaryingSpring::new(
            spring,
            amplitude,
            frequency,
            T::of(rates.environment),
        )?;
        to.render(spring, no_credit()?)
    }
}
