//! Random scenes that mix effects.

use std::cell::Cell;

use proptest::strategy::Strategy;

use crate::effects::compare::{agrees, follows};
use crate::effects::generate::scenes;
use crate::effects::scene::Scene;
use crate::for_each::for_each;

/// Compares the traces, and asserts that more than `part` of their ticks is determined.
fn all_agree(scenes: impl Strategy<Value = Scene>, cases: u32, seed: u64, part: f64) {
    let (whole, compared) = (Cell::new(0), Cell::new(0));
    for_each(scenes, cases, 20, seed, |scene| {
        whole.set(whole.get() + scene.ticks());
        compared.set(compared.get() + agrees(scene)?);
        Ok(())
    });
    let (whole, compared) = (whole.get() as f64, compared.get() as f64);
    assert!(compared > part * whole, "only {compared} of {whole} ticks are determined");
}

#[test]
fn traces_agree() {
    all_agree(scenes(false), 120, 41, 0.5);
}

/// No encoder: near a half count one bit decides the measured position, which no tolerance of a trace in f32 covers.
#[test]
fn traces_agree_in_f32() {
    let scenes = scenes(true).prop_map(|mut scene| {
        scene.encoder = None;
        scene
    });
    all_agree(scenes, 60, 42, 0.4);
}

#[test]
fn rows_follow() {
    for_each(scenes(false), 40, 20, 43, |scene| follows(&Scene { duration: 2.0, ..scene.clone() }));
}
