//! Two processes and one folder, and what killed processes leave in it.

use std::fs;
use std::process::{Child, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

const X: &str = "environment.wall.stiffness=500..20000:200";
const Y: &str = "environment.wall.damping=0..20:200";

fn map<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let all = ["map", "long.toml", "--x", X, "--y", Y, "--quiet"];
    all.iter().chain(more).copied().collect()
}

/// A place with a scene whose map takes long, and a short one.
fn place() -> Place {
    let place = Place::with_scene();
    place.put_scene("long.toml", "duration = 10.0", "duration = 3000.0");
    place
}

/// The command, once `file` is there.
fn begun(place: &Place, command: &[&str], file: &str) -> Child {
    let mut child = place.command(command).start(Stdio::piped());
    let start = Instant::now();
    while !place.path(file).exists() {
        if start.elapsed() > Duration::from_secs(50) {
            let _ = child.kill();
            panic!("no {file} appears");
        }
        thread::sleep(Duration::from_millis(5));
    }
    child
}

fn kill(mut child: Child) {
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn a_folder_in_use_is_refused_until_its_process_ends() {
    let place = place();
    let first = begun(&place, &map(&["--out", "out"]), "out/map.part.csv");
    for command in [
        map(&["--out", "out"]),
        map(&["--out", "out", "--resume"]),
        map(&["--out", "out", "--shard", "0/2"]),
        vec!["run", "scene.toml", "--out", "out"],
        vec!["run", "scene.toml", "--out", "./out/../out"],
    ] {
        let said = place.run(&command);
        said.ended(2, &["in use: another process", "wait for its end"]);
    }
    place.run(["run", "scene.toml", "--out", "other"]).ended(0, &[]);
    kill(first);
    // A lock ends with its process, however that ended.
    place.run(["run", "scene.toml", "--out", "out"]).ended(0, &[]);
    place.run(map(&["--out", "out"])).ended(2, &["unfinished map"]);
}

#[test]
fn shards_share_a_folder_and_not_a_table() {
    let place = place();
    let share =
        |index, more: &[&'static str]| map(&[&["--out", "out", "--shard", index], more].concat());
    let first = begun(&place, &share("0/3", &[]), "out/map-0-of-3.part.csv");
    let second = begun(&place, &share("1/3", &[]), "out/map-1-of-3.part.csv");
    let said = place.run(share("0/3", &["--resume"]));
    said.ended(2, &["map-0-of-3.part.csv is in use"]);
    place.run(map(&["--out", "out"])).ended(2, &["out is in use"]);
    kill(first);
    kill(second);
}

/// Names of temporary files in a folder.
fn temporary(place: &Place, folder: &str) -> Vec<String> {
    place.names(folder).into_iter().filter(|name| name.starts_with(".lyapunov-")).collect()
}

#[test]
fn what_a_killed_process_leaves_is_removed_by_the_next() {
    let place = place();
    place.put_scene("endless.toml", "duration = 10.0", "duration = 1e7");
    let started = |command: &[&str], folder: &str| {
        let mut child = place.command(command).start(Stdio::piped());
        let start = Instant::now();
        while !place.path(folder).is_dir() || temporary(&place, folder).is_empty() {
            if start.elapsed() > Duration::from_secs(50) {
                let _ = child.kill();
                panic!("no file appears");
            }
            thread::sleep(Duration::from_millis(2));
        }
        thread::sleep(Duration::from_millis(200));
        child
    };
    let lives = started(&["run", "endless.toml", "--csv", "living.csv"], ".");
    let living = temporary(&place, ".");
    assert_eq!(living.len(), 1);
    // Files that only look alike are somebody else's.
    for name in [".lyapunov-notes.txt", ".lyapunov-", "lyapunov-abcdef", ".lyapunov-ab/def"] {
        fs::write(place.path(name.replace('/', "_")), "mine").unwrap();
    }
    let others = place.names(".");
    fs::create_dir(place.path("out")).unwrap();
    kill(started(&["run", "endless.toml", "--out", "out"], "out"));
    assert_eq!(temporary(&place, "out").len(), 1);
    place.run(["run", "scene.toml", "--out", "out"]).ended(0, &[]);
    assert_eq!(place.names("out"), ["report.html", "run.csv", "run.json", "run.png", "run.svg"]);
    let dead = ["run", "endless.toml", "--csv", "dead.csv"];
    let mut dead = place.command(dead).start(Stdio::piped());
    let start = Instant::now();
    while place.names(".").len() < others.len() + 2 && start.elapsed() < Duration::from_secs(50) {
        thread::sleep(Duration::from_millis(2));
    }
    thread::sleep(Duration::from_millis(200));
    dead.kill().unwrap();
    dead.wait().unwrap();
    assert_eq!(place.names(".").len(), others.len() + 2);
    place.run(["run", "scene.toml", "--csv", "rows.csv"]).ended(0, &[]);
    // The file of the process that lives stays.
    let mut expected = [&others[..], &["out", "rows.csv", "rows.json"].map(str::to_owned)].concat();
    expected.sort();
    assert_eq!(place.names("."), expected);
    kill(lives);
}

/// Two maps that begin at the same moment: one of them is refused, or comes after the other.
#[test]
fn of_two_processes_at_once_none_spoils_the_other() {
    let place = place();
    let small = ["map", "scene.toml", "--x", "environment.wall.stiffness=500..20000:6"];
    let small = [&small[..], &["--y", "environment.wall.damping=0..20:6", "--quiet"]].concat();
    place.run([&small[..], &["--out", "whole"]].concat()).ended(0, &[]);
    for round in 0..8 {
        let folder = format!("out-{round}");
        let command = [&small[..], &["--out", &folder]].concat();
        let both = [0, 1].map(|_| place.command(&command).start(Stdio::piped()));
        let said = both.map(Said::by_child);
        assert!(said.iter().any(|said| said.status == Some(0)), "{said:?}");
        assert!(
            said.iter().all(|it| it.status == Some(0) || it.err.contains("in use")),
            "{said:?}"
        );
        assert_eq!(place.text(&format!("{folder}/map.csv")), place.text("whole/map.csv"));
        assert_eq!(place.names(&folder), place.names("whole"));
    }
}
