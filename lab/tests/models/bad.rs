//! Model files that are refused, and the words of the refusal.

use std::fs;

use lyapunov_lab::Scene;
use lyapunov_lab::models::Model;
use lyapunov_lab::scene::Diagnostic;

use crate::models::shipped::path;

/// A shipped model with one part replaced, refused.
fn refused(name: &str, from: &str, to: &str) -> Diagnostic {
    let text = fs::read_to_string(path(name)).unwrap();
    assert!(text.contains(from), "{name}: {from}");
    let text = text.replacen(from, to, 1);
    match Model::parse(&text, "test.toml") {
        Ok(_) => panic!("accepted:\n{text}"),
        Err(fault) => fault,
    }
}

/// A model, a part of it, what stands there instead, the key at fault, and words of the message.
#[rustfmt::skip]
const CASES: &[(&str, &str, &str, &str, &[&str])] = &[
    ("van-der-pol", "[plant.van-der-pol]", "[plant.van-der-pool]", "plant.van-der-pool",
        &["unknown key `van-der-pool` in [plant]", "did you mean `van-der-pol`?"]),
    ("van-der-pol", "[plant.van-der-pol]", "[plant.duffing]", "plant.duffing",
        &["van-der-pol, inverted-pendulum, dc-motor, admittance-device, two-link-arm, prosthetic-leg"]),
    ("van-der-pol", "[plant.van-der-pol]\nmu = 1.0", "[plant]", "plant", &["[plant] is empty"]),
    ("van-der-pol", "[plant.van-der-pol]\nmu = 1.0", "[controller]", "plant.van-der-pol.mu",
        &["there is no [plant]", "[plant.van-der-pol] mu = 1.0"]),
    ("van-der-pol", "[stabilizer]", "[plant.dc-motor]\n[stabilizer]", "plant", 
        &["two plants, `van-der-pol` and `dc-motor`: a model has only one"]),
    ("van-der-pol", "mu = 1.0", "mu = -1.0", "plant.van-der-pol.mu", &["must be finite and 0 or greater, not -1.0"]),
    ("van-der-pol", "[0.5, 0.0]", "[0.5]", "initial",
        &["`initial` has one number, but the plant `van-der-pol` has 2 states", "x, rate of x"]),
    ("dc-motor", "[1.0, 0.0, 0.0]", "[1.0, 0.0, 0.0, 0.0]", "initial",
        &["has 4 numbers, but the plant `dc-motor` has 3 states", "current in A"]),
    ("van-der-pol", "[0.5, 0.0]", "0.5", "initial", &["must be a list, not the number 0.5"]),
    ("van-der-pol", "[0.5, 0.0]", "[0, 0]", "initial", &["V is 0.0 at this start", "away from rest"]),
    ("van-der-pol", "[0.5, 0.0]", "[nan, 0]", "initial[0]", &["must be finite, not NaN"]),
    ("van-der-pol", "[0.5, 0.0]", "[1e200, 0]", "initial", &["V is inf at this start"]),
    ("van-der-pol", "[0.5, 0.0]", "[1e200, 0]\nscalar = \"f32\"", "initial", &["beyond the range of f32"]),
    ("van-der-pol", "initial = [0.5, 0.0]\n", "", "initial", &["missing key `initial`", "initial = [0.1, 0.0]"]),
    ("van-der-pol", "60.0", "1e9", "duration", &["a run has at most 1e9 ticks"]),
    ("van-der-pol", "servo_rate = 100.0", "servo_rate = 1e-320", "servo_rate", &["too small"]),
    ("inverted-pendulum", "mass = 0.5", "mass = -0.5", "plant.inverted-pendulum.mass",
        &["must be finite and greater than 0, not -0.5", "the unit is kg", "mass = 0.5"]),
    ("inverted-pendulum", "length = 0.4", "length = 1e200", "plant.inverted-pendulum", &["beyond the range of f64"]),
    ("inverted-pendulum", "proportional = 6.0", "proportional = 1.0", "controller.proportional",
        &["V is not positive away from rest", "1.96133", "m g l"]),
    ("inverted-pendulum", "proportional = 6.0", "proportional = [6.0, 1.0]", "controller.proportional",
        &["has 2 numbers, but the plant `inverted-pendulum` has one input", "give a number"]),
    ("inverted-pendulum", "delay = 120", "delay = 1025", "controller.delay", &["from 0 to 1024, not 1025"]),
    ("inverted-pendulum", "delay = 120", "delai = 120", "controller.delai", &["did you mean `delay`?"]),
    ("inverted-pendulum", "damping_cap = 0.0125", "damping_cap = -1", "stabilizer.damping_cap", &["0 or greater"]),
    ("dc-motor", "wanted_stiffness = 0.05\n", "", "plant.dc-motor.wanted_stiffness", &["missing key", "in N.m/rad"]),
    ("two-link-arm", "hold = 20", "hold = 0", "controller.hold", &["from 1 to 1024, not 0"]),
    ("two-link-arm", "[40.0, 10.0]", "40.0", "controller.proportional", &["has two inputs", "give a list of two"]),
    ("two-link-arm", "[40.0, 10.0]", "[40.0, -10.0]", "controller.proportional", &["-10.0", "0 or more"]),
    ("two-link-arm", "upper = { mass = 2.0, length = 0.4 }\n", "", "plant.two-link-arm.upper.mass",
        &["there is no [plant.two-link-arm.upper]"]),
    ("two-link-arm", "length = 0.3", "length = 0", "plant.two-link-arm.lower.length", &["greater than 0"]),
    ("prosthetic-leg", "[0.3, -0.6]", "[0.3]", "plant.prosthetic-leg.posture", &["a list of two numbers, not of 1"]),
    ("prosthetic-leg", "[300.0, 150.0]", "[300.0, 0.0]", "controller.proportional", &["two numbers above 0"]),
    ("prosthetic-leg", "steps_per_tick = 4", "steps_per_tick = 0", "steps_per_tick", &["from 1 to 1000000"]),
];

#[test]
fn a_fault_is_named_with_its_key_its_place_and_its_remedy() {
    for (name, from, to, key, words) in CASES {
        let fault = refused(name, from, to);
        let shown = fault.to_string();
        assert_eq!(fault.key(), Some(*key), "{shown}");
        assert!(fault.line().is_some() && !fault.help().is_empty(), "{shown}");
        assert!(shown.starts_with("error: test.toml:"), "{shown}");
        let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        for word in *words {
            assert!(unfolded.contains(word), "no {word:?} in:\n{shown}");
        }
        // Only the path of the file can make a line longer.
        for line in shown.lines().skip(1) {
            assert!(line.chars().count() <= 100, "too wide: {line}");
        }
    }
}

/// A leg upright, which both limbs would fall out of, on springs in N.m/rad.
fn upright(springs: &str, initial: &str) -> Result<Model, Diagnostic> {
    let text = fs::read_to_string(path("prosthetic-leg")).unwrap();
    let text = text.replacen("[0.3, -0.4, 0.0, 0.0]", initial, 1);
    let text = text.replacen("[0.3, -0.6]", "[3.0, 0.1]", 1);
    Model::parse(&text.replacen("[300.0, 150.0]", springs, 1), "test.toml")
}

#[test]
fn springs_that_let_a_leg_fall_are_refused_with_what_is_stiff_enough() {
    // Thigh and shank weigh 17.65 N.m and 5.52 N.m; both are near upright.
    for initial in ["[0.1, 0.05, 0.0, 0.0]", "[0.0, 0.0, 0.5, 0.0]"] {
        let fault = upright("[5.0, 5.0]", initial).unwrap_err();
        let shown = fault.to_string();
        assert_eq!(fault.key(), Some("controller.proportional"), "{shown}");
        assert!(shown.contains("= [5.0, 5.0], the springs of V"), "{shown}");
        assert!(shown.contains("two springs of 24.6"), "{shown}");
    }
    assert!(upright("[24.5, 24.5]", "[0.0, 0.0, 0.5, 0.0]").is_err());
    assert!(upright("[24.7, 24.7]", "[0.0, 0.0, 0.5, 0.0]").is_ok());
    assert!(upright("[1000.0, 5.5]", "[0.0, 0.0, 0.5, 0.0]").is_err());
    assert!(upright("[1000.0, 5.8]", "[0.0, 0.0, 0.5, 0.0]").is_ok());
}

#[test]
fn a_model_is_not_taken_for_a_scene() {
    for name in crate::models::shipped::NAMES {
        let text = fs::read_to_string(path(name)).unwrap();
        assert!(Model::is_in(&text) && Model::is_in(&format!("\u{feff}{text}")));
        let fault = Scene::parse(&text, name).unwrap_err().to_string();
        assert!(fault.contains("a model of a plant, not a scene"), "{fault}");
        assert!(fault.contains("lyapunov compare"), "{fault}");
    }
    for scene in lyapunov_lab::scenes::SCENES {
        assert!(!Model::is_in(scene.text), "{}", scene.name);
    }
    // A broken text counts too, so that its error is about models.
    let broken = "duration = 1,0\n[plant.van-der-pol]\nmu = 1\n";
    assert!(Model::is_in(broken) && !Model::is_in(""));
}
