//! Logs that arrive slowly or without end.
#![cfg(target_os = "linux")]

use std::fmt::Write as _;
use std::fs;
use std::io::Write;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::observe::command::{command, ended};

/// Largest memory, in KiB, that the command took for a log of this many rows.
fn peak(rows: u32) -> u64 {
    let mut child = command(&["-", "--json"]).stdin(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all(b"t,x,f\n").unwrap();
    let mut text = String::new();
    for row in 0..rows {
        let (t, x) = (f64::from(row) * 1e-3, (f64::from(row) * 0.01).sin());
        // The log has contacts, debts, bad rows and gaps, since each might take memory.
        match row % 1000 {
            7 => text.push_str("bad,row\n"),
            8 => {}
            _ => writeln!(text, "{t},{x},{}", (x * 100.0).max(0.0)).unwrap(),
        }
        if text.len() > 1 << 16 {
            input.write_all(text.as_bytes()).unwrap();
            text.clear();
        }
    }
    input.write_all(text.as_bytes()).unwrap();
    // By now the command has read all but the bytes that the pipe holds.
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
    drop(input);
    assert_eq!(ended(child).status, Some(0));
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    line.trim().trim_end_matches(" kB").parse().unwrap()
}

#[test]
fn memory_does_not_grow_with_the_log() {
    let (short, long) = (peak(1_000_000), peak(4_000_000));
    assert!(long < short + 1024, "{short} KiB, then {long} KiB");
    assert!(long < 64 * 1024, "{long} KiB");
}

/// A command that waits for rows ends with status 130, and writes nothing.
#[test]
fn an_interrupt_ends_a_command_that_waits() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let arguments = ["-", "--out", out.to_str().unwrap()];
    let mut child = command(&arguments).stdin(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    // Once the command reads, its interrupt handler is in place.
    input.write_all(&b"t,x,f\n0,0,0\n1,1,1\n".repeat(20_000)).unwrap();
    thread::sleep(Duration::from_millis(200));
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-TERM", &id]).status().unwrap().success());
    let ended = ended(child);
    assert_eq!((ended.status, ended.out.as_str()), (Some(130), ""));
    assert!(ended.error.contains("interrupted"));
    assert!(!out.exists());
    drop(input);
}
