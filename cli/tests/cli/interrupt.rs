//! Interrupted commands.

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

/// Longest time that an interrupted command may take to end.
const SOON: Duration = Duration::from_millis(1500);

/// Place with a scene of hours of work: as many ticks as a run may have.
fn long() -> Place {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 1e7");
    place
}

/// Asks the command to end. A shell in the background lets its commands ignore INT, and the tests may run there.
fn interrupt(child: &Child) {
    let sent = Command::new("sh").args(["-c", &format!("kill -TERM {}", child.id())]).status();
    assert!(sent.unwrap().success());
}

#[track_caller]
fn interrupted(child: Child) {
    interrupt(&child);
    let said = Said::by_child(child);
    said.ended(130, &["interrupted", "no file was written"]);
    assert!(said.took < SOON, "{:?}", said.took);
}

/// Waits until the command writes rows to its temporary file.
fn begun(place: &Place) {
    let start = Instant::now();
    while !place.names(".").iter().any(|name| name.starts_with(".lyapunov-")) {
        assert!(start.elapsed() < Duration::from_secs(30), "no file appears");
        thread::sleep(Duration::from_millis(2));
    }
    thread::sleep(Duration::from_millis(100));
}

#[test]
fn an_interrupted_run_leaves_no_file() {
    let place = long();
    let before = place.contents();
    let child = place.command(["run", "scene.toml", "--csv", "rows.csv"]).start(Stdio::piped());
    begun(&place);
    interrupted(child);
    assert_eq!(place.contents(), before);
}

#[test]
fn an_interrupted_run_keeps_the_file_that_was_there() {
    let place = long();
    place.put("rows.csv", "rows of another run");
    let before = place.contents();
    let child = place.command(["run", "scene.toml", "--csv", "rows.csv"]).start(Stdio::piped());
    begun(&place);
    interrupted(child);
    assert_eq!(place.contents(), before);
}

#[test]
fn a_run_without_rows_is_interrupted_too() {
    let place = long();
    let child = place.command(["run", "scene.toml"]).start(Stdio::piped());
    // Nothing shows from outside that the run has begun.
    thread::sleep(Duration::from_millis(300));
    interrupted(child);
}

#[test]
fn an_interrupted_study_leaves_no_folder() {
    let place = Place::new();
    let child = place.command(["paper", "--out", "results"]).start(Stdio::piped());
    let start = Instant::now();
    while !place.path("results").is_dir() {
        assert!(start.elapsed() < Duration::from_secs(30), "no folder appears");
        thread::sleep(Duration::from_millis(2));
    }
    interrupted(child);
    assert!(place.contents().is_empty());
}

#[test]
fn an_interrupted_study_of_a_scene_removes_its_folder() {
    for study in ["accuracy", "explain"] {
        let place = long();
        let before = place.contents();
        let command = [study, "scene.toml", "--out", "results"];
        let child = place.command(command).start(Stdio::piped());
        let start = Instant::now();
        while !place.path("results").is_dir() {
            assert!(start.elapsed() < Duration::from_secs(30), "no folder appears");
            thread::sleep(Duration::from_millis(2));
        }
        interrupted(child);
        assert_eq!(place.contents(), before);
    }
}

/// The pipe is full and nobody reads it: the run is blocked in a write that no signal ends.
#[test]
fn a_run_blocked_by_its_reader_is_interrupted() {
    let place = long();
    let mut child = place.command(["run", "scene.toml", "--csv", "-"]).start(Stdio::piped());
    let mut rows = child.stdout.take().unwrap();
    rows.read_exact(&mut [0]).unwrap();
    thread::sleep(Duration::from_millis(100));
    interrupted(child);
}
