//! Signals that are ignored, and commands that are blocked.

use std::fs;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

/// Time after which a command has begun, and after which it would have ended.
const WHILE: Duration = Duration::from_millis(700);

fn send(child: &Child, signal: &str) {
    let kill = format!("kill -{signal} {}", child.id());
    assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
}

const MAP: [&str; 8] = [
    "map",
    "scene.toml",
    "--x",
    "environment.wall.stiffness=500..20000:300",
    "--y",
    "environment.wall.damping=0..20:300",
    "--out",
    "out",
];

/// As `nohup` starts a command, and a shell one in the background.
#[test]
fn an_ignored_signal_stays_ignored_and_another_is_heeded() {
    let place = Place::long();
    for signal in ["HUP", "INT"] {
        for command in [&MAP[..], &["run", "scene.toml", "--csv", "rows.csv"]] {
            let script = format!("trap '' {signal}; exec \"$0\" \"$@\"");
            let mut shell = Command::new("sh");
            shell.args(["-c", &script, env!("CARGO_BIN_EXE_lyapunov")]).args(command);
            let mut child = shell.current_dir(place.path(".")).start(Stdio::piped());
            thread::sleep(WHILE);
            send(&child, signal);
            thread::sleep(WHILE);
            assert!(child.try_wait().unwrap().is_none(), "{signal} ended {command:?}");
            send(&child, "TERM");
            Said::by_child(child).ended(130, &["interrupted"]);
            let _ = fs::remove_dir_all(place.path("out"));
            assert_eq!(place.names("."), ["scene.toml"]);
        }
    }
}

/// A pipe that nobody writes to, or reads from.
#[test]
fn a_command_blocked_by_a_pipe_is_interrupted() {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 1.0");
    let motion = include_str!("../../../scenes/motion-file.toml");
    place.put("motion.toml", motion.replace("motion-file.csv", "pipe"));
    assert!(Command::new("mkfifo").arg(place.path("pipe")).status().unwrap().success());
    let axes = ["--x", "device.mass=0.1..0.4:3", "--y", "duration=1..2:2"];
    let map = [&["map", "pipe"], &axes[..], &["--out", "out"]].concat();
    let commands: [&[&str]; 9] = [
        &["run", "pipe"],
        &["run", "motion.toml"],
        &["run", "scene.toml", "--csv", "pipe"],
        &["compare", "pipe", "--out", "out"],
        &["tune", "pipe", "--out", "out"],
        &["explain", "pipe", "--out", "out"],
        &["accuracy", "pipe", "--out", "out"],
        &["observe", "pipe", "--out", "out"],
        &map,
    ];
    let before = place.contents();
    for command in commands {
        let child = place.command(command).start(Stdio::piped());
        thread::sleep(WHILE);
        send(&child, "TERM");
        let said = Said::by_child(child);
        said.ended(130, &["interrupted"]);
        assert!(said.took < 4 * WHILE, "{command:?}: {:?}", said.took);
        assert_eq!(place.contents(), before, "{command:?}");
    }
    // Shards are read more than once.
    place.refuses(["map", "merge", "pipe", "--out", "out"], &["pipe is no file"]);
}
