//! Maps that are killed at random moments, or run out of room: no file is half-written, and what is resumed equals the
//! uninterrupted map byte for byte.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

/// Kills of one map before it may end.
const IN_A_ROW: u32 = 10;

/// Numbers without an order (Marsaglia's xorshift).
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> u64 {
        for shift in [13, -7, 17] {
            self.0 ^= if shift > 0 { self.0 << shift } else { self.0 >> -shift };
        }
        self.0
    }
}

/// A share of a map: a table that is computed in bands and written at the end. The pictures of a whole map would take most of
/// the time.
pub(crate) fn share<'a>(more: &[&'a str]) -> Vec<&'a str> {
    map(&[&["--shard", "0/2"], more].concat())
}

/// A whole map.
pub(crate) fn map<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let axes =
        ["--x", "environment.wall.stiffness=500..20000:7", "--y", "initial.velocity=0..0.1:6"];
    let all = [&["map", "scene.toml"], &axes[..], &["--stabilizers", "none,tank", "--quiet"]];
    all.concat().iter().chain(more).copied().collect()
}

pub(crate) fn place() -> Place {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 40.0");
    place
}

/// The files of a folder that do not tell times; those still being written are left out.
pub(crate) fn files(place: &Place, folder: &str) -> BTreeMap<String, Vec<u8>> {
    let names = place.names(folder).into_iter();
    let told = names.filter(|name| {
        let is_unfinished = name.starts_with(".lyapunov-") || name.ends_with(".part.csv");
        !is_unfinished && name != "map.json"
    });
    told.map(|name| (name.clone(), fs::read(place.path(format!("{folder}/{name}"))).unwrap()))
        .collect()
}

/// Checks that each file of `folder` is one of the `whole` ones, or is as it was before.
#[track_caller]
pub(crate) fn are_whole(place: &Place, folder: &str, whole: &BTreeMap<String, Vec<u8>>) {
    for (name, bytes) in files(place, folder) {
        assert!(bytes == b"before" || whole.get(&name) == Some(&bytes), "{name} is half-written");
    }
    if let Ok(json) = fs::read_to_string(place.path(format!("{folder}/map.json"))) {
        let told = serde_json::from_str::<serde_json::Value>(&json);
        assert!(json == "before" || told.is_ok_and(|it| it["areas"].is_array()), "{json}");
    }
}

/// Kills `command` at `kills` moments, resumes it, and compares.
fn killed(command: fn(&[&'static str]) -> Vec<&'static str>, kills: u32) {
    let place = place();
    let whole = place.run(command(&["--out", "whole"]));
    whole.ended(0, &[]);
    let (takes, whole) = (whole.took.as_micros() as u64, files(&place, "whole"));
    let (mut draws, mut killed, mut ended) = (Draws(0x9e37_79b9_7f4a_7c15), 0, 0);
    let table = whole.keys().find(|name| name.ends_with(".csv")).unwrap();
    while killed < kills {
        fs::create_dir(place.path("out")).unwrap();
        fs::write(place.path(format!("out/{table}")), "before").unwrap();
        let resume = command(&["--out", "out", "--resume"]);
        for _ in 0..IN_A_ROW.min(kills) {
            let mut child = place.command(&resume).start(Stdio::piped());
            thread::sleep(Duration::from_micros(draws.next() % takes));
            child.kill().unwrap();
            let status = child.wait().unwrap();
            // It ended by itself, or by the signal that cannot be caught.
            assert!(status.success() || status.signal() == Some(9), "{status}");
            killed += u32::from(!status.success());
            ended += u32::from(status.success());
            are_whole(&place, "out", &whole);
        }
        place.run(&resume).ended(0, &[]);
        assert_eq!(files(&place, "out"), whole);
        assert_eq!(place.names("out"), place.names("whole"));
        fs::remove_dir_all(place.path("out")).unwrap();
    }
    assert!(ended < 2 * kills, "{killed} killed, {ended} ended before");
}

#[test]
fn a_map_that_is_killed_at_any_moment_is_resumed_to_the_same_bytes() {
    killed(share, 30);
    killed(map, 3);
}

#[test]
#[ignore = "minutes; its last result is in docs/guarantees.md"]
fn a_map_that_is_killed_at_200_moments_is_resumed_to_the_same_bytes() {
    killed(share, 200);
}

/// No file may become longer than a limit, which stands for a disk that fills up at any place.
#[test]
fn a_map_that_runs_out_of_room_is_resumed_to_the_same_bytes() {
    out_of_room(share, "map-0-of-2.csv", 6);
    out_of_room(map, "map.csv", 2);
}

/// Runs `command` with so many `limits`, the first of them small, resumes it, and compares.
fn out_of_room(command: fn(&[&'static str]) -> Vec<&'static str>, table: &str, limits: usize) {
    let place = place();
    place.run(command(&["--out", "whole"])).ended(0, &[]);
    let whole = files(&place, "whole");
    let longest = whole.values().map(Vec::len).max().unwrap() as u64 / 512;
    let mut draws = Draws(0x2545_f491_4f6c_dd1d);
    let small = (0..limits as u64).filter(|blocks| *blocks < limits as u64 / 3);
    let drawn = std::iter::repeat_with(|| draws.next() % longest);
    for blocks in small.chain(drawn).take(limits).collect::<Vec<_>>() {
        fs::create_dir(place.path("out")).unwrap();
        for name in [table, "report.html", "verdict.svg"] {
            fs::write(place.path(format!("out/{name}")), "before").unwrap();
        }
        let resume = command(&["--out", "out", "--resume"]);
        let script = format!("ulimit -f {blocks}; exec \"$0\" \"$@\"");
        let mut shell = Command::new("sh");
        shell.args(["-c", &script, env!("CARGO_BIN_EXE_lyapunov")]).args(&resume);
        let said = Said::by(shell.current_dir(place.path(".")));
        said.ended(2, &["cannot be written"]);
        // Nothing has its name before all are whole.
        for name in [table, "report.html", "verdict.svg"] {
            assert_eq!(place.text(&format!("out/{name}")), "before", "{blocks} blocks");
        }
        assert!(!place.names("out").iter().any(|name| name.starts_with(".lyapunov-")));
        place.run(&resume).ended(0, &[]);
        let found = files(&place, "out");
        assert!(whole.iter().all(|(name, bytes)| found[name] == *bytes), "{blocks} blocks");
        fs::remove_dir_all(place.path("out")).unwrap();
    }
}
