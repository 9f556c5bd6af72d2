//! Interrupted commands.

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

/// Longest time that an interrupted command may take to end.
const SOON: Duration = Duration::from_millis(1500);

const RUN: [&str; 4] = ["run", "scene.toml", "--csv", "rows.csv"];

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

fn wait_for(what: &str, shows: impl Fn() -> bool) {
    let start = Instant::now();
    while !shows() {
        assert!(start.elapsed() < Duration::from_secs(30), "no {what} appears");
        thread::sleep(Duration::from_millis(2));
    }
}

/// Waits until the command writes rows to its temporary file.
fn has_rows(place: &Place) {
    wait_for("file", || place.names(".").iter().any(|name| name.starts_with(".lyapunov-")));
    thread::sleep(Duration::from_millis(100));
}

fn has_a_folder(place: &Place) {
    wait_for("folder", || place.path("results").is_dir());
}

/// Interrupts a command that has `begun`: it leaves the place as it was.
#[track_caller]
fn undone(place: &Place, command: &[&str], begun: fn(&Place)) {
    let before = place.contents();
    let child = place.command(command).start(Stdio::piped());
    begun(place);
    interrupted(child);
    assert_eq!(place.contents(), before);
}

#[test]
fn an_interrupted_run_leaves_no_file() {
    undone(&Place::long(), &RUN, has_rows);
}

#[test]
fn an_interrupted_run_keeps_the_file_that_was_there() {
    let place = Place::long();
    place.put("rows.csv", "rows of another run");
    undone(&place, &RUN, has_rows);
}

#[test]
fn a_run_without_rows_is_interrupted_too() {
    let place = Place::long();
    let child = place.command(["run", "scene.toml"]).start(Stdio::piped());
    // Nothing shows from outside that the run has begun.
    thread::sleep(Duration::from_millis(300));
    interrupted(child);
}

#[test]
fn an_interrupted_study_leaves_no_folder() {
    undone(&Place::new(), &["paper", "--out", "results"], has_a_folder);
}

#[test]
fn an_interrupted_study_of_a_scene_removes_its_folder() {
    for study in ["accuracy", "explain"] {
        undone(&Place::long(), &[study, "scene.toml", "--out", "results"], has_a_folder);
    }
}

/// The pipe is full and nobody reads it: the run is blocked in a write that no signal ends.
#[test]
fn a_run_blocked_by_its_reader_is_interrupted() {
    let place = Place::long();
    let mut child = place.command(["run", "scene.toml", "--csv", "-"]).start(Stdio::piped());
    let mut rows = child.stdout.take().unwrap();
    rows.read_exact(&mut [0]).unwrap();
    thread::sleep(Duration::from_millis(100));
    interrupted(child);
}
