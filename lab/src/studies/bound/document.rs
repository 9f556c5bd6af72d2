//! Stiffness limits as JSON.

use serde::Serialize;

use crate::measure::Limits;
use crate::show::json;

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    stiffness: Option<f64>,
    passive_max_stiffness: Option<f64>,
    gil_max_stiffness: Option<f64>,
    friction_quantization_max_stiffness: Option<f64>,
    exact_max_stiffness: Option<f64>,
    exact_min_stiffness: Option<f64>,
    spectral_radius: Option<f64>,
    notes: &'a [String],
}

impl Limits {
    /// The limits of the scene called `scene`, as JSON; docs/command.md lists the keys.
    pub fn to_json(&self, scene: &str) -> String {
        let document = Document {
            scene,
            stiffness: self.stiffness,
            passive_max_stiffness: self.passive,
            gil_max_stiffness: self.gil,
            friction_quantization_max_stiffness: self.friction_quantization,
            exact_max_stiffness: self.exact,
            exact_min_stiffness: self.exact_from,
            spectral_radius: self.spectral_radius,
            notes: &self.notes,
        };
        json::text(&document)
    }
}
