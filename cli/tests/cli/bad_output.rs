//! Outputs that cannot be written.

use std::fs;
use std::os::unix::fs::{FileTypeExt, symlink};

use crate::cli::place::{Place, SCENE};

#[test]
fn rows_that_cannot_be_written_are_refused() {
    let place = Place::with_scene();
    place.put("file", "not a folder");
    fs::create_dir(place.path("folder")).unwrap();
    symlink("nowhere/rows.csv", place.path("dangling")).unwrap();
    symlink("circle", place.path("circle")).unwrap();
    let long = "n".repeat(300);
    let cases: &[(&str, &[&str])] = &[
        ("missing/rows.csv", &["missing/rows.csv cannot be written", "create the folder first"]),
        ("dangling", &["dangling cannot be written", "create the folder first"]),
        ("folder", &["folder cannot be written: this is a folder", "name of a file"]),
        ("folder/", &["folder/ cannot be written: this is a folder"]),
        ("folder/..", &["folder/.. cannot be written: this is a folder"]),
        ("new/", &["new/ cannot be written: this is a folder"]),
        ("file/rows.csv", &["file/rows.csv cannot be written: part of the path is a file"]),
        ("circle", &["circle cannot be written", "choose another name"]),
        (&long, &["cannot be written", "choose another name"]),
        ("/dev/full", &["/dev/full cannot be written: no space is left there"]),
        ("/proc/rows.csv", &["/proc/rows.csv cannot be written", "a place that you may write to"]),
    ];
    for (csv, words) in cases {
        place.refuses(["run", "scene.toml", "--csv", csv], words);
    }
}

/// The longer run fills more than one buffer before the device reports that it is full.
#[test]
fn a_full_device_is_noticed_early_and_late() {
    let place = Place::new();
    for duration in ["duration = 0.01", "duration = 1000.0"] {
        place.put_scene("scene.toml", "duration = 10.0", duration);
        place.refuses(["run", "scene.toml", "--csv", "/dev/full"], &["no space is left there"]);
    }
}

#[test]
fn the_scene_is_never_overwritten() {
    let place = Place::with_scene();
    fs::create_dir(place.path("folder")).unwrap();
    symlink("scene.toml", place.path("link.toml")).unwrap();
    for (scene, csv) in [
        ("scene.toml", "scene.toml"),
        ("scene.toml", "./scene.toml"),
        ("scene.toml", "folder/../scene.toml"),
        ("scene.toml", "link.toml"),
        ("link.toml", "scene.toml"),
        ("link.toml", "link.toml"),
    ] {
        place.refuses(
            ["run", scene, "--csv", csv],
            &[csv, "this is the scene itself", "of their own"],
        );
    }
    let path = place.path("scene.toml");
    place.refuses(["run".as_ref(), "scene.toml".as_ref(), "--csv".as_ref(), path.as_os_str()], &[]);
}

/// This folder stops even a user who may write everywhere.
#[test]
fn a_system_folder_takes_no_figures() {
    let place = Place::new();
    place.put("file", "not a folder");
    place.refuses(["paper", "--out", "file"], &["file cannot be written"]);
    place.refuses(
        ["paper", "--out", "file/figures"],
        &["file/figures", "part of the path is a file"],
    );
    place.refuses(["paper", "--out", "/proc/figures"], &["/proc/figures cannot be written"]);
    place.refuses(["paper", "--out", "/dev/full"], &["/dev/full cannot be written"]);
}

#[test]
fn an_output_replaces_what_was_there_and_nothing_else() {
    let place = Place::with_scene();
    place.put("rows.csv", "old");
    place.put("target.csv", "old");
    symlink("target.csv", place.path("link.csv")).unwrap();
    symlink("fresh.csv", place.path("ahead.csv")).unwrap();
    for csv in ["rows.csv", "link.csv", "ahead.csv"] {
        place.run(["run", "scene.toml", "--csv", csv]).ended(0, &["peak force"]);
    }
    let names = ["ahead.csv", "fresh.csv", "link.csv", "rows.csv", "scene.toml", "target.csv"];
    // Beside each stands what it holds, under the name that was asked for.
    let beside = ["ahead.json", "link.json", "rows.json"];
    let mut all: Vec<&str> = names.into_iter().chain(beside).collect();
    all.sort_unstable();
    assert_eq!(place.names("."), all);
    assert!(place.path("link.csv").is_symlink() && place.path("ahead.csv").is_symlink());
    assert!(place.text("rows.csv").starts_with("t,x,"));
    assert_eq!(place.text("rows.csv"), place.text("target.csv"));
    assert_eq!(place.text("rows.csv"), place.text("fresh.csv"));
    assert_eq!(place.text("scene.toml"), SCENE);
}

#[test]
fn rows_may_go_to_a_device() {
    let place = Place::with_scene();
    let before = place.contents();
    place.run(["run", "scene.toml", "--csv", "/dev/null"]).ended(0, &["peak force"]);
    assert_eq!(place.contents(), before);
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}
