//! Every write, rename and sync of a command that fails once, in turn, and what reaches the disk in which order. `strace`
//! makes the calls fail and tells them; without it these tests say so and are skipped.

#![cfg(target_os = "linux")]

use std::fs;
use std::io::{self, Write};
use std::process::Command;

use crate::cli::disaster::{are_whole, files, map, place, share};
use crate::cli::place::Place;
use crate::cli::said::Said;

/// The calls that put something on a disk, each with an error that it may give.
const CALLS: [(&str, &str); 4] = [
    ("write", "ENOSPC"),
    ("fsync", "EIO"),
    ("fdatasync", "EIO"),
    ("?rename,?renameat,renameat2,?link,linkat", "EIO"),
];

fn is_there() -> bool {
    let traced = Command::new("strace").args(["-f", "-o", "/dev/null", "true"]).status();
    let is_there = traced.is_ok_and(|status| status.success());
    if !is_there {
        // Not by the macro, whose text is kept from whoever runs the tests.
        let told = writeln!(
            io::stderr(),
            "SKIPPED: faults of single calls: no strace that may trace a process"
        );
        told.unwrap();
    }
    is_there
}

/// The command under `strace`, which writes to the file `trace`.
fn traced(place: &Place, options: &[&str], command: &[&str]) -> Said {
    let mut strace = Command::new("strace");
    strace.args(["-f", "-y", "-o", "trace", "-s", "0"]).args(options);
    strace.arg(env!("CARGO_BIN_EXE_lyapunov")).args(command);
    Said::by(strace.current_dir(place.path(".")))
}

/// Lets call number 1, 1 + `stride` and so on of each kind fail, in a folder with earlier files, as long as there is one that
/// fails; `check` looks at the folder afterwards.
fn sweep(
    place: &Place,
    command: &[&str],
    stride: usize,
    mut check: impl FnMut(&Place, &str, &Said),
) -> usize {
    let mut faults = 0;
    for (call, error) in CALLS {
        for number in (1..).step_by(stride) {
            let _ = fs::remove_dir_all(place.path("out"));
            fs::create_dir(place.path("out")).unwrap();
            for name in place.names("whole") {
                fs::write(place.path(format!("out/{name}")), "before").unwrap();
            }
            let fault = format!("inject={call}:error={error}:when={number}");
            let said = traced(place, &["-e", &format!("trace={call}"), "-e", &fault], command);
            if !place.text("trace").contains("(INJECTED)") {
                said.ended(0, &[]);
                break;
            }
            faults += 1;
            check(place, &fault, &said);
        }
    }
    faults
}

/// Whether two results are the same; of a command that measures times, the end of a picture, the number of lines of a text.
fn is_alike(command: &str, bytes: &[u8], whole: &[u8]) -> bool {
    let are_timed = matches!(command, "compare" | "accuracy" | "effects");
    let alike = if whole.starts_with(b"\x89PNG") {
        bytes.starts_with(b"\x89PNG") && bytes.ends_with(b"IEND\xAE\x42\x60\x82")
    } else {
        let lines = |bytes: &[u8]| bytes.split(|it| *it == b'\n').count();
        lines(bytes) == lines(whole) && bytes.last() == whole.last()
    };
    bytes == whole || are_timed && alike
}

/// Lets each call of a command fail that writes a folder of results.
fn is_told(command: &[&str]) {
    some_are_told(command, 1);
}

/// Lets one of `stride` calls of a command fail that writes a folder of results.
fn some_are_told(command: &[&str], stride: usize) {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 1.0");
    let log = include_str!("../../../scenes/logs/mujoco-encoder.csv");
    place.put("log.csv", log.lines().take(500).collect::<Vec<_>>().join("\n"));
    for half in ["0/2", "1/2"] {
        let cells = ["--x", "environment.wall.stiffness=500..20000:3", "--y"];
        let more = ["device.damping=0.1..1:2", "--shard", half, "--out", "shards", "--quiet"];
        place.run([&["map", "scene.toml"], &cells[..], &more].concat()).ended(0, &[]);
    }
    // The page tells the command, and so the folder.
    let command = [command, &["--quiet", "--out", "out"]].concat();
    place.run(&command).ended(0, &[]);
    let whole = files(&place, "out");
    fs::rename(place.path("out"), place.path("whole")).unwrap();
    let faults = sweep(&place, &command, stride, |place, fault, said| {
        said.ended(2, &["cannot be written"]);
        for (name, bytes) in files(place, "out") {
            let is_whole = bytes == b"before" || is_alike(command[0], &bytes, &whole[&name]);
            assert!(is_whole, "{command:?}, {fault}: {name} is half-written");
        }
        assert_eq!(place.names("out"), place.names("whole"), "{command:?}, {fault}");
        // Only a fault of the names themselves comes after files have theirs.
        if fault.contains("=write") || fault.contains("=fdatasync") {
            let found = files(place, "out");
            assert!(found.values().all(|bytes| bytes == b"before"), "{command:?}, {fault}");
        }
    });
    // Each file is written, synced and renamed, and their folder is synced.
    assert!(faults * stride > 3 * whole.len(), "{command:?}: {faults}");
}

#[test]
fn a_fault_of_any_call_leaves_whole_files_and_is_told() {
    if !is_there() {
        return;
    }
    is_told(&["run", "scene.toml"]);
    is_told(&["explain", "scene.toml"]);
    is_told(&["bound", "scene.toml"]);
    is_told(&["observe", "log.csv"]);
    is_told(&["map", "scene.toml", "--x", "environment.wall.stiffness=500..20000:3"]);
    is_told(&["tune", "scene.toml", "--stabilizers", "popc", "--trials", "2", "--runs", "2"]);
}

#[test]
fn a_fault_of_any_call_of_a_study_leaves_whole_files_and_is_told() {
    if !is_there() {
        return;
    }
    is_told(&["identify", "log.csv"]);
    is_told(&["compare", "scene.toml", "--stabilizers", "none,popc"]);
    some_are_told(&["paper", "--draws", "1"], 5);
}

#[test]
#[ignore = "four minutes: it measures, or runs the whole catalogue, for each call"]
fn a_fault_of_any_call_of_a_long_study_leaves_whole_files_and_is_told() {
    if is_there() {
        is_told(&["map", "merge", "shards"]);
        is_told(&["accuracy", "scene.toml"]);
        is_told(&["effects", "scene.toml"]);
        is_told(&["hard"]);
        is_told(&["paper", "--draws", "1"]);
    }
}

#[test]
fn a_map_that_meets_any_fault_is_resumed_to_the_same_bytes() {
    if !is_there() {
        return;
    }
    let place = place();
    place.run(share(&["--out", "whole"])).ended(0, &[]);
    let whole = files(&place, "whole");
    let faults = sweep(&place, &share(&["--out", "out"]), 1, |place, fault, said| {
        said.ended(2, &["cannot be written"]);
        are_whole(place, "out", &whole);
        assert!(!place.names("out").iter().any(|it| it.starts_with(".lyapunov-")), "{fault}");
        place.run(share(&["--out", "out", "--resume"])).ended(0, &[]);
        assert_eq!(files(place, "out"), whole, "{fault}");
        assert_eq!(place.names("out"), place.names("whole"), "{fault}");
    });
    // The unfinished table is begun and grows, the finished one is written and renamed, and both have a folder.
    assert!(faults >= 8, "{faults}");
    // In a whole map the files before the fault have their names.
    place.run(map(&["--out", "whole"])).ended(0, &[]);
    let whole = files(&place, "whole");
    let fault =
        ["-e", "trace=renameat", "-e", "inject=?rename,renameat,renameat2:error=EIO:when=9"];
    traced(&place, &fault, &map(&["--out", "out"])).ended(2, &["cannot be written"]);
    are_whole(&place, "out", &whole);
    place.run(map(&["--out", "out", "--resume"])).ended(0, &[]);
    let found = files(&place, "out");
    assert!(whole.iter().all(|(name, bytes)| found.get(name) == Some(bytes)));
}

/// Order of calls against a power failure: each file is synced before it is renamed, and the folder after it.
#[test]
fn a_file_is_on_the_disk_before_it_has_its_name_and_then_its_name_is() {
    if !is_there() {
        return;
    }
    let place = place();
    let only = ["-e", "trace=fsync,fdatasync,?rename,?renameat,renameat2,write"];
    let table = share(&["--out", "out"]);
    let commands: [(&[&str], usize); 3] = [
        (&["run", "scene.toml", "--csv", "rows.csv"], 2),
        (&["run", "scene.toml", "--out", "results"], 5),
        (&table, 1),
    ];
    for (command, expected) in commands {
        traced(&place, &only, command).ended(0, &[]);
        let trace = place.text("trace");
        let lines: Vec<&str> = trace.lines().collect();
        let mut renamed = 0;
        for (at, line) in lines.iter().enumerate().filter(|(_, line)| line.contains("rename")) {
            let start = line.find(".lyapunov-").unwrap();
            let name = &line[start..start + ".lyapunov-".len() + 6];
            let before: Vec<&str> =
                lines[..at].iter().copied().filter(|it| it.contains(name)).collect();
            let last = before.iter().rposition(|it| it.contains("write(")).unwrap();
            assert!(before[last..].iter().any(|it| it.contains("fsync(")), "{line}");
            renamed += 1;
        }
        assert_eq!(renamed, expected);
        let last = lines.iter().rposition(|line| line.contains("rename")).unwrap();
        let folder = fs::canonicalize(place.path(".")).unwrap().display().to_string();
        let is_folder = |it: &&&str| it.contains("fsync(") && it.contains(&format!("<{folder}"));
        assert!(
            lines[last..].iter().any(|it| is_folder(&it) && !it.contains(".lyapunov-")),
            "{trace}"
        );
        // Each band of the unfinished table is synced.
        if command[0] == "map" {
            let part: Vec<&&str> = lines.iter().filter(|it| it.contains(".part.csv>")).collect();
            let writes = part.iter().filter(|it| it.contains("write(")).count();
            let syncs = part.iter().filter(|it| it.contains("sync(")).count();
            assert!(writes > 1 && syncs >= writes, "{writes} writes, {syncs} syncs");
        }
    }
}
