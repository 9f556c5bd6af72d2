//! Tests of `lyapunov tune` and `compare --tuned`.

use crate::cli::place::Place;

fn place() -> Place {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 2.0");
    place
}

const FEW: [&str; 6] = ["tune", "scene.toml", "--trials", "4", "--runs", "2"];

#[test]
fn a_tuned_scene_can_be_run_and_files_are_the_same_each_time() {
    let place = place();
    place.run(FEW.iter().chain(&["--out", "one"])).ended(0, &["popc", "damping_cap", "tuned is"]);
    place.run(FEW.iter().chain(&["--out", "two", "--quiet"])).ended(0, &[]);
    for file in ["tune.json", "tune.csv", "tune.svg", "report.html", "popc.toml", "lolc.toml"] {
        // The page tells the command.
        let two = place.text(&format!("two/{file}")).replace(" --out two --quiet", " --out one");
        assert_eq!(place.text(&format!("one/{file}")), two);
    }
    place.run(["run", "one/popc.toml"]).ended(0, &["popc"]);
    let json: serde_json::Value = serde_json::from_str(&place.text("one/tune.json")).unwrap();
    assert_eq!(json["settings"], 5);
    assert_eq!(json["stabilizers"][0]["tuned"]["runs"], 4);
    let cap = json["stabilizers"][0]["tuned"]["set"]["stabilizer.popc.damping_cap"].as_f64();
    let line = format!("damping_cap = {}", cap.unwrap());
    assert!(place.text("one/popc.toml").contains(&line), "{line}");
}

#[test]
fn tuned_stabilizers_take_part_in_a_comparison() {
    let place = place();
    let names = ["--stabilizers", "none,popc"];
    let all = ["compare", "scene.toml", "--tuned"];
    place.run(all.iter().chain(&names)).ended(0, &["popc tuned", "none"]);
    let by = ["compare", "scene.toml", "--tuned=settling=2"];
    place.run(by.iter().chain(&names)).ended(0, &["popc tuned"]);
}

#[test]
fn what_cannot_be_tuned_is_refused() {
    let place = place();
    place.refuses(FEW.iter().chain(&["--objective", "setling"]), &["`settling`"]);
    place.refuses(["tune", "scene.toml", "--runs", "1"], &["--runs"]);
    place.refuses(["tune", "none.toml"], &["none.toml"]);
    let model = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/models/dc-motor.toml");
    place.refuses(["compare", model, "--tuned"], &["--tuned is for scenes"]);
}

/// The wall of this scene is out of reach, so that every setting has the same runs.
#[test]
fn a_scene_without_contact_is_told() {
    let place = Place::new();
    place.put("scene.toml", include_str!("../../../scenes/friction.toml"));
    let names = ["--stabilizers", "popc"];
    place.run(FEW.iter().chain(&names)).ended(0, &["look at: f_env is 0", "no difference"]);
    let scene = place.text("scene.toml").replace("position = 0.5", "position = 0.01");
    place.put("scene.toml", scene);
    let touched = place.run(FEW.iter().chain(&names));
    touched.ended(0, &["bounded,"]);
    assert!(!touched.out.contains("f_env is 0"), "{}", touched.out);
}

/// Two swings of 0.3 kg on 80 N/m take 0.77 s; those of a heavier hand or a softer spring take longer than the run.
#[test]
fn runs_that_are_too_short_and_runs_that_never_settle_are_told() {
    let place = Place::new();
    let scene = "servo_rate = 1000\ndevice = { mass = 0.2, damping = 0.5 }\n\
        environment.wall = { position = 0.002, stiffness = 500, damping = 1 }\n";
    let hand = "operator = { mass = 0.1, damping = 1, stiffness = 80, rest = 0.01 }\n";
    place.put("short.toml", format!("duration = 0.78\n{hand}{scene}"));
    let short = ["tune", "short.toml", "--trials", "2"];
    let told = place.run(short);
    told.ended(0, &["too short", "give a longer duration", "do not tell it apart from"]);
    assert!(!told.out.contains("grow"), "{}", told.out);
    let told = place.run(short.iter().chain(&["--json"]));
    let told: serde_json::Value = serde_json::from_str(&told.out).unwrap();
    let tuned = &told["stabilizers"][0]["tuned"];
    let count = |key: &str| tuned[key].as_u64().unwrap();
    assert_eq!(count("bounded") + count("too_short"), count("runs"));
    assert!(count("too_short") > 0 && count("settle") <= count("bounded"));
    let hand = "operator = { mass = 0.1, damping = 2, stiffness = 200, rest = 0.01 }\n";
    let scene = scene.replace("damping = 0.5", "damping = 0.1").replace("500", "1000");
    place.put("stuck.toml", format!("duration = 4\n{hand}{scene}effects.friction.coulomb = 0.5\n"));
    let stuck = ["tune", "stuck.toml", "--stabilizers", "popc", "--trials", "2", "--runs", "2"];
    place.run(stuck).ended(0, &["no judged run settles", "--objective"]);
}
