//! Tests that the rows compute what they claim.

use std::path::Path;

use lyapunov_lab::scene::Velocity;
use lyapunov_lab::{Rollout, Scene};

use crate::reference::Reference;
use crate::row::{NOWHERE, Row, Setting};
use crate::scene::Positions;
use crate::{crates, hand, ours};

fn scene() -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/paper-8k-none.toml");
    let mut draft = Scene::load(&path).expect("a shipped scene").to_draft();
    draft.velocity = Velocity::Exact;
    draft.check().expect("a scene")
}

fn moved(run: impl FnOnce(&mut Positions)) -> Positions {
    let mut positions = NOWHERE;
    run(&mut positions);
    positions
}

fn error(row: &mut Row) -> f64 {
    let mut positions = NOWHERE;
    (row.run)(&mut positions).expect("a row that runs");
    Reference::new().error(&positions)
}

#[test]
fn the_loop_is_the_shipped_scene() {
    let rows = Rollout::<f64>::of(&scene()).expect("a shipped scene");
    let shipped: Vec<f64> = rows.rows().map(|row| row.x).take(NOWHERE.len()).collect();
    assert_eq!(moved(|at| ours::exact(at).unwrap())[..], shipped);
}

#[test]
fn a_nan_position_gives_a_nan_error() {
    assert!(Reference::new().error(&NOWHERE).is_nan());
}

#[test]
fn both_exact_rows_match_the_reference() {
    let errors = [moved(|at| ours::exact(at).unwrap()), moved(hand::exact)];
    let errors = errors.map(|positions| Reference::new().error(&positions));
    assert!(errors.iter().all(|error| *error < 1e-12), "{errors:?}");
}

#[test]
fn runge_kutta_by_hand_is_of_order_4() {
    let error = |steps| Reference::new().error(&moved(|at| hand::runge_kutta_4(at, steps)));
    let order = (error(10) / error(20)).log2();
    assert!((order - 4.0).abs() < 0.1, "order {order}");
}

#[test]
fn the_pair_by_hand_follows_its_tolerance() {
    let error =
        |tolerance| Reference::new().error(&moved(|at| hand::dormand_prince(at, tolerance)));
    let (loose, tight) = (error(1e-10), error(1e-12));
    assert!(loose < 1e-7 && tight < 1e-9, "{loose}, {tight}");
}

/// A step too many or too few, or a run that does not end with the period, would show in the error.
#[test]
fn crates_of_equal_steps_agree_with_the_method_by_hand() {
    let mut compared = 0;
    for mut row in crates::rows() {
        let Setting::Steps(steps) = row.setting else { continue };
        if row.method.to_lowercase().ends_with("rk4") {
            let by_hand = Reference::new().error(&moved(|at| hand::runge_kutta_4(at, steps)));
            let ratio = error(&mut row) / by_hand;
            assert!((ratio - 1.0).abs() < 0.05, "{} {}: {ratio}", row.method, row.setting);
            compared += 1;
        }
    }
    assert!(compared > 40);
}

/// A run that does not end with the period would show as an error of 1e-5 m or more.
#[test]
fn adaptive_crates_follow_their_tolerance() {
    for mut row in crates::rows() {
        if row.setting == Setting::Tolerance(1e-12) {
            let error = error(&mut row);
            assert!(error < 1e-8, "{}: {error}", row.method);
        }
    }
}
