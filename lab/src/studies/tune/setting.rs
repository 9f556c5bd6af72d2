//! Numbers of a stabilizer that are tuned.

use lyapunov::ParameterError;

use crate::files::Scene;
use crate::files::scene::{Conflict, Parameter, Search, Spacing};
use crate::simulate::family::StabilizerName;
use crate::simulate::{Fitted, Space};
use crate::text::to_digits;

/// A stabilizer on a scene, with the values of the numbers that are tuned.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    stabilizer: StabilizerName,
    numbers: Vec<Number>,
}

/// A number with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// The key in the scene, with the table path.
    pub key: &'static str,
    /// The unit; empty if it has none.
    pub unit: &'static str,
    /// The value.
    pub value: f64,
    is_whole: bool,
    range: Search,
}

impl Number {
    fn of(parameter: &Parameter) -> Option<Self> {
        let Parameter { key, unit, is_whole, .. } = *parameter;
        let (value, range) = (parameter.value()?, parameter.search?);
        Some(Self { key, unit, value, is_whole, range })
    }

    /// The key without its table path.
    pub fn name(&self) -> &'static str {
        self.key.rsplit('.').next().unwrap_or(self.key)
    }

    /// Where the value lies in the range, from 0 to 1; the nearest end for one outside.
    fn place(&self) -> f64 {
        let Search { lower, upper, spacing } = self.range;
        let value = self.value.clamp(lower, upper);
        match spacing {
            Spacing::Linear => (value - lower) / (upper - lower),
            Spacing::Logarithmic => libm::log(value / lower) / libm::log(upper / lower),
        }
    }

    /// The number at `place` of its range, rounded to three digits so that a scene file can be read.
    fn at(&self, place: f64) -> Self {
        let Search { lower, upper, spacing } = self.range;
        let value = match spacing {
            Spacing::Linear => lower + place * (upper - lower),
            Spacing::Logarithmic => lower * libm::pow(upper / lower, place),
        };
        let value = if self.is_whole { value.round() } else { to_digits(value, 3) };
        Self { value: value.clamp(lower, upper), ..*self }
    }
}

impl Setting {
    /// `stabilizer` as `scene` sets it.
    pub(super) fn of(scene: &Scene, stabilizer: StabilizerName) -> Self {
        let parameters = stabilizer.parameters(scene);
        Self { stabilizer, numbers: parameters.iter().filter_map(Number::of).collect() }
    }

    /// The numbers that are tuned.
    pub fn numbers(&self) -> &[Number] {
        &self.numbers
    }

    /// The place in the unit cube.
    pub(super) fn place(&self) -> Vec<f64> {
        self.numbers.iter().map(Number::place).collect()
    }

    /// The setting at another place.
    pub(super) fn at(&self, place: &[f64]) -> Self {
        let numbers = self.numbers.iter().zip(place).map(|(number, place)| number.at(*place));
        Self { stabilizer: self.stabilizer, numbers: numbers.collect() }
    }

    /// The stabilizer on `scene`, which may be another than it was tuned on.
    ///
    /// # Errors
    /// Those of [`StabilizerName::on`].
    pub fn fitted<V: Space>(&self, scene: &Scene) -> Result<Fitted<V>, ParameterError> {
        let mut table = self.stabilizer.table(scene);
        if let Some(table) = &mut table {
            for number in &self.numbers {
                // Every value of a range is right.
                let _ = table.write(number.name(), number.value);
            }
        }
        Fitted::named(scene, table)
    }

    /// `scene` with this stabilizer and its numbers written out.
    ///
    /// # Errors
    /// Numbers that do not go together.
    pub(super) fn on(&self, scene: &Scene) -> Result<Scene, Conflict> {
        let numbers: Vec<_> = self.numbers.iter().map(|it| (it.name(), it.value)).collect();
        self.stabilizer.written_in(scene, &numbers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(lower: f64, upper: f64, spacing: Spacing) -> Number {
        let range = Search { lower, upper, spacing };
        Number { key: "a.b", unit: "", value: lower, is_whole: false, range }
    }

    /// A credit is searched from a thousandth to ten times of the energy of the start, `(m v² + k x²) / 2`.
    #[test]
    fn a_range_is_about_the_value_that_it_searches_from() {
        let text = "duration = 1.0\nservo_rate = 1000.0\ndevice = { mass = 0.2, damping = 1.0 }\n\
            operator = { mass = 0.1, stiffness = 50.0 }\n\
            initial = { position = -0.004, velocity = 0.02 }\n\
            environment.wall.stiffness = 2000.0\n";
        let scene = Scene::parse(text, "test").unwrap();
        let energy: f64 = 0.5 * (0.3 * 0.02_f64.powi(2) + 50.0 * 0.004_f64.powi(2));
        let mut credits = 0;
        for member in StabilizerName::ALL {
            for number in Setting::of(&scene, member).numbers {
                let Search { lower, upper, .. } = number.range;
                assert!(0.0 <= lower && lower < upper && upper.is_finite(), "{number:?}");
                assert!(
                    number.value.is_infinite() || (lower..=upper).contains(&number.value),
                    "{number:?}"
                );
                if number.name() == "credit" {
                    credits += 1;
                    for (end, share) in [(lower, 1e-3), (upper, 10.0)] {
                        assert!((end / (share * energy) - 1.0).abs() < 1e-12, "{number:?}");
                    }
                }
            }
        }
        assert!(credits > 0);
    }

    #[test]
    fn a_place_and_its_value_belong_together() {
        let ratios = number(0.01, 100.0, Spacing::Logarithmic);
        assert_eq!([0.0, 0.25, 0.5, 1.0].map(|at| ratios.at(at).value), [0.01, 0.1, 1.0, 100.0]);
        assert!((ratios.at(0.25).place() - 0.25).abs() < 1e-12);
        let steps = number(2.0, 6.0, Spacing::Linear);
        assert_eq!([0.0, 0.25, 1.0].map(|at| steps.at(at).value), [2.0, 3.0, 6.0]);
        let whole = Number { is_whole: true, ..steps };
        assert_eq!(whole.at(0.3).value, 3.0);
        let endless = Number { value: f64::INFINITY, ..ratios };
        assert_eq!(endless.place(), 1.0);
    }
}
