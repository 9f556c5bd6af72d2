//! JSON document of model comparisons: `compare.json`.

use serde::Serialize;

use super::comparison::Comparison;
use crate::measure::models::{BAND, BOUND, Score};
use crate::show::json;

#[derive(Serialize)]
struct Document<'a> {
    /// The largest V of a run that does not grow, as a multiple of V at the start.
    bound: f64,
    /// The largest V in the last tenth of a run that settles, likewise.
    band: f64,
    models: Vec<Circumstances<'a>>,
    rows: Vec<Line<'a>>,
    /// The files that did not fit, with the reasons.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    left_out: &'a [String],
}

/// Values that all rows of a model share.
#[derive(Serialize)]
struct Circumstances<'a> {
    model: &'a str,
    plant: &'static str,
    v_start: f64,
    v_unit: &'static str,
    effort_unit: &'static str,
    /// None: no limit.
    damping_cap: Option<f64>,
    decay_per_s: f64,
}

#[derive(Serialize)]
struct Line<'a> {
    model: &'a str,
    #[serde(flatten)]
    score: &'a Score,
}

/// The comparisons as JSON, and the files that were `left_out` with the reasons; docs/any-plant.md lists the keys.
pub(super) fn of(comparisons: &[Comparison], left_out: &[String]) -> String {
    let models = comparisons.iter().map(|Comparison { name, model, began, .. }| {
        let (plant, cap) = (&model.plant, model.stabilizer.damping_cap.get());
        Circumstances {
            model: name,
            plant: plant.name(),
            v_start: *began,
            v_unit: plant.unit_of_value(),
            effort_unit: plant.unit_of_input(),
            damping_cap: cap.is_finite().then_some(cap),
            decay_per_s: model.stabilizer.decay.get(),
        }
    });
    let rows = comparisons.iter().flat_map(|comparison| {
        comparison.scores().map(|score| Line { model: &comparison.name, score })
    });
    let document = Document {
        bound: BOUND,
        band: BAND,
        models: models.collect(),
        rows: rows.collect(),
        left_out,
    };
    json::text(&document)
}
