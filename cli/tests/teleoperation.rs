//! Tests of `lyapunov compare` of teleoperators.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::called::{holds_rows, lyapunov, prints, refuses, text};

const NAMES: [&str; 3] = ["constant-delay", "varying-delay", "lossy"];

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/teleoperation/{name}.toml"))
}

const ROWS: [&str; 8] = [
    "none",
    "popc-at-each-end",
    "two-port-popc",
    "drift-compensated",
    "two-layer",
    "wave-variables",
    "wave-variables-matched",
    "wave-variables-filtered",
];

#[test]
fn the_tables_fit_the_terminal_and_have_a_row_for_each_entrant() {
    let mut arguments = vec!["compare".into()];
    arguments.extend(NAMES.map(|name| path(name).into_os_string()));
    let out = prints(arguments);
    for row in ROWS {
        let rows = out.lines().filter(|line| line.starts_with(&format!("{row}  ")));
        assert_eq!(rows.count(), 9, "{row}:\n{out}");
    }
    let lines = out.lines().filter(|line| !line.contains(".toml"));
    assert!(lines.clone().all(|line| line.chars().count() <= 100), "{out}");
    for setting in ["20 ticks each way", "10 to 50 ticks each way", "20 ticks each way, 30 % lost"]
    {
        assert!(out.contains(setting), "{out}");
    }
}

#[test]
fn the_written_files_agree_with_each_other() {
    let place = tempfile::tempdir().unwrap();
    let (out, file) = (place.path().join("out"), path("lossy"));
    let arguments: [&OsStr; 5] =
        ["compare".as_ref(), file.as_ref(), "--json".as_ref(), "--out".as_ref(), out.as_ref()];
    let told = prints(arguments);
    let entries = fs::read_dir(&out).unwrap().map(|it| it.unwrap().file_name());
    let mut names: Vec<_> = entries.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    let figure = ["lossy.csv", "lossy.png", "lossy.svg"];
    assert_eq!(names, [&["compare.csv", "compare.json"], &figure[..], &["report.html"]].concat());
    assert_eq!(fs::read_to_string(out.join("compare.json")).unwrap(), told);

    let json: Value = serde_json::from_str(&told).unwrap();
    let circumstances = &json["teleoperators"][0];
    assert_eq!((&json["bound"], &circumstances["loss"]), (&4.0.into(), &0.3.into()));
    assert_eq!((&circumstances["seed"], &circumstances["delay_ticks"]), (&1.into(), &20.into()));
    let csv = fs::read_to_string(out.join("lossy.csv")).unwrap();
    assert!(csv.starts_with("stabilizer,device,t,x\n"));
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(rows.iter().map(|row| &row["stabilizer"]).collect::<Vec<_>>(), ROWS);
    for (row, name) in rows.iter().zip(ROWS) {
        let positions = |device: &str| -> Vec<f64> {
            let begins = format!("{name},{device},");
            let lines = csv.lines().filter_map(|line| line.strip_prefix(&begins));
            lines.map(|line| line.split_once(',').unwrap().1.parse().unwrap()).collect()
        };
        let (master, slave) = (positions("master"), positions("slave"));
        assert_eq!((master.len(), slave.len()), (5001, 5001), "{name}");
        assert_eq!(row["error_end_mm"], 1e3 * (master[5000] - slave[5000]));
        let apart = master.iter().zip(&slave).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert_eq!(row["error_largest_mm"], 1e3 * apart);
    }
    holds_rows(&fs::read_to_string(out.join("compare.csv")).unwrap(), rows);
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("wave-variables") && !page.contains("NaN"));
    assert!(page.contains("<a href=\"compare.csv\">"));
}

#[test]
fn files_and_options_that_do_not_go_together_are_refused() {
    let (file, model) = (path("lossy"), path("x").with_file_name("../models/van-der-pol.toml"));
    let compare: &OsStr = "compare".as_ref();
    let mixed = ["a model of a plant", "a teleoperator", "in calls of their own"];
    refuses(&[compare, file.as_ref(), model.as_ref()], &mixed);
    let by = ["--by".as_ref(), "verdict".as_ref()];
    refuses(&[compare, file.as_ref(), by[0], by[1]], &["of a teleoperator", "leave it out"]);
    refuses::<&OsStr>(
        &["run".as_ref(), file.as_ref()],
        &["not a scene", "`lyapunov compare` takes it"],
    );
}

#[test]
fn entrants_take_part_by_name() {
    let files = NAMES.map(path);
    let rows = |names: &[&str]| -> Vec<Value> {
        let mut arguments: Vec<&OsStr> = vec!["compare".as_ref(), "--json".as_ref()];
        arguments.extend(names.iter().map(|name| -> &OsStr { name.as_ref() }));
        arguments.extend(files.iter().map(|file| file.as_os_str()));
        let out = prints(arguments);
        let json: Value = serde_json::from_str(&out).unwrap();
        json["rows"].as_array().unwrap().clone()
    };
    let (all, usual) = (rows(&["--stabilizers", "all"]), rows(&[]));
    assert_eq!(all, usual);
    assert_eq!(all.len(), NAMES.len() * ROWS.len());
    // The order is the one given, and the other entrants change nothing.
    let some = rows(&["--stabilizers", "wave-variables-matched,none,two-layer"]);
    for (place, some) in some.chunks(3).enumerate() {
        let of = &all[place * ROWS.len()..];
        assert_eq!(some, [&of[6], &of[0], &of[4]].map(Clone::clone));
    }

    let refused = |names: &str, words: &[&str]| {
        let said = lyapunov(["compare", "--stabilizers", names, files[0].to_str().unwrap()]);
        assert_eq!((said.status.code(), said.stdout.len()), (Some(2), 0));
        let err = text(&said.stderr);
        assert!(words.iter().all(|word| err.contains(word)), "{err}");
    };
    refused("two-layers", &["--stabilizers", "`two-layers`", "did you mean `two-layer`?"]);
    refused("popc", &["no stabilizer of a teleoperator is called `popc`", "popc-at-each-end"]);
    refused("none,none", &["`none` is named twice"]);
    refused("none,all", &["`all` stands by itself"]);
    refused("", &["is called ``", "the names are:"]);
}

/// Without damping the waves have no impedance, and what sends no waves does not ask for one.
#[test]
fn an_impedance_is_asked_for_by_waves_only() {
    let place = tempfile::tempdir().unwrap();
    let undamped = place.path().join("undamped.toml");
    let file = fs::read_to_string(path("constant-delay")).unwrap();
    let (file, _) = file.split_once("\n[stabilizer]").unwrap();
    fs::write(&undamped, file.replace("stiffness = 200.0\ndamping = 2.0", "stiffness = 200.0"))
        .unwrap();
    let (compare, named): (&OsStr, &OsStr) = ("compare".as_ref(), "--stabilizers".as_ref());
    let words = ["| [coordination]", "`impedance = 5.0`", "leave the wave variables out"];
    refuses(&[compare, undamped.as_ref()], &words);
    refuses(&[compare, undamped.as_ref(), named, "none,wave-variables-matched".as_ref()], &words);
    let without = "none,popc-at-each-end,two-port-popc,drift-compensated,two-layer";
    let out = prints([compare, undamped.as_ref(), named, without.as_ref(), "--json".as_ref()]);
    let json: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(json["rows"].as_array().unwrap().len(), 5);
}

#[test]
fn a_run_that_leaves_the_range_has_no_numbers_of_its_end() {
    let place = tempfile::tempdir().unwrap();
    let long = place.path().join("long.toml");
    let file = fs::read_to_string(path("constant-delay")).unwrap();
    fs::write(&long, file.replace("duration = 5.0", "duration = 400.0")).unwrap();
    let said = lyapunov(["compare".as_ref(), long.as_os_str(), "--json".as_ref()]);
    let json: Value = serde_json::from_slice(&said.stdout).unwrap();
    let none = &json["rows"][0];
    assert_eq!((&none["verdict"], &none["error_end_mm"]), (&"grows".into(), &Value::Null));
    // What is of the ticks until then stays.
    for key in ["first_touch_s", "active_master_percent", "active_slave_percent"] {
        assert!(none[key].is_number(), "{key}");
    }
    assert!(json["rows"][2]["error_end_mm"].is_number());
    assert_eq!(json["rows"][4]["energy_least_mj"], Value::Null);
}

#[test]
fn the_schema_of_teleoperators_is_printed() {
    let said = lyapunov(["schema", "teleoperation"]);
    assert_eq!(said.status.code(), Some(0));
    assert_eq!(text(&said.stdout), lyapunov_lab::teleoperation::schema_text());
}
