//! Shipped scenes and their rows.

use std::path::{Path, PathBuf};

use lyapunov_lab::{Rollout, Row, SVector, Scene};

pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

pub(crate) fn scene(name: &str) -> Scene {
    let path = folder().join(format!("{name}.toml"));
    Scene::load(&path).unwrap_or_else(|fault| panic!("{fault}"))
}

pub(crate) fn rows_of(scene: &Scene) -> Vec<Row> {
    Rollout::<f64>::of(scene).unwrap().collect()
}

pub(crate) fn rows(name: &str) -> Vec<Row> {
    rows_of(&scene(name))
}

/// The rows of a scene in several dimensions with the further numbers of each.
pub(crate) fn rows_in_space<const N: usize>(name: &str) -> Vec<(Row, Vec<f64>)> {
    let mut rollout = Rollout::<SVector<f64, N>>::of(&scene(name)).unwrap();
    let mut rows = Vec::new();
    while let Some(row) = rollout.next() {
        rows.push((row, rollout.further().to_vec()));
    }
    rows
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

/// From the least to the largest.
pub(crate) fn width(rows: &[Row], number: impl Fn(&Row) -> f64) -> f64 {
    most(rows, &number) - least(rows, &number)
}

/// What crossed the port into the environment, J.
pub(crate) fn absorbed(rows: &[Row]) -> f64 {
    rows.windows(2).map(|pair| pair[0].f_act * (pair[1].x - pair[0].x)).sum()
}
