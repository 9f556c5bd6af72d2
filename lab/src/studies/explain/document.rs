//! Explanation as JSON.

use serde::Serialize;
use serde_json::{Map, Value};

use super::hint::broken;
use super::{Change, DimensionlessGroups, Explanation, Remedy};
use crate::measure::{Balance, Oddity, Verdict, Yardstick};
use crate::show::json;

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    verdict: Verdict,
    verdict_by: Yardstick,
    spectral_radius: Option<f64>,
    groups: DimensionlessGroups,
    broken: Vec<Broken>,
    /// The limit of the damping cap for the delay, m / T, where the cap lies above it.
    #[serde(skip_serializing_if = "Option::is_none")]
    damping_cap_limit: Option<f64>,
    first_contact: Option<Balance>,
    whole_run: Balance,
    remedies: Vec<Tried>,
    /// The reason why there are none.
    no_remedies: Option<String>,
    look_at: &'a [Oddity],
}

#[derive(Serialize)]
struct Broken {
    limit: &'static str,
    most: f64,
    times: Option<f64>,
}

#[derive(Serialize)]
struct Tried {
    set: Map<String, Value>,
    verdict: Verdict,
    peak_force_n: f64,
    force_error_rms_n: Option<f64>,
}

impl Explanation {
    /// The explanation of the scene called `scene`, as JSON; docs/explain.md lists the keys.
    pub fn to_json(&self, scene: &str) -> String {
        let broken = broken(&self.limits).into_iter();
        let document = Document {
            scene,
            verdict: self.verdict,
            verdict_by: self.verdict_by,
            spectral_radius: self.limits.spectral_radius,
            groups: self.groups,
            broken: broken.map(|(limit, _, most, times)| Broken { limit, most, times }).collect(),
            damping_cap_limit: self.scene.exceeded_cap(),
            first_contact: self.first_contact,
            whole_run: self.whole_run,
            remedies: self.remedies.iter().map(tried).collect(),
            no_remedies: self.lack(),
            look_at: &self.look_at,
        };
        json::text(&document)
    }
}

fn tried(remedy: &Remedy) -> Tried {
    let value = |change: &Change| match change {
        Change::Number(number) => Value::from(*number),
        Change::Word(word) => Value::from(*word),
    };
    let mut set = Map::new();
    for (key, change) in &remedy.changes {
        set.insert(key.clone(), value(change));
    }
    Tried {
        set,
        verdict: remedy.verdict,
        peak_force_n: remedy.peak_force,
        force_error_rms_n: remedy.force_error,
    }
}
