//! Tests of `lyapunov accuracy`.

use serde_json::Value;

use crate::cli::place::Place;

#[test]
fn a_target_is_met_by_keys_that_a_scene_takes() {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 0.5");
    let said = place.run(["accuracy", "scene.toml", "--out", "out", "--target", "1e-6", "--json"]);
    said.ended(0, &[]);
    assert_eq!(said.out, place.text("out/accuracy.json"));
    assert_eq!(
        place.names("out"),
        ["accuracy.csv", "accuracy.json", "accuracy.png", "accuracy.svg", "report.html"]
    );
    let told: Value = serde_json::from_str(&said.out).unwrap();
    let rows = told["rows"].as_array().unwrap();
    let keys = ["propagator", "steps_per_tick", "tolerance", "scalar", "max_error"];
    for row in rows {
        assert!(keys.iter().all(|key| row.get(key).is_some()), "{row}");
        assert!(row["ns_per_simulated_second"].as_f64().unwrap() > 0.0, "{row}");
    }
    let find = |name: &str, scalar: &str| {
        rows.iter().find(|row| row["propagator"] == name && row["scalar"] == scalar).unwrap()
    };
    assert!(find("exact", "f64")["max_error"].as_f64().unwrap() < 1e-12);
    assert_eq!(find("exact", "f64")["steps_per_tick"], Value::Null);
    assert_eq!(find("rk4", "f32+f64")["tolerance"], Value::Null);
    assert_eq!(find("dopri5", "f64")["steps_per_tick"], Value::Null);
    assert_eq!(told["ledger"].as_array().unwrap().len(), 6);
    let cheapest = &told["target"]["cheapest"];
    assert!(cheapest["max_error"].as_f64().unwrap() <= 1e-6, "{cheapest}");
    let page = place.text("out/report.html");
    assert!(page.contains("<svg") && page.contains("integrator = &quot;"), "{page}");
}

#[test]
fn an_unreachable_target_gets_the_nearest_setting() {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 0.1");
    let said = place.run(["accuracy", "scene.toml", "--target", "1e-300"]);
    said.ended(0, &[]);
    assert!(said.out.contains("no setting is within 1e-300 m; the nearest is "), "{}", said.out);
    let keys = said.out.split_once("off by").unwrap().1;
    assert!(keys.contains("integrator = \"") && keys.contains("[stabilizer.lolc]"), "{keys}");
}

#[test]
fn bad_input_is_refused_before_anything_is_made() {
    let place = Place::with_scene();
    for metres in ["0", "-1", "nan", "inf", "far"] {
        let target = format!("--target={metres}");
        let said = place.refuses(["accuracy", "scene.toml", &target], &[metres, "greater than 0"]);
        assert!(said.err.contains("--target 1e-9") && !said.err.contains("--help"), "{said:?}");
    }
    place.refuses(["accuracy", "nothing.toml", "--out", "out"], &["nothing.toml"]);
    place.put("plane.toml", include_str!("../../../scenes/plane.toml"));
    place.refuses(["accuracy", "plane.toml", "--out", "out"], &["[space]", "one dimension"]);
    place.refuses(["accuracy", "scene.toml", "--json", "--quiet"], &["--quiet"]);
}
