//! Tuning as JSON.

use serde::Serialize;
use serde_json::{Map, Value};

use super::setting::Setting;
use super::study::{Tuned, Tuning};
use super::trial::Trial;
use crate::show::json;
use crate::simulate::ensemble::Moves;

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    objective: String,
    seed: u64,
    settings: u32,
    runs_of_each: u32,
    moved: Moves,
    stabilizers: Vec<Entry>,
}

#[derive(Serialize)]
struct Entry {
    stabilizer: &'static str,
    default: Judged,
    tuned: Judged,
    change: Option<[f64; 2]>,
    tuned_is: &'static str,
}

#[derive(Serialize)]
struct Judged {
    set: Map<String, Value>,
    runs: usize,
    bounded: usize,
    settle: usize,
    too_short: usize,
    mean_cost: Option<f64>,
}

impl Judged {
    fn of(setting: &Setting, trial: &Trial) -> Self {
        let set = setting.numbers().iter().map(|it| (it.key.to_owned(), Value::from(it.value)));
        Self {
            set: set.collect(),
            runs: trial.runs(),
            bounded: trial.bounded(),
            settle: trial.settle(),
            too_short: trial.too_short(),
            mean_cost: trial.cost(),
        }
    }
}

/// The results of `tuning` on the scene called `scene`, as JSON; docs/tune.md lists the keys.
pub fn document(scene: &str, tuning: &Tuning, tuned: &[Tuned]) -> String {
    let entry = |one: &Tuned| Entry {
        stabilizer: one.name.name(),
        default: Judged::of(&one.settings[0], &one.judged[0]),
        tuned: Judged::of(&one.settings[1], &one.judged[1]),
        change: one.judged[1].change_from(&one.judged[0]).map(|(change, half)| [change, half]),
        tuned_is: one.change().word(),
    };
    let document = Document {
        scene,
        objective: tuning.objective.to_string(),
        seed: tuning.seed,
        settings: tuning.trials + 1,
        runs_of_each: tuning.runs,
        moved: tuning.moved(tuned),
        stabilizers: tuned.iter().map(entry).collect(),
    };
    json::text(&document)
}
