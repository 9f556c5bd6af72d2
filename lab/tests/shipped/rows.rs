//! Helpers that read shipped scenes and their rows.

use std::path::{Path, PathBuf};

use lyapunov_lab::scene::Draft;
use lyapunov_lab::{Rollout, Row, SVector, Scene, Space, Tick};

pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

pub(crate) fn scene(name: &str) -> Scene {
    let path = folder().join(format!("{name}.toml"));
    Scene::load(&path).unwrap_or_else(|fault| panic!("{fault}"))
}

pub(crate) fn rows_of(scene: &Scene) -> Vec<Row> {
    Rollout::<f64>::of(scene).unwrap().rows().collect()
}

pub(crate) fn rows(name: &str) -> Vec<Row> {
    rows_of(&scene(name))
}

/// The ticks of a scene in several dimensions.
pub(crate) fn ticks_in_space<const N: usize>(name: &str) -> Vec<Tick<SVector<f64, N>>>
where
    SVector<f64, N>: Space,
{
    Rollout::of(&scene(name)).unwrap().collect()
}

/// The scene after `edit`.
pub(crate) fn edited(scene: &Scene, edit: impl FnOnce(&mut Draft)) -> Scene {
    let mut draft = scene.to_draft();
    edit(&mut draft);
    draft.check().unwrap_or_else(|conflict| panic!("{conflict}"))
}

/// The rows from one time to another, s.
pub(crate) fn between(rows: &[Row], from: f64, to: f64) -> &[Row] {
    let first = rows.partition_point(|row| row.t < from);
    let last = rows.partition_point(|row| row.t <= to);
    &rows[first..last]
}

pub(crate) fn least(rows: &[Row], number: impl Fn(&Row) -> f64) -> f64 {
    rows.iter().map(number).fold(f64::INFINITY, f64::min)
}

pub(crate) fn most(rows: &[Row], number: impl Fn(&Row) -> f64) -> f64 {
    rows.iter().map(number).fold(f64::NEG_INFINITY, f64::max)
}

/// Difference between the largest and the least.
pub(crate) fn width(rows: &[Row], number: impl Fn(&Row) -> f64) -> f64 {
    most(rows, &number) - least(rows, &number)
}

/// Energy that crossed the port into the environment, J.
pub(crate) fn absorbed(rows: &[Row]) -> f64 {
    rows.windows(2).map(|pair| pair[0].f_act * (pair[1].x - pair[0].x)).sum()
}
