//! Tests of `run --json` and `run --quiet`.

use approx::abs_diff_eq;
use serde_json::Value;

use crate::cli::place::{Place, SCENE};

const STIFF: &str = include_str!("../../../scenes/paper-50k-none.toml");

/// The rows as columns.
fn columns(csv: &str) -> Vec<Vec<f64>> {
    let rows: Vec<Vec<f64>> = csv
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    (0..rows[0].len()).map(|column| rows.iter().map(|row| row[column]).collect()).collect()
}

#[track_caller]
fn near(json: &Value, expected: f64) {
    let found = json.as_f64().unwrap();
    assert!(
        abs_diff_eq!(found, expected, epsilon = 1e-9 * expected.abs()),
        "{found} against {expected}"
    );
}

fn most(numbers: &[f64], of: fn(f64) -> f64) -> f64 {
    numbers.iter().map(|number| of(*number)).fold(f64::NEG_INFINITY, f64::max)
}

/// Every number against the rows of the same run.
#[test]
fn the_json_agrees_with_the_rows() {
    let place = Place::with_scene();
    let said = place.run(["run", "scene.toml", "--json", "--csv", "rows.csv"]);
    said.ended(0, &[]);
    assert_eq!(said.err, "");
    assert_eq!(place.run(["run", "scene.toml", "--json"]).out, said.out);
    let json: Value = serde_json::from_str(&said.out).unwrap();
    let columns = columns(&place.text("rows.csv"));
    let column = |index: usize| columns[index].as_slice();
    let (x, v, observer, alpha) = (column(1), column(3), column(8), column(9));
    let (f_ctl, f_act) = (column(5), column(7));
    assert_eq!(json["scene"], "scene.toml");
    assert_eq!(json["rows"], x.len());
    assert_eq!(json["complete"], true);
    assert_eq!((&json["verdict"], &json["verdict_by"]), (&"swinging".into(), &"distance".into()));
    // The operator's spring rests at the wall, 4 mm from the start: what settles stays within 5 % of that from 9 s on.
    let last_outside = x.iter().rposition(|x| x.abs() > 0.0002).unwrap();
    assert!(column(0)[last_outside] > 9.0 && json["settling_time_s"].is_null());
    assert_eq!(json["equilibrium_mm"], 0.0);
    near(&json["band_mm"], 0.2);
    near(&json["peak_force_environment_n"], most(column(4), f64::abs));
    near(&json["peak_force_acting_n"], most(f_act, f64::abs));
    let work: f64 = (1..x.len()).map(|n| f_act[n - 1] * (x[n] - x[n - 1])).sum();
    near(&json["energy_into_port_mj"], 1e3 * work);
    let stabilizer = &json["stabilizer"];
    near(&stabilizer["observed_energy_least_mj"], -1e3 * most(observer, |sum| -sum));
    near(&stabilizer["observed_energy_most_mj"], 1e3 * most(observer, |sum| sum));
    near(&stabilizer["observed_energy_end_mj"], 1e3 * observer.last().unwrap());
    let active = alpha.iter().filter(|alpha| **alpha > 0.0).count();
    near(&stabilizer["active_percent"], 100.0 * active as f64 / x.len() as f64);
    let asked: f64 = f_ctl.iter().zip(v).map(|(force, v)| force * v * 0.01).sum();
    near(&stabilizer["energy_asked_for_mj"], 1e3 * asked);
    near(&stabilizer["shortfall_mj"], 1e3 * most(column(10), |short| short));
    assert_eq!(stabilizer.as_object().unwrap().len(), 6);
    assert_eq!(json["look_at"], Value::Array(Vec::new()));
    assert_eq!(json.as_object().unwrap().len(), 14);
}

/// The rows of such a law have an `alpha` of 0 throughout, which says nothing about what it does.
#[test]
fn a_law_without_an_alpha_has_no_share_of_active_ticks() {
    let place = Place::new();
    for (table, words) in [
        ("tank", "controller cuts the force and adds no damping, shortfall up to"),
        ("iss", "controller damps as a port around the environment and not by an alpha, shortfall"),
    ] {
        place.put("scene.toml", format!("{STIFF}\n[stabilizer.{table}]\n"));
        let said = place.run(["run", "scene.toml", "--csv", "rows.csv"]);
        said.ended(0, &[words]);
        assert!(!said.out.contains("active on"), "{}", said.out);
        assert_eq!(most(&columns(&place.text("rows.csv"))[9], f64::abs), 0.0);
        let json = |arguments: &[&str]| -> Value {
            serde_json::from_str(&place.run(arguments).out).unwrap()
        };
        let run = json(&["run", "scene.toml", "--json"]);
        assert!(run["stabilizer"]["active_percent"].is_null(), "{run}");
        assert!(run["stabilizer"]["energy_asked_for_mj"].is_null(), "{run}");
        assert!(run["stabilizer"]["shortfall_mj"].is_number(), "{run}");
        let compared = json(&["compare", "scene.toml", "--stabilizers", table, "--json"]);
        assert!(compared["rows"][0]["active_percent"].is_null(), "{compared}");
    }
}

#[test]
fn settling_is_reported_as_in_words() {
    let place = Place::new();
    let popc = SCENE.replace("stiffness = 8000.0\ndamping = 2.0", "stiffness = 5e4\ndamping = 20");
    // A run that comes to rest in its last tenth counts as swinging; the time is told in words only.
    for (duration, verdict) in [("10.0", "settles"), ("2.4", "swinging")] {
        let scene = popc.replace("duration = 10.0", &format!("duration = {duration}"));
        place.put("scene.toml", scene);
        let json: Value =
            serde_json::from_str(&place.run(["run", "scene.toml", "--json"]).out).unwrap();
        assert_eq!(json["verdict"], verdict);
        let time = if verdict == "settles" { Value::from(2.35) } else { Value::Null };
        assert_eq!(json["settling_time_s"], time);
        let words = format!("verdict {verdict}");
        place.run(["run", "scene.toml"]).ended(0, &[&words, "t = 2.35 s"]);
    }
}

/// A number is null where it does not exist or is out of range, and only there.
#[test]
fn numbers_are_finite_or_null() {
    let place = Place::new();
    let json = |scene: &str| -> Value {
        place.put("scene.toml", scene);
        let said = place.run(["run", "scene.toml", "--json"]);
        said.ended(0, &[]);
        serde_json::from_str(&said.out).unwrap()
    };
    let bare = json(STIFF);
    assert!(bare["stabilizer"].is_null() && bare["settling_time_s"].is_null());
    assert_eq!(bare["complete"], true);
    let away = json(&STIFF.replace("duration = 10.0", "duration = 150.0"));
    assert_eq!(away["complete"], false);
    assert!(away["rows"].as_u64().unwrap() < 15_001);
    assert!(away["energy_into_port_mj"].is_null());
    assert!(away["settling_time_s"].is_null());
    assert!(away["peak_force_environment_n"].as_f64().unwrap() > 1e100);
    let free = json(&STIFF.replace("stiffness = 50.0", "stiffness = 0.0"));
    assert!(free["equilibrium_mm"].is_null() && free["band_mm"].is_null());
    assert_eq!(free["verdict_by"], "speed");
    let none = json(&STIFF.replace("position = -0.004", "position = 1e308"));
    assert_eq!(none["rows"], 0);
}

/// Rows and JSON go to separate streams, as rows and words do.
#[test]
fn rows_on_standard_output_send_the_json_to_standard_error() {
    let place = Place::with_scene();
    let said = place.run(["run", "scene.toml", "--json", "--csv", "-"]);
    said.ended(0, &[]);
    assert_eq!(said.err, place.run(["run", "scene.toml", "--json"]).out);
    assert_eq!(said.out, place.run(["run", "scene.toml", "--csv", "-"]).out);
}

#[test]
fn quiet_says_nothing_but_errors() {
    let place = Place::with_scene();
    let rows = place.run(["run", "scene.toml", "--csv", "-"]).out;
    let said = place.run(["run", "scene.toml", "--quiet"]);
    said.ended(0, &[]);
    assert_eq!((said.out.as_str(), said.err.as_str()), ("", ""));
    let said = place.run(["run", "scene.toml", "--quiet", "--csv", "-"]);
    assert_eq!((&said.out, said.err.as_str()), (&rows, ""));
    let said = place.run(["run", "scene.toml", "--quiet", "--csv", "rows.csv"]);
    assert_eq!((said.out.as_str(), said.err.as_str()), ("", ""));
    assert_eq!(place.text("rows.csv"), rows);
    place.run(["run", "missing.toml", "--quiet"]).ended(2, &["error: missing.toml"]);
    for command in [&["run", "scene.toml"][..], &["paper"], &["compare", "scene.toml"]] {
        let both = [command, &["--json", "--quiet"]].concat();
        place.run(both).ended(2, &["'--json' cannot be used with '--quiet'"]);
    }
}
