//! JSON document of comparisons: `compare.json`.

use serde::Serialize;

use super::look_at::LookAt;
use super::score::Score;
use super::{Broken, Comparison};
use crate::measure::Yardstick;
use crate::show::json;
use crate::simulate::Criterion;

#[derive(Serialize)]
struct Document<'a> {
    /// The keys of a row that come from a clock.
    not_deterministic: [&'static str; 1],
    scenes: Vec<Circumstances<'a>>,
    rows: Vec<Line<'a>>,
    broken: Broken,
    /// The files that did not fit, with the reasons.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    left_out: &'a [String],
}

/// Values that all rows of a scene share.
#[derive(Serialize)]
struct Circumstances<'a> {
    scene: &'a str,
    verdict_by: Yardstick,
    stiffness_asked_n_per_m: Option<f64>,
    work: &'static str,
    /// None: no limit.
    damping_cap: Option<f64>,
    settings_from_scene: bool,
    /// The limit of the cap for the delay, m / T, where the cap lies above it.
    #[serde(skip_serializing_if = "Option::is_none")]
    damping_cap_limit: Option<f64>,
    look_at: Vec<LookAt<'a>>,
}

#[derive(Serialize)]
struct Line<'a> {
    scene: &'a str,
    #[serde(flatten)]
    score: &'a Score,
}

/// The comparisons as JSON, and the files that were `left_out` with the reasons; docs/compare.md lists the keys.
pub fn document(comparisons: &[Comparison], left_out: &[String]) -> String {
    let circumstances = |comparison: &'_ Comparison| {
        let cap = comparison.settings.damping_cap;
        (comparison.scene.environment.surface_stiffness(), cap.is_finite().then_some(cap))
    };
    let scenes = comparisons.iter().map(|comparison| {
        let (stiffness_asked_n_per_m, damping_cap) = circumstances(comparison);
        Circumstances {
            scene: &comparison.name,
            verdict_by: Yardstick::of(&Criterion::of(&comparison.scene)),
            stiffness_asked_n_per_m,
            work: comparison.settings.work_name(),
            damping_cap,
            settings_from_scene: comparison.settings.from_scene,
            damping_cap_limit: comparison.scene.exceeded_cap(),
            look_at: LookAt::of(comparison),
        }
    });
    let rows = comparisons.iter().flat_map(|comparison| {
        comparison.scores().map(|score| Line { scene: &comparison.name, score })
    });
    let document = Document {
        not_deterministic: ["ns_per_step"],
        scenes: scenes.collect(),
        rows: rows.collect(),
        broken: Broken::of(comparisons),
        left_out,
    };
    json::text(&document)
}
