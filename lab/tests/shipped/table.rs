//! The table of shipped scenes, and the commands that print from it.

use std::collections::BTreeSet;
use std::fs;
use std::process::{Command, Output};

use lyapunov_lab::scene::{Effects, Scalar};
use lyapunov_lab::shipped::SCENES;
use lyapunov_lab::{Rollout, in_space};

use crate::rows::{folder, scene};

/// Whether effects have a certain one among them.
type Has = fn(&Effects) -> bool;

/// The widest line that fits a terminal.
const WIDTH: usize = 100;

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
fn the_table_is_the_folder() {
    let files = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let scenes = files.filter(|path| path.extension() == Some("toml".as_ref()));
    let names: BTreeSet<String> =
        scenes.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    assert_eq!(names, SCENES.iter().map(|scene| scene.name.to_owned()).collect());
    assert_eq!(names.len(), SCENES.len());
}

#[test]
fn each_begins_with_its_schema_and_two_lines_of_comment() {
    for scene in SCENES {
        let lines: Vec<&str> = scene.text.lines().take(4).collect();
        assert_eq!(lines[0], "#:schema ./scene.schema.json", "{}", scene.name);
        assert_eq!(scene.comment(), [&lines[1][2..], &lines[2][2..]], "{}", scene.name);
        assert!(lines[2].starts_with("# Look at "), "{}: {}", scene.name, lines[2]);
        assert!(!lines[3].starts_with('#'), "{}: {}", scene.name, lines[3]);
        assert!(scene.comment().iter().all(|line| line.ends_with('.')), "{}", scene.name);
    }
}

#[test]
fn each_runs_to_its_end_within_range_in_both_scalars() {
    for shipped in SCENES {
        let mut scene = scene(shipped.name);
        for scalar in [Scalar::F64, Scalar::F32] {
            scene.scalar = scalar;
            scene.check().unwrap();
            let rows = in_space!(scene, Axes => Rollout::<Axes>::of(&scene).unwrap().count());
            assert_eq!(rows as u64, scene.ticks() + 1, "{} in {scalar:?}", shipped.name);
        }
    }
}

#[test]
fn each_effect_has_a_scene_of_its_own() {
    let names: [(&str, Has); 11] = [
        ("encoder", |it| it.encoder.is_some()),
        ("delay", |it| it.delay.is_some()),
        ("saturation", |it| it.saturation.is_some()),
        ("filter-cutoff", |it| it.filter.is_some()),
        ("filter-window", |it| it.filter.is_some()),
        ("noise", |it| it.noise.is_some()),
        ("jitter", |it| it.jitter.is_some()),
        ("dropout", |it| it.dropout.is_some()),
        ("friction", |it| it.friction.is_some()),
        ("load", |it| it.load.is_some()),
        ("pulse", |it| it.pulse.is_some()),
    ];
    for (name, has) in names {
        assert!(has(&scene(name).effects), "{name}");
    }
    let environments = SCENES.iter().map(|shipped| scene(shipped.name).environment.name());
    assert_eq!(environments.collect::<BTreeSet<_>>().len(), 11);
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
fn a_name_that_none_has_is_an_error() {
    let said = said(&["scenes", "frictoin"]);
    assert_eq!(said.status.code(), Some(2));
    assert!(said.stdout.is_empty());
    let error = String::from_utf8(said.stderr).unwrap();
    assert!(error.starts_with("error: no scene that ships is called `frictoin`\n"), "{error}");
    assert!(error.contains("did you mean `friction`?"), "{error}");
    assert!(error.contains("`lyapunov scenes` lists them"), "{error}");
}
