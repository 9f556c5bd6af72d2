//! Memory of a map: that of its pictures and of a part of its axes, however long they are.

#![cfg(target_os = "linux")]

use std::fs;
use std::process::Stdio;
use std::thread;
use std::time::{Duration, Instant};

use crate::cli::place::Place;
use crate::cli::said::Start;

/// The largest memory of the map of so many by so many cells once it has rows, kB.
fn peak(place: &Place, count: &str) -> u64 {
    let folder = format!("out-{count}");
    let (x, y) = (
        format!("environment.wall.stiffness=500..20000:{count}"),
        format!("environment.wall.damping=0..20:{count}"),
    );
    let command = ["map", "scene.toml", "--x", &x, "--y", &y, "--stabilizers", "none"];
    let command = [&command[..], &["--threads", "1", "--quiet", "--out", &folder]].concat();
    let mut child = place.command(&command).start(Stdio::piped());
    let (begun, part) = (Instant::now(), place.path(format!("{folder}/map.part.csv")));
    let has_rows = || fs::metadata(&part).is_ok_and(|found| found.len() > 20_000);
    while !has_rows() && begun.elapsed() < Duration::from_secs(120) {
        thread::sleep(Duration::from_millis(20));
    }
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
    let said = (has_rows(), child.try_wait().unwrap());
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(said, (true, None));
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    peak.trim().strip_suffix(" kB").unwrap().parse().unwrap()
}

/// Pictures have at most 512 by 512 elements; axes ten times as long take no more memory.
#[test]
fn memory_does_not_grow_with_the_grid() {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 0.5");
    let (long, longer) = (peak(&place, "20000"), peak(&place, "150000"));
    assert!(longer < long + 20_000, "{long} kB, then {longer} kB");
    assert!(longer < 200_000, "{longer} kB");
}
