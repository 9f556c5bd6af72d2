//! Tests of the comparisons: they pass sound runs and catch misreadings of the contract.

use crate::contract::conditioning::shortened;
use crate::contract::fault::Fault;
use crate::contract::generate::{known, scenes, ties};
use crate::contract::reference::{self, Disturbance};
use crate::contract::row::Row;
use crate::contract::rows;
use crate::contract::scene::{STIFF, Scalar, Scene};
use crate::contract::second;
use crate::contract::trace;
use crate::for_each::for_each;

/// Two formulations that share no formula agree where rounding decides nothing; their rows agree everywhere.
fn both_forms_agree(scene: &Scene) -> Result<(), String> {
    let second = |scene: &Scene| Ok(second::run(scene, None));
    let told = |error| format!("{error}\n{}", scene.toml());
    rows::follow(scene, &reference::run(scene)).map_err(told)?;
    rows::follow(scene, &second::run(scene, None)).map_err(told)?;
    trace::compare(scene, second)
}

#[test]
fn both_forms_agree_on_known_scenes() {
    for scene in known() {
        both_forms_agree(&scene.lasting(1.0)).unwrap();
    }
}

#[test]
fn both_forms_agree_on_random_scenes() {
    for_each(scenes(Scalar::F64, 1.0), 300, 200, 1, both_forms_agree);
}

#[test]
fn rows_of_long_runs_follow() {
    let follow = |scene: &Scene| rows::follow(scene, &reference::run(scene));
    for_each(scenes(Scalar::F64, 20.0), 200, 200, 2, follow);
}

/// Rounding errors of the scalar, added to the state and to each column, must pass.
fn rounded_follows(scene: &Scene) -> Result<(), String> {
    let held = scene.in_scalar();
    let disturbance = Disturbance { start: 0.0, rounding: scene.scalar.epsilon(), seed: 7 };
    let mut rows = reference::run_disturbed(&held, disturbance);
    for row in &mut rows {
        *row = Row::from_columns(row.columns().map(|value| scene.scalar.round(value)));
    }
    rows::follow(scene, &rows).map_err(|error| format!("{error}\n{}", scene.toml()))
}

#[test]
fn rounding_is_no_fault() {
    for_each(scenes(Scalar::F64, 20.0), 200, 200, 3, rounded_follows);
    for_each(scenes(Scalar::F32, 20.0), 200, 200, 4, rounded_follows);
}

#[test]
fn a_trace_may_end_only_at_the_end_of_the_scalar_s_range() {
    for scalar in [Scalar::F64, Scalar::F32] {
        let mut scene = Scene::paper(STIFF).lasting(150.0);
        scene.scalar = scalar;
        let mut rows = reference::run(&scene.in_scalar());
        assert!(rows.len() < scene.ticks());
        rows::follow(&scene, &rows).unwrap();
        rows.pop();
        assert!(rows::follow(&scene, &rows).is_err());
    }
}

#[test]
fn every_fault_is_caught_by_rows_and_by_traces() {
    let short: Vec<Scene> = known()
        .into_iter()
        .map(|scene| scene.lasting(0.4))
        .filter_map(|scene| shortened(&scene))
        .collect();
    for &fault in Fault::ALL {
        let caught =
            |scene: &&Scene| rows::follow(scene, &second::run(scene, Some(fault))).is_err();
        let by_rows = short.iter().chain(&ties()).filter(caught).count();
        let misread = |scene: &Scene| Ok(second::run(scene, Some(fault)));
        let differs = |scene: &&Scene| trace::compare(scene, misread).is_err();
        let by_traces = short.iter().filter(differs).count();
        assert!(by_rows > 0, "no row shows {fault:?}");
        // A trace that depends on a rounding tie is not determined.
        assert!(by_traces > 0 || fault == Fault::EncoderHalvesToEven, "no trace shows {fault:?}");
    }
}
