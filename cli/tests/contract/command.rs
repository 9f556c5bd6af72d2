//! The command against the reference: traces for as long as they are determined, rows to the end of any run.

use crate::contract::binary::run;
use crate::contract::facts;
use crate::contract::generate::{self, without_encoder};
use crate::contract::rows;
use crate::contract::scene::{Kind, SOFT, STIFF, Scalar, Scene, Work};
use crate::contract::trace;
use crate::for_each::for_each;

fn follows(scene: &Scene) -> Result<(), String> {
    let told = |error| format!("{error}\n{}", scene.toml());
    let rows = run(scene).map_err(told)?;
    rows::follow(scene, &rows).map_err(told)
}

fn agrees(scene: &Scene) -> Result<(), String> {
    trace::compare(scene, run)
}

fn in_f32(mut scene: Scene) -> Scene {
    scene.scalar = Scalar::F32;
    scene
}

fn all(scenes: impl IntoIterator<Item = Scene>, check: fn(&Scene) -> Result<(), String>) {
    for scene in scenes {
        check(&scene).unwrap();
    }
}

#[test]
fn known_traces_agree() {
    all(generate::known(), agrees);
}

#[test]
fn known_traces_agree_in_f32() {
    let scenes = generate::known().into_iter().map(in_f32);
    all(scenes.map(without_encoder), agrees);
}

#[test]
fn random_traces_agree() {
    for_each(generate::scenes(Scalar::F64, 4.0), 120, 200, 11, agrees);
}

#[test]
fn random_traces_agree_in_f32() {
    use proptest::strategy::Strategy;
    let scenes = generate::scenes(Scalar::F32, 4.0).prop_map(without_encoder);
    for_each(scenes, 80, 200, 12, agrees);
}

#[test]
fn rows_of_known_scenes_follow() {
    all(generate::known(), follows);
    all(generate::ties(), follows);
}

#[test]
fn rows_of_known_scenes_follow_in_f32() {
    all(generate::known().into_iter().map(in_f32), follows);
    all(generate::ties().into_iter().map(in_f32), follows);
}

#[test]
fn rows_of_random_scenes_follow() {
    for_each(generate::scenes(Scalar::F64, 20.0), 60, 200, 13, follows);
}

#[test]
fn rows_of_random_scenes_follow_in_f32() {
    for_each(generate::scenes(Scalar::F32, 20.0), 60, 200, 14, follows);
}

/// Chaotic, settling, uncapped and growing loops, at the longest duration and at the fastest rate of these tests.
#[test]
fn rows_of_long_runs_follow() {
    for scalar in [Scalar::F64, Scalar::F32] {
        for (wall, kind, cap) in [
            (SOFT, Kind::MassSpringDamper, 0.5),
            (SOFT, Kind::Popc, 0.5),
            (STIFF, Kind::Popc, 0.5),
            (STIFF, Kind::DeviceDamping, f64::INFINITY),
        ] {
            let scene = Scene::paper(wall).with(kind, Work::Held, cap).lasting(30.0);
            let fast = scene.clone().at(1e4, 100).lasting(3.0);
            for mut scene in [scene, fast] {
                scene.scalar = scalar;
                follows(&scene).unwrap();
            }
        }
    }
}

/// `run` fails unless the exit status is 0 and every number is finite; `follow` fails unless the rows go to the last
/// one that fits into the scalar.
#[test]
fn motion_out_of_range_ends_the_rows() {
    for (scalar, duration) in [(Scalar::F32, 100.0), (Scalar::F64, 150.0)] {
        let mut scene = Scene::paper(STIFF).lasting(duration);
        scene.scalar = scalar;
        let rows = run(&scene).unwrap();
        assert!(rows.len() > 1000 && rows.len() <= scene.ticks());
        rows::follow(&scene, &rows).unwrap();
    }
}

#[test]
fn known_facts_hold() {
    for fact in facts::ALL {
        fact(|scene| run(scene).unwrap());
    }
}
