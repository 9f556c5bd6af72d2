//! Tests of `lyapunov scenes` and `lyapunov schema`, which print the shipped scenes and their schema.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use lyapunov_lab::scenes::SCENES;

/// The widest line that fits a terminal.
const WIDTH: usize = 100;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

fn said(arguments: &[&str]) -> Output {
    let place = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
    command.args(arguments).current_dir(place.path()).output().unwrap()
}

fn out(arguments: &[&str]) -> String {
    let said = said(arguments);
    assert_eq!(said.status.code(), Some(0), "{said:?}");
    assert!(said.stderr.is_empty(), "{said:?}");
    String::from_utf8(said.stdout).unwrap()
}

#[test]
fn the_list_names_and_describes_each() {
    let list = out(&["scenes"]);
    for scene in SCENES {
        let [what, look] = scene.comment();
        assert!(list.contains(&format!("{}\n  {what}\n  {look}\n", scene.name)), "{list}");
    }
    assert_eq!(list.lines().count(), 3 * SCENES.len());
    assert!(list.lines().all(|line| line.chars().count() <= WIDTH), "{list}");
    let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
    assert_eq!(out(&["scenes", "--quiet"]).lines().collect::<Vec<_>>(), names);
    let json: serde_json::Value = serde_json::from_str(&out(&["scenes", "--json"])).unwrap();
    let entries = json.as_array().unwrap();
    assert_eq!(entries.len(), SCENES.len());
    for (entry, scene) in entries.iter().zip(SCENES) {
        assert_eq!(entry["name"], scene.name);
        assert_eq!(entry["comment"], serde_json::json!(scene.comment()));
    }
}

#[test]
fn each_is_printed_as_it_is_in_its_file() {
    for scene in SCENES {
        let file = fs::read_to_string(folder().join(format!("{}.toml", scene.name))).unwrap();
        assert_eq!(out(&["scenes", scene.name]), file);
    }
    assert_eq!(out(&["scenes", "tour.toml"]), out(&["scenes", "tour"]));
    let motion = fs::read_to_string(folder().join("motion-file.csv")).unwrap();
    assert_eq!(out(&["scenes", "motion-file.csv"]), motion);
}

#[test]
fn an_unknown_name_is_an_error() {
    let said = said(&["scenes", "frictoin"]);
    assert_eq!(said.status.code(), Some(2));
    assert!(said.stdout.is_empty());
    let error = String::from_utf8(said.stderr).unwrap();
    assert!(error.starts_with("error: no scene that ships is called `frictoin`\n"), "{error}");
    assert!(error.contains("did you mean `friction`?"), "{error}");
    assert!(error.contains("`lyapunov scenes` lists them"), "{error}");
}

#[test]
fn the_schema_is_printed() {
    assert_eq!(out(&["schema"]), lyapunov_lab::scene::schema_text());
}
