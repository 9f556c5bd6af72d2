//! Description of a file of rows: where it comes from, and its columns.

use serde::Serialize;

use super::csv::COLUMNS;
use super::json;
use crate::files::Scene;
use crate::simulate::row::further_columns;

/// Description of a file of the rows of a run: the program, the scene, the seeds, the columns.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RowFile {
    /// The version of the program that wrote it.
    pub lyapunov: &'static str,
    /// The scene with every default in place, TOML.
    pub scene: String,
    /// The seeds of its random effects.
    pub seeds: Seeds,
    /// The columns, in their order.
    pub columns: Vec<RowColumn>,
}

/// The seeds of the random effects of a scene; none of those that it does not have.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Seeds {
    /// Of the noise on the position.
    pub noise: Option<u64>,
    /// Of the jitter of the period.
    pub jitter: Option<u64>,
    /// Of the answers that are lost.
    pub dropout: Option<u64>,
}

/// A column of the rows of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RowColumn {
    /// Its name.
    pub name: String,
    /// Its unit; empty where it has none.
    pub unit: &'static str,
}

impl RowFile {
    /// The file of the rows of `scene`.
    pub fn of(scene: &Scene) -> Self {
        let effects = &scene.effects;
        let seeds = Seeds {
            noise: effects.noise.map(|it| it.seed.get()),
            jitter: effects.jitter.map(|it| it.seed.get()),
            dropout: effects.dropout.map(|it| it.seed.get()),
        };
        let names = COLUMNS.split(',').map(str::to_owned).chain(further_columns(scene));
        let columns = names.map(|name| RowColumn { unit: unit(&name), name });
        Self {
            lyapunov: env!("CARGO_PKG_VERSION"),
            // Every scene that was read can be written.
            scene: toml::to_string(scene).unwrap_or_default(),
            seeds,
            columns: columns.collect(),
        }
    }

    /// The same as JSON.
    pub fn to_json(&self) -> String {
        json::text(self)
    }
}

/// The unit of the column called `name`.
fn unit(name: &str) -> &'static str {
    match name {
        "t" => "s",
        "observer" | "shortfall" => "J",
        "alpha" => "N.s/m",
        "accepted" => "",
        _ if name.contains("f_") => "N",
        _ if name == "v" || name.ends_with("_v") || name.ends_with("_v_operator") => "m/s",
        _ => "m",
    }
}
