//! Standard output and standard error, into pipes, full devices and closed readers.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

fn full() -> Stdio {
    File::options().write(true).open("/dev/full").unwrap().into()
}

#[test]
fn rows_and_summary_each_have_a_stream() {
    let place = Place::with_scene();
    let to_file = place.run(["run", "scene.toml", "--csv", "rows.csv"]);
    let streamed = place.run(["run", "scene.toml", "--csv", "-"]);
    to_file.ended(0, &[]);
    streamed.ended(0, &[]);
    assert_eq!(to_file.err, "");
    assert_eq!(streamed.out, place.text("rows.csv"));
    assert_eq!(streamed.err, to_file.out);
    assert_eq!(streamed.out.lines().count(), 1002);
    assert_eq!(place.run(["run", "scene.toml"]).out, to_file.out);
    assert_eq!(place.names("."), ["rows.csv", "rows.json", "scene.toml"]);
}

#[test]
fn two_runs_give_the_same_bytes() {
    for scalar in ["f64", "f32"] {
        let place = Place::new();
        let scalar = format!("scalar = \"{scalar}\"\nduration = 10.0");
        place.put_scene("scene.toml", "duration = 10.0", &scalar);
        for csv in ["one.csv", "two.csv"] {
            place.run(["run", "scene.toml", "--csv", csv]).ended(0, &[]);
        }
        assert_eq!(place.text("one.csv"), place.text("two.csv"));
    }
}

/// The reader closes the pipe, as `head -1` does, early in the rows and before the first.
#[test]
fn a_reader_that_has_enough_ends_the_run_quietly() {
    let place = Place::long();
    for lines in [0, 1, 1000] {
        let mut child = place.command(["run", "scene.toml", "--csv", "-"]).start(Stdio::piped());
        let rows = BufReader::new(child.stdout.take().unwrap());
        assert_eq!(rows.lines().take(lines).count(), lines);
        let said = Said::by_child(child);
        said.ended(0, &[]);
        assert_eq!(said.err, "");
    }
}

#[test]
fn a_reader_gone_before_the_summary_costs_no_rows() {
    let place = Place::with_scene();
    let mut child = place.command(["run", "scene.toml", "--csv", "rows.csv"]).start(Stdio::piped());
    drop(child.stdout.take());
    Said::by_child(child).ended(0, &[]);
    assert_eq!(place.text("rows.csv").lines().count(), 1002);
}

#[test]
fn a_full_standard_output_is_reported() {
    let place = Place::with_scene();
    let before = place.contents();
    for arguments in [
        &["run", "scene.toml", "--csv", "-"][..],
        &["run", "scene.toml"],
        &["--help"],
        &["map", "--help"],
        &["--version"],
    ] {
        let said = Said::by_child(place.command(arguments).start(full()));
        said.ended(2, &["standard output cannot be written: no space is left there"]);
        assert_eq!(place.contents(), before);
    }
}

#[test]
fn a_full_standard_error_changes_no_status() {
    let place = Place::with_scene();
    for (arguments, status) in [
        (&["run", "missing.toml"][..], 2),
        (&["run", "scene.toml", "--csv", "missing/rows.csv"], 2),
        (&["run", "scene.toml", "--csv", "-"], 0),
        (&["run"], 2),
    ] {
        let mut command = place.command(arguments);
        let child = command.stdout(Stdio::piped()).stderr(full()).spawn().unwrap();
        Said::by_child(child).ended(status, &[]);
    }
}

/// Enough ticks for a progress bar on a terminal; rows kept in memory would take some 400 MB.
#[cfg(target_os = "linux")]
#[test]
fn a_long_run_is_silent_until_its_end_and_small() {
    use std::{fs, thread, time::Duration};

    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 4e4");
    let mut child = place.command(["run", "scene.toml"]).start(Stdio::piped());
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    while child.try_wait().unwrap().is_none() {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let kilobytes = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = kilobytes.and_then(|size| size.trim().strip_suffix(" kB")?.parse().ok());
        peak = kilobytes.unwrap_or(0).max(peak);
        thread::sleep(Duration::from_millis(1));
    }
    let said = Said::by_child(child);
    said.ended(0, &["run 40000 s at 100 Hz"]);
    assert_eq!(said.err, "");
    assert!((1..32_000).contains(&peak), "{peak} kB");
}
