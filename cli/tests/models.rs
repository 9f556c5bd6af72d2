//! Tests of `lyapunov compare` of models.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::called::{holds_rows, lyapunov, prints, refuses, text};

const NAMES: [&str; 6] = [
    "van-der-pol",
    "inverted-pendulum",
    "dc-motor",
    "admittance-device",
    "two-link-arm",
    "prosthetic-leg",
];

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/models/{name}.toml"))
}

#[test]
fn the_tables_fit_the_terminal_and_have_a_row_for_each_entrant() {
    let mut arguments = vec!["compare".into()];
    arguments.extend(NAMES.map(|name| path(name).into_os_string()));
    let out = prints(arguments);
    for row in ["none  ", "popc  ", "lolc-decrease  ", "lolc-decay  "] {
        let rows = out.lines().filter(|line| line.starts_with(row)).count();
        assert_eq!(rows, NAMES.len(), "{row}:\n{out}");
    }
    // Only the path can make a line longer.
    let lines = out.lines().filter(|line| !line.contains(".toml"));
    assert!(lines.clone().all(|line| line.chars().count() <= 100), "{out}");
    assert!(out.contains("inverted-pendulum, 8 s at 1000 Hz, controller 120 ticks late"), "{out}");
    assert!(out.contains("two-link-arm, 6 s at 1000 Hz, controller at 50 Hz"), "{out}");
}

#[test]
fn the_written_files_agree_with_each_other() {
    let place = tempfile::tempdir().unwrap();
    let (out, pendulum) = (place.path().join("out"), path("inverted-pendulum"));
    let arguments: [&OsStr; 5] =
        ["compare".as_ref(), pendulum.as_ref(), "--json".as_ref(), "--out".as_ref(), out.as_ref()];
    let told = prints(arguments);
    let mut names: Vec<_> = fs::read_dir(&out)
        .unwrap()
        .map(|it| it.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let figure = ["csv", "png", "svg"].map(|ending| format!("inverted-pendulum.{ending}"));
    let rows = ["compare.csv", "compare.json"].map(str::to_owned);
    assert_eq!(names, [&rows[..], &figure[..], &["report.html".to_owned()]].concat());
    assert_eq!(fs::read_to_string(out.join("compare.json")).unwrap(), told);

    let json: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(
        (&json["bound"], &json["models"][0]["plant"]),
        (&4.0.into(), &"inverted-pendulum".into())
    );
    let csv = fs::read_to_string(out.join("inverted-pendulum.csv")).unwrap();
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let name = format!("{},", row["stabilizer"].as_str().unwrap());
        let values: Vec<f64> = csv
            .lines()
            .filter_map(|line| line.strip_prefix(&name)?.split_once(',')?.1.parse().ok())
            .collect();
        assert_eq!(values.len(), 8001, "{name}");
        assert_eq!(row["v_end"], values[8000]);
        assert_eq!(row["v_largest"], values.iter().copied().fold(0.0, f64::max));
        assert_eq!(json["models"][0]["v_start"], values[0]);
    }
    holds_rows(&fs::read_to_string(out.join("compare.csv")).unwrap(), rows);
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("lolc-decay") && !page.contains("NaN"));
    assert!(page.contains("<a href=\"compare.csv\">") && !page.contains("Left out"));
}

/// A file that does not fit is told with its reason in every form, as a scene is, and the rows have a file of their own name.
#[test]
fn a_batch_goes_on_after_a_model_that_does_not_fit() {
    let place = tempfile::tempdir().unwrap();
    let (out, wrong) = (place.path().join("out"), place.path().join("wrong.toml"));
    let text_of = fs::read_to_string(path("inverted-pendulum")).unwrap();
    fs::write(&wrong, text_of.replace("proportional = 6.0", "proportional = 1.0")).unwrap();
    let named = place.path().join("compare.toml");
    fs::copy(path("dc-motor"), &named).unwrap();
    let said = lyapunov([
        "compare".as_ref(),
        wrong.as_os_str(),
        named.as_os_str(),
        "--json".as_ref(),
        "--out".as_ref(),
        out.as_os_str(),
    ]);
    assert_eq!(said.status.code(), Some(2));
    assert!(text(&said.stderr).starts_with("error: 1 of 2 files left out\n"));
    let json: Value = serde_json::from_slice(&said.stdout).unwrap();
    let left_out = json["left_out"].as_array().unwrap();
    assert_eq!(left_out.len(), 1);
    assert!(left_out[0].as_str().unwrap().contains("m g l"), "{left_out:?}");
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("Left out") && page.contains("m g l"));
    holds_rows(
        &fs::read_to_string(out.join("compare.csv")).unwrap(),
        json["rows"].as_array().unwrap(),
    );
    let curves = fs::read_to_string(out.join("compare-2.csv")).unwrap();
    assert!(curves.starts_with("stabilizer,t,v\n"), "{curves}");
}

#[test]
fn files_and_options_that_do_not_go_together_are_refused() {
    let (model, scene) = (path("van-der-pol"), path("x").with_file_name("../hold.toml"));
    let compare: &OsStr = "compare".as_ref();
    refuses(
        &[compare, model.as_ref(), scene.as_ref()],
        &["a model of a plant", "in calls of their own"],
    );
    let by = ["--by".as_ref(), "verdict".as_ref()];
    refuses(&[compare, model.as_ref(), by[0], by[1]], &["--by", "leave it out"]);
    let named = ["--stabilizers".as_ref(), "lolc".as_ref()];
    refuses(&[compare, model.as_ref(), named[0], named[1]], &["of a model", "lolc-decrease"]);
    refuses::<&OsStr>(
        &["run".as_ref(), model.as_ref()],
        &["not a scene", "`lyapunov compare` takes it"],
    );
    refuses(&[compare, "absent.toml".as_ref()], &["there is no such file"]);
}

#[test]
fn entrants_take_part_by_name() {
    let model = path("dc-motor");
    let rows = |names: &str| {
        let said = lyapunov([
            "compare".as_ref(),
            model.as_os_str(),
            "--json".as_ref(),
            "--stabilizers".as_ref(),
            names.as_ref(),
        ]);
        let json: Value = serde_json::from_slice(&said.stdout).unwrap();
        json["rows"].as_array().unwrap().clone()
    };
    let all = rows("all");
    assert_eq!(all.len(), 4);
    assert_eq!(rows("lolc-decay,popc"), [all[3].clone(), all[1].clone()]);
}

#[test]
fn the_schema_of_models_is_printed() {
    let said = lyapunov(["schema", "model"]);
    assert_eq!(said.status.code(), Some(0));
    assert_eq!(text(&said.stdout), lyapunov_lab::models::schema_text());
}
