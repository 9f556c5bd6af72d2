//! Tests of `lyapunov compare` of scenes.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use approx::abs_diff_eq;
use lyapunov_lab::Scene;
use lyapunov_lab::compare::{Comparison, Entrants, Score};
use lyapunov_lab::family::{StabilizerName, StabilizerNames};
use serde_json::Value;

use crate::called::{lyapunov, refuses, text};

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)
}

fn called<'a>(arguments: &'a [&dyn AsRef<OsStr>]) -> Vec<&'a OsStr> {
    [OsStr::new("compare")].into_iter().chain(arguments.iter().map(|it| it.as_ref())).collect()
}

fn compare(arguments: &[&dyn AsRef<OsStr>]) -> Output {
    lyapunov(called(arguments))
}

#[track_caller]
fn refused(arguments: &[&dyn AsRef<OsStr>], reasons: &[&str]) {
    refuses(&called(arguments), reasons);
}

/// The rows of a document without its timings.
fn timeless(document: &str) -> Value {
    let mut document: Value = serde_json::from_str(document).unwrap();
    let keys = document["not_deterministic"].clone();
    for row in document["rows"].as_array_mut().unwrap() {
        for key in keys.as_array().unwrap() {
            let time = row.as_object_mut().unwrap().remove(key.as_str().unwrap()).unwrap();
            assert_eq!(time["deterministic"], Value::Bool(false));
            assert!(time["min"].as_f64() <= time["median"].as_f64());
            assert!(time["median"].as_f64() <= time["max"].as_f64());
        }
    }
    document
}

#[test]
fn a_scene_in_space_has_every_file_and_measure() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("results");
    let names = "none,popc,iss";
    let said =
        compare(&[&shipped("plane.toml"), &"--stabilizers", &names, &"--out", &out, &"--json"]);
    assert_eq!(said.status.code(), Some(0));
    let document = timeless(&text(&said.stdout));
    assert_eq!(document["scenes"][0]["stiffness_asked_n_per_m"], 3000.0);
    for row in document["rows"].as_array().unwrap() {
        assert!(row["stiffness_felt_percent"].as_f64().unwrap() > 90.0, "{row}");
        assert!(row["force_felt_percent"].as_f64().unwrap() > 90.0, "{row}");
        // A port around the environment has no share of ticks with damping to tell.
        assert_eq!(row["active_percent"].is_null(), row["stabilizer"] == "iss", "{row}");
    }
    assert!(out.join("plane.svg").is_file() && out.join("plane.energy.csv").is_file());
}

#[test]
fn tables_files_and_documents_agree() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("deep/results");
    let (one, other) = (shipped("paper-50k-popc.toml"), shipped("press-1khz.toml"));
    let output = compare(&[&one, &other, &"--out", &out]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    let table = text(&output.stdout);
    assert_eq!(table.matches("POPC and LOLC: held work, cap 0.5").count(), 1);
    let late = "POPC and LOLC: held work, cap 0.2071 (the defaults, with 1 tick of delay)";
    assert_eq!(table.matches(late).count(), 1);
    let narrow = |line: &str| line.chars().count() <= 100 || line.contains(".toml");
    assert!(table.lines().all(narrow), "{table}");
    assert!(table.contains("(as the scene says)"));

    let mut names: Vec<String> = fs::read_dir(&out)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let mut expected = ["compare.csv", "compare.json", "report.html"].map(str::to_owned).to_vec();
    for scene in ["paper-50k-popc", "press-1khz"] {
        for end in [".svg", ".png", ".force.svg", ".force.png"] {
            expected.push(format!("{scene}{end}"));
        }
        for question in ["energy", "trade-off"] {
            expected.extend(["svg", "png", "csv"].map(|kind| format!("{scene}.{question}.{kind}")));
        }
    }
    expected.sort();
    assert_eq!(names, expected);

    let written = fs::read_to_string(out.join("compare.json")).unwrap();
    let printed = text(&compare(&[&one, &other, &"--json"]).stdout);
    assert_eq!(timeless(&written), timeless(&printed));

    let rows = timeless(&written)["rows"].clone();
    assert_eq!(rows.as_array().unwrap().len(), 10);
    let value = |row: usize, key: &str| rows[row][key].clone();
    assert_eq!(value(0, "verdict"), "grows");
    assert_eq!(value(1, "settling_time_s"), 1.36);
    assert_eq!(value(4, "settling_time_s"), 2.35);
    assert!(value(0, "stiffness_felt_n_per_m").is_null());
    assert!((90.0..100.0).contains(&value(6, "stiffness_felt_percent").as_f64().unwrap()));
}

/// Cells of a table, line by line, without its head.
fn cells(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    let cells = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().skip(1).map(cells).collect()
}

/// The energies that came in equal those that went out, and the controller's share is that of the table.
#[test]
fn energies_by_cause_add_up() {
    let folder = tempfile::tempdir().unwrap();
    let output = compare(&[&shipped("press-1khz.toml"), &"--json", &"--out", &folder.path()]);
    let rows = timeless(&text(&output.stdout))["rows"].clone();
    let parts = cells(&folder.path().join("press-1khz.energy.csv"));
    // Without a stabilizer the run grows, and has no energies.
    assert!(parts.iter().all(|part| part[0] != "none"));
    for row in &rows.as_array().unwrap()[1..] {
        let name = row["stabilizer"].as_str().unwrap();
        let given = |part: &Vec<String>| part[2].parse::<f64>().unwrap();
        let own: Vec<_> = parts.iter().filter(|part| part[0] == name).collect();
        assert_eq!(own.len(), 14, "{name}");
        let came: f64 = own.iter().map(|part| given(part).max(0.0)).sum();
        let left: f64 = own.iter().map(|part| given(part)).sum();
        assert!(left.abs() < 1e-9 * came && came > 1e-3, "{name}: {left} of {came} J");
        let controller = own.iter().find(|part| part[1] == "controller").unwrap();
        let taken = 1e-3 * row["energy_taken_mj"].as_f64().unwrap();
        assert!(abs_diff_eq!(given(controller), -taken, epsilon = 1e-9 * taken), "{name}");
    }
}

/// Each wall of the figure agrees with a comparison of that wall alone.
#[test]
fn the_trade_off_agrees_with_144_comparisons() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("short.toml");
    let scene = |stiffness: f64, damping: f64| {
        format!(
            "duration = 0.6\nservo_rate = 1000.0\nenvironment_rate = 200.0\ndevice.mass = 0.2\n\
             operator = {{ mass = 0.1, stiffness = 200.0, damping = 1.0, rest = 0.01 }}\n\
             environment.wall = {{ stiffness = {stiffness:?}, damping = {damping:?} }}\n"
        )
    };
    fs::write(&path, scene(2000.0, 1.0)).unwrap();
    let names = "none,popc,lolc-mass-spring-damper";
    compare(&[&path, &"--stabilizers", &names, &"--quiet", &"--out", &folder.path()]);
    let told = cells(&folder.path().join("short.trade-off.csv"));

    let mut errors: Vec<Vec<Option<f64>>> = Vec::new();
    for (row, column) in (0..12).flat_map(|row| (0..12).map(move |column| (row, column))) {
        let stiffness = 2000.0 * 16f64.powf(f64::from(column) / 5.5 - 1.0);
        let text = scene(stiffness, 0.3 * 200.0 * f64::from(row) / 11.0);
        let wall = Scene::parse(&text, "wall").unwrap();
        let members: StabilizerNames = names.parse().unwrap();
        let entrants = Entrants::<f64>::of(members);
        let comparison = Comparison::of("wall", &wall, &entrants).unwrap();
        let error = |score: &Score| score.verdict.is_bounded().then(|| score.force_error.unwrap());
        errors.push(comparison.scores().map(error).collect());
    }
    let bounded = |index: usize| errors.iter().filter(|wall| wall[index].is_some()).count();
    // Walls that are bounded under both stabilizers and grow without one.
    let is_common = |it: &&Vec<Option<f64>>| it[0].is_none() && it[1].is_some() && it[2].is_some();
    let common: Vec<_> = errors.iter().filter(is_common).collect();
    assert!(bounded(0) < bounded(2) && bounded(2) < bounded(1) && common.len() > 4);
    for (index, line) in told.iter().enumerate() {
        let counts = [bounded(index), 144, common.len()].map(|count| count.to_string());
        assert_eq!(line[1..4], counts, "{line:?}");
        if index == 0 {
            assert_eq!(line[4], "");
            continue;
        }
        let mut own: Vec<f64> = common.iter().map(|wall| wall[index].unwrap()).collect();
        own.sort_by(f64::total_cmp);
        let (middle, told) = (own[(own.len() - 1) / 2], line[4].parse::<f64>().unwrap());
        assert!(abs_diff_eq!(told, middle, epsilon = 1e-9 * middle), "{told} {middle}");
    }
}

#[test]
fn scenes_of_one_name_get_a_figure_each() {
    let folder = tempfile::tempdir().unwrap();
    let scene = shipped("paper-8k-popc.toml");
    let output = compare(&[&scene, &scene, &"--quiet", &"--out", &folder.path()]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0));
    assert!(folder.path().join("paper-8k-popc-2.png").is_file());
}

#[test]
fn by_sorts_and_bad_columns_are_named() {
    let scene = shipped("paper-50k-none.toml");
    let output = compare(&[&scene, &"--json", &"--by", &"settling_time_s"]);
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    let last = &document["rows"][4];
    assert_eq!((&last["stabilizer"], &last["settling_time_s"]), (&"none".into(), &Value::Null));
    refused(&[&scene, &"--by", &"setling_time"], &["setling_time", "`settling_time_s`"]);
    refused(&[&scene, &"--by", &"zzz"], &["zzz", "chatter_rms_n"]);
}

#[test]
fn bad_input_is_refused_and_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, out) = (shipped("paper-8k-popc.toml"), folder.path().join("out"));
    refused(&[], &["SCENE"]);
    // Of one file nothing is left out.
    refused(&[&"no-such.toml", &"--out", &out], &["error: no-such.toml: there is no such file"]);
    refused(
        &[&"no-such.toml", &"nor-this.toml", &"--out", &out],
        &["2 of 2 files left out", "nor-this"],
    );
    refused(&[&scene, &"--json", &"--quiet"], &["--json", "--quiet"]);
    assert!(!out.exists());

    let bad = folder.path().join("bad.toml");
    fs::write(&bad, "duration = -1\n").unwrap();
    refused(&[&bad, &"--out", &out], &["bad.toml", "duration", "-1"]);
    // An f32 cannot hold this number, which shows only when the loop is built.
    let text = "duration = 1.0\nservo_rate = 1000.0\nscalar = \"f32\"\ndevice.mass = 1e38\n\
        operator.mass = 1e38\nenvironment.wall.stiffness = 1.0\n";
    fs::write(&bad, text.replace("1e38", "3e38")).unwrap();
    refused(&[&bad, &"--out", &out], &["bad.toml"]);
    assert!(!out.exists());

    let file = folder.path().join("file");
    fs::write(&file, "mine").unwrap();
    refused(&[&scene, &"--out", &file], &["file", "name a folder"]);
    refused(&[&scene, &"--out", &file.join("deeper")], &["cannot be written"]);
    fs::create_dir_all(out.join("compare.json")).unwrap();
    refused(&[&scene, &"--out", &out], &["compare.json", "not of a folder"]);
    fs::create_dir(folder.path().join("taken")).unwrap();
    fs::create_dir(folder.path().join("taken/paper-8k-popc.png")).unwrap();
    refused(&[&scene, &"--out", &folder.path().join("taken")], &["paper-8k-popc.png"]);
    // If one file cannot be written, none appears.
    assert_eq!(fs::read_dir(folder.path().join("taken")).unwrap().count(), 1);
}

/// A scene that does not fit does not end the work on the others, and the end says so.
#[test]
fn a_batch_goes_on_after_a_scene_that_does_not_fit() {
    let folder = tempfile::tempdir().unwrap();
    let (out, names) = (folder.path().join("out"), "none,popc");
    let plane = folder.path().join("plane.toml");
    let space = fs::read_to_string(shipped("plane.toml")).unwrap();
    fs::write(&plane, space.replace("dimensions = 2", "dimensions = 3")).unwrap();
    let (one, two) = (shipped("paper-8k-popc.toml"), shipped("paper-50k-popc.toml"));
    let all: [&dyn AsRef<std::ffi::OsStr>; 9] =
        [&one, &plane, &"none.toml", &two, &"--stabilizers", &names, &"--out", &out, &"--json"];
    let batch = compare(&all);
    let said = text(&batch.stderr);
    assert_eq!(batch.status.code(), Some(2));
    assert!(said.starts_with("error: 2 of 4 files left out\n"), "{said}");
    assert!(said.contains("3 dimensions") && said.contains("none.toml"), "{said}");
    let alone = compare(&[&one, &two, &"--stabilizers", &names, &"--json"]);
    assert_eq!(alone.status.code(), Some(0));
    let mut told = timeless(&text(&batch.stdout));
    let left_out = told.as_object_mut().unwrap().remove("left_out").unwrap();
    let reasons: Vec<&str> =
        left_out.as_array().unwrap().iter().map(|reason| reason.as_str().unwrap()).collect();
    assert!(reasons[0].contains("3 dimensions") && reasons[1].contains("none.toml"), "{reasons:?}");
    assert_eq!(told, timeless(&text(&alone.stdout)));
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("Left out") && page.contains("3 dimensions"));
    assert!(out.join("paper-50k-popc.svg").is_file() && !out.join("plane.svg").exists());
}

#[test]
fn every_effect_and_scalar_runs() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("all.toml");
    let scene = fs::read_to_string(shipped("press-1khz.toml")).unwrap();
    fs::write(&path, format!("scalar = \"f32\"\n{scene}\n[effects.saturation]\nforce = 5.0\n"))
        .unwrap();
    let out = folder.path().join("limited");
    let document = timeless(&text(&compare(&[&path, &"--json", &"--out", &out]).stdout));
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    let told =
        ["a saturation may bound a run", "<h3>Scene</h3>", "[effects.saturation]", "force = 5.0"];
    assert!(told.iter().all(|it| page.contains(it)), "{page}");
    assert_eq!(document, timeless(&text(&compare(&[&path, &"--json"]).stdout)));
    let peak = document["rows"][1]["peak_force_short_contact_n"].as_f64().unwrap();
    assert_eq!(peak, 5.0);
    assert_eq!(document["rows"][1]["state_bytes"], 8);

    // One tick, and no spring at all.
    let tiny =
        "duration = 1e-3\nservo_rate = 10.0\ndevice.mass = 0.1\nenvironment.wall.stiffness = 0.0\n";
    fs::write(&path, tiny).unwrap();
    let output = compare(&[&path, &"--out", &folder.path()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
}

#[cfg(unix)]
#[test]
fn a_reader_that_leaves_is_no_error() {
    let scene = shipped("paper-8k-popc.toml");
    let line = format!("{} compare {} | true", env!("CARGO_BIN_EXE_lyapunov"), scene.display());
    let output = Command::new("bash").args(["-o", "pipefail", "-c", &line]).output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
}

#[test]
fn the_family_takes_part_by_name() {
    let scene = shipped("press-1khz.toml");
    let all = compare(&[&scene, &"--stabilizers", &"all"]);
    let (table, said) = (text(&all.stdout), text(&all.stderr));
    assert_eq!((all.status.code(), said.as_str()), (Some(0), ""));
    let narrow = |line: &str| line.chars().count() <= 100 || line.contains(".toml");
    assert!(table.lines().all(narrow), "{table}");
    let equal = "popc = lolc-spring = popc-budgeted = popc-windowed = directed-damping";
    let told = table.lines().skip_while(|line| !line.contains("popc ("));
    let told: Vec<&str> = told.take_while(|line| !line.is_empty()).map(str::trim).collect();
    let told = told.join(" ");
    // Behind each name stands the time of its step.
    let is_time = |word: &&str| {
        let inner = word.strip_prefix('(').and_then(|word| word.strip_suffix(')'));
        inner.is_some_and(|inner| inner.parse::<f64>().is_ok())
    };
    let (times, names): (Vec<&str>, Vec<&str>) = told.split(' ').partition(is_time);
    assert!(times.len() >= equal.split(" = ").count(), "{table}");
    assert!(names.join(" ").contains(equal), "{table}");
    let others: Vec<&str> =
        told.split(" = ").skip(1).filter_map(|it| it.split(' ').next()).collect();
    for member in StabilizerName::ALL {
        // Equal rows stand under the first of their names.
        let is_first = !others.contains(&member.name());
        let rows = table.lines().filter(|line| line.split(' ').next() == Some(member.name()));
        assert_eq!(rows.count(), if is_first { 3 } else { 0 }, "{member}: {table}");
    }
    let json = timeless(&text(&compare(&[&scene, &"--stabilizers", &"all", &"--json"]).stdout));
    assert_eq!(json["rows"].as_array().unwrap().len(), StabilizerName::ALL.len());

    let rows = |names: &str| {
        let output = compare(&[&scene, &"--stabilizers", &names, &"--json"]);
        timeless(&text(&output.stdout))["rows"].as_array().unwrap().clone()
    };
    let some = rows("tank,popc,popc-threshold");
    let names: Vec<&str> = some.iter().map(|row| row["stabilizer"].as_str().unwrap()).collect();
    assert_eq!(names, ["tank", "popc", "popc-threshold"]);
    // The other entrants change nothing, and a tank adds no damping.
    assert_eq!(some[1], rows("popc,lolc")[0]);
    assert_eq!(some[0]["active_percent"], Value::Null);

    refused(&[&scene, &"--stabilizers", &"tnk"], &["`tnk`", "did you mean `tank`?", "popc-rising"]);
    refused(&[&scene, &"--stabilizers", &"popc,popc"], &["`popc` is named twice"]);
    refused(&[&scene, &"--stabilizers", &"none,all"], &["`all` stands by itself"]);
}

#[test]
fn every_key_is_on_its_page_and_broken_loops_are_counted() {
    let (one, other) = (shipped("paper-50k-popc.toml"), shipped("press-1khz.toml"));
    let output = compare(&[&one, &other, &"--json"]);
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    let page = include_str!("../../docs/compare.md");
    let objects = [&document, &document["rows"][0], &document["scenes"][0], &document["broken"][0]];
    for key in objects.iter().flat_map(|it| it.as_object().unwrap().keys()) {
        assert!(page.contains(&format!("`{key}`")), "docs/compare.md lacks `{key}`");
    }
    // Both scenes grow alone.
    let counts = document["broken"].as_array().unwrap();
    assert_eq!(counts.len(), 5);
    assert!(counts.iter().all(|row| row["bounded_alone"] == 0 && row["broke"] == 0));
    assert!(text(&compare(&[&one, &other]).stdout).contains("all scenes"));
    assert!(!text(&compare(&[&one]).stdout).contains("all scenes"));
}
