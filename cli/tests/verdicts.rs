//! One word for one run: `run`, `compare`, `explain` and `map` of every shipped scene.

use std::path::{Path, PathBuf};
use std::process::Command;

use lyapunov_lab::Scene;
use lyapunov_lab::scenes::SCENES;
use serde_json::Value;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

fn lyapunov(arguments: &[&str]) -> Value {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
    let said = command.args(arguments).current_dir(folder()).output().unwrap();
    assert!(said.status.success(), "{arguments:?}: {said:?}");
    serde_json::from_slice(&said.stdout).unwrap()
}

/// Verdict and yardstick of an object.
fn told(json: &Value) -> [String; 2] {
    ["verdict", "verdict_by"].map(|key| json[key].as_str().unwrap().to_owned())
}

/// Verdict and yardstick of the first cell of a map whose first values are those of the scene.
fn of_map(file: &str, scene: &Scene, name: &str) -> [String; 2] {
    let place = tempfile::tempdir().unwrap();
    let axis = |key: &str, own: f64| format!("{key}={own:?}..{:?}:2", own + 1.0);
    let x = axis("device.mass", scene.device.mass.get());
    let y = axis("operator.damping", scene.operator.damping.get());
    let out = place.path().join("map");
    let out = out.to_str().unwrap();
    // The first of four shares is the first cell.
    let cell = ["--shard", "0/4", "--out", out, "--json"];
    let map = ["map", file, "--x", &x, "--y", &y, "--stabilizers", name];
    lyapunov(&[&map[..], &cell].concat());
    let table = std::fs::read_to_string(place.path().join("map/map-0-of-4.csv")).unwrap();
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let cells: Vec<&str> = lines.next().unwrap().split(',').collect();
    ["verdict", "verdict_by"]
        .map(|key| cells[names.iter().position(|name| *name == key).unwrap()].to_owned())
}

#[test]
fn every_command_says_the_same_of_every_shipped_scene() {
    let mut words = Vec::new();
    for shipped in SCENES {
        let file = format!("{}.toml", shipped.name);
        let scene = Scene::load(&folder().join(&file)).unwrap();
        let run = told(&lyapunov(&["run", &file, "--json"]));
        words.push(run.clone());
        if scene.dimensions() > 1 {
            continue;
        }
        let name = scene.stabilizer.map_or("none", |stabilizer| stabilizer.name());
        assert_eq!(told(&lyapunov(&["explain", &file, "--json"])), run, "explain {file}");
        let compared = lyapunov(&["compare", &file, "--stabilizers", name, "--json"]);
        let of_compare = [&compared["rows"][0]["verdict"], &compared["scenes"][0]["verdict_by"]];
        assert_eq!(of_compare.map(|it| it.as_str().unwrap().to_owned()), run, "compare {file}");
        assert_eq!(of_map(&file, &scene, name), run, "map {file}");
    }
    // The shipped scenes have all words but one, for what never rests seldom settles, and all are long enough to be judged.
    for (word, by) in [
        ("settles", "distance"),
        ("swinging", "distance"),
        ("grows", "distance"),
        ("swinging", "speed"),
        ("grows", "speed"),
    ] {
        assert!(words.iter().any(|it| it == &[word, by]), "{word} by {by}");
    }
    assert!(words.iter().all(|it| it[0] != "too short"));
}
