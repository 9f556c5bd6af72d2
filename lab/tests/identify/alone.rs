//! A device that is known without the hand is one part of the sum that the log tells.

use lyapunov_lab::identify::{Alone, Identified, Settings, identify};
use lyapunov_lab::observe::LogError;
use lyapunov_lab::{Rollout, Scene};

use super::loops::{Chance, PLAIN};

fn fitted(mass: Option<f64>, damping: Option<f64>) -> Result<Identified, LogError> {
    let log = PLAIN.log(800, &mut Chance::new(7));
    let settings = Settings { alone: Alone { mass, damping }, ..Settings::default() };
    identify(log.as_bytes(), "log.csv", &settings)
}

/// The scene, and the positions of its run.
fn run(found: &Identified) -> (Scene, Vec<f64>) {
    let scene = Scene::parse(&found.scene, "fitted").unwrap();
    let rows = Rollout::<f64>::of(&scene).unwrap().rows().map(|row| row.x).collect();
    (scene, rows)
}

#[test]
fn the_rest_of_the_sum_is_the_hands() {
    let whole = fitted(None, None).unwrap();
    let (joint, expected) = run(&whole);
    let told = [(Some(0.2), Some(0.5)), (Some(0.2), None), (None, Some(0.0))];
    for (mass, damping) in told {
        let found = fitted(mass, damping).unwrap();
        assert_eq!(found.report.mass, whole.report.mass);
        let (scene, rows) = run(&found);
        assert_eq!(scene.device.mass.get(), mass.unwrap_or(joint.device.mass.get()));
        assert_eq!(scene.device.damping.get(), damping.unwrap_or(joint.device.damping.get()));
        let sum = scene.device.mass.get() + scene.operator.mass.get();
        assert!((sum / PLAIN.mass - 1.0).abs() < 1e-6, "{sum}");
        let sum = scene.device.damping.get() + scene.operator.damping.get();
        assert!((sum / joint.device.damping.get() - 1.0).abs() < 1e-9, "{sum}");
        for (x, it) in rows.iter().zip(&expected) {
            assert!((x - it).abs() < 1e-8, "{x} for {it}");
        }
    }
}

#[test]
fn what_is_left_untold_is_said() {
    let says = |mass, damping, words: &str| {
        let notes = fitted(mass, damping).unwrap().report.notes;
        notes.iter().any(|note| note.contains(words))
    };
    assert!(says(None, None, "masses and dampings apart"));
    assert!(says(Some(0.2), None, "their dampings apart"));
    assert!(says(None, Some(0.5), "their masses apart"));
    assert!(!says(Some(0.2), Some(0.5), "apart"));
}

#[test]
fn a_device_that_is_no_part_of_the_sum_is_refused() {
    let refused = |mass, damping, words: &str| {
        let told = fitted(mass, damping).unwrap_err().to_string();
        assert!(told.contains(words) && told.contains("  = "), "{told}");
    };
    refused(Some(0.5), None, "--device-mass is 0.5 kg, and hand and device have 0.3 kg together");
    refused(Some(0.0), None, "--device-mass is 0 kg");
    refused(Some(f64::NAN), None, "--device-mass is NaN kg");
    refused(None, Some(-1.0), "--device-damping is -1 N.s/m");
    refused(None, Some(1e3), "--device-damping is 1000 N.s/m");
}
