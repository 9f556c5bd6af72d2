//! Hostile input, which gets an error with a remedy, exit status 2 and no file.

use std::fs::{self, File};
use std::path::Path;
use std::time::{Duration, Instant};

use crate::observe::command::{Ended, observe, run};

const GOOD: &str = "t,x,f\n0,0,1\n1,1,1\n2,0,1\n";

/// Asserts that the command refused the input for these reasons and printed nothing on standard output.
fn refused(ended: &Ended, reasons: &[&str]) {
    assert_eq!((ended.status, ended.out.as_str()), (Some(2), ""), "{}", ended.error);
    assert!(ended.error.starts_with("error: "), "{}", ended.error);
    assert!(ended.error.lines().all(|line| line.chars().count() <= 100), "{}", ended.error);
    for reason in reasons {
        assert!(ended.error.contains(reason), "no `{reason}` in: {}", ended.error);
    }
}

#[test]
fn files_that_are_no_logs_are_refused() {
    let cases: [(&[u8], &[&str]); 9] = [
        (b"", &["standard input: the log is empty"]),
        (b"\n\n\n", &["the log is empty"]),
        (b"# only a comment\n", &["the log is empty"]),
        (b"t,x,f\n", &["standard input: fewer than two good rows"]),
        (b"t,x,f\n1,2,3\n", &["fewer than two good rows"]),
        (
            b"t,x,f\n1,2\na,b,c\n",
            &["2 rows are bad, the first at line 2: 2 fields, not 3", "\n  = "],
        ),
        (b"\x7fELF\0\0\0\n", &["standard input:1: this is no text in UTF-8: it holds a byte 0"]),
        (b"\xff\xfet\0,\0x\0", &["this is no text"]),
        (b"0,1,2\n1,2,3\n", &["no column `t`", "the log has no names", "as in 1,2,3"]),
    ];
    for (log, reasons) in cases {
        refused(&observe(log, &[]), reasons);
    }
}

#[test]
fn columns_that_are_not_there_are_named_with_the_nearest() {
    let log = b"time,position,force,force\n0,0,1,1\n1,1,1,1\n";
    let asked = |columns| observe(log, &["--columns", columns]);
    let nearest = ["input:1: there is no column `tme`", "did you mean `time`?", "column of t"];
    refused(&asked("tme,position,3"), &nearest);
    refused(&asked("time,position,force"), &["two columns `force`: 3 and 4", "number"]);
    refused(&asked("time,position,9"), &["no column 9: this line has 4"]);
    refused(&asked("1,2,0"), &["no column `0`"]);
    refused(&asked("time,1,3"), &["column 1 would be both t and x"]);
    for (columns, reason) in
        [("t,x", "three or four"), ("t,,f", "three or four"), ("t,t,f", "twice")]
    {
        refused(&asked(columns), &[reason]);
    }
    assert_eq!(asked("time,position,3").status, Some(0));
    assert_eq!(asked("1,2,3").status, Some(0));
}

#[test]
fn options_out_of_range_are_refused_with_a_remedy() {
    let cases: [(&[&str], &str); 15] = [
        (&["--scale", "x"], "x=1e-3"),
        (&["--scale", "y=2"], "t, x, f and v"),
        (&["--scale", "x=0"], "other than 0"),
        (&["--scale", "x=nan"], "`nan` is no factor"),
        (&["--scale", "t=-1"], "must not run backwards"),
        (&["--scale", "v=2"], "no column of v to scale"),
        (&["--contact", "-1"], "the contact threshold is -1 N"),
        (&["--contact", "nan"], "finite force"),
        (&["--damping", "1"], "means nothing to the candidate spring"),
        (&["--candidate", "device-damping"], "needs a damping"),
        (&["--candidate", "device-damping", "--damping", "-2"], "the damping is -2 N.s/m"),
        (
            &["--candidate", "device-damping", "--damping", "1", "--surface", "0"],
            "the surface means",
        ),
        (&["--candidate", "mass-spring-damper", "--damping", "1"], "needs a surface"),
        (
            &["--candidate", "mass-spring-damper", "--damping", "1", "--surface", "inf"],
            "surface is",
        ),
        (&["--candidate", "sprung"], "spring"),
    ];
    for (options, reason) in cases {
        refused(&observe(GOOD.as_bytes(), options), &[reason]);
    }
}

#[test]
fn paths_that_hold_no_log_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    refused(&run(&[&path("missing.csv")]), &["missing.csv: there is no such file"]);
    refused(&run(&[&path("")]), &["this is a folder"]);

    // A gigabyte of zeros without a line break is refused at once.
    File::create(path("zeros.csv")).unwrap().set_len(1 << 30).unwrap();
    let start = Instant::now();
    refused(&run(&[&path("zeros.csv")]), &["zeros.csv:1: this is no row: the line is longer"]);
    #[cfg(unix)]
    refused(&run(&["/dev/zero"]), &["/dev/zero:1: this is no row"]);
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn zeros_behind_a_log_are_one_bad_row() {
    let mut log = GOOD.as_bytes().to_vec();
    log.resize(log.len() + (1 << 20), 0);
    let ended = observe(&log, &[]);
    assert_eq!(ended.status, Some(0));
    assert!(ended.out.contains("line 5: longer than 256 KiB"), "{}", ended.out);
}

#[test]
fn bad_rows_are_counted_and_named() {
    let mut log = GOOD.to_owned();
    log += "3,0\n3,zero,1\n3,,1\n3,NaN,1\n2,0,1\n\u{1b}[2J,0,1\n";
    log += &"4,0,1,\n".repeat(20);
    log += "5,0,0\n";
    let ended = observe(log.as_bytes(), &[]);
    assert_eq!((ended.status, ended.error.as_str()), (Some(0), ""));
    for told in [
        "26; the next good row spans the gap",
        "line 5: 2 fields, not 3",
        "line 6: x is `zero`, no number",
        "line 7: x is empty",
        "line 8: x is `NaN`, out of range",
        "line 9: t = 2.0 s is not after 2.0 s of line 4",
        "line 10: t is `\u{fffd}[2J`, no number",
        "and 16 more",
    ] {
        assert!(ended.out.contains(told), "no `{told}` in: {}", ended.out);
    }
}

/// After an error no file is there, after a success all are.
#[test]
fn files_are_written_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new/deep");
    let target = out.to_str().unwrap();
    refused(&observe(b"t,x,f\n", &["--out", target]), &["fewer than two"]);
    assert!(!folder.path().join("new").exists());

    let names = |path: &Path| {
        let found = fs::read_dir(path).unwrap().map(|entry| entry.unwrap().file_name());
        let mut names: Vec<_> = found.map(|name| name.into_string().unwrap()).collect();
        names.sort();
        names
    };
    let ended = observe(GOOD.as_bytes(), &["--out", target, "--quiet"]);
    assert_eq!((ended.status, ended.out.as_str(), ended.error.as_str()), (Some(0), "", ""));
    assert_eq!(
        names(&out),
        ["observe.csv", "observe.json", "observe.png", "observe.svg", "report.html"]
    );
    let both = observe(GOOD.as_bytes(), &["--json", "--quiet"]);
    assert_eq!((both.status, both.out.as_str()), (Some(2), ""));
    let json = observe(GOOD.as_bytes(), &["--json"]).out;
    assert_eq!(fs::read_to_string(out.join("observe.json")).unwrap(), json);
    assert!(fs::read(out.join("observe.png")).unwrap().starts_with(b"\x89PNG"));

    // If a file cannot be written, the command fails and the earlier files stay.
    let file = out.join("observe.json");
    refused(
        &observe(GOOD.as_bytes(), &["--out", file.to_str().unwrap()]),
        &["name a folder there"],
    );
    fs::remove_file(out.join("observe.png")).unwrap();
    fs::create_dir(out.join("observe.png")).unwrap();
    refused(&observe(b"t,x,f\n0,0,9\n1,1,9\n", &["--out", target]), &["observe.png"]);
    assert_eq!(fs::read_to_string(file).unwrap(), json);
    assert_eq!(names(&out).len(), 5);
}
