//! The one rule of `--out`: a page, the JSON, the rows and the figures, whatever the command.

use std::fs;

use crate::cli::place::Place;

/// A scene of half a second that is quick for every command.
fn place() -> Place {
    let place = Place::new();
    let scene = "duration = 1.5\nservo_rate = 1000.0\nenvironment_rate = 200.0\ndevice.mass = 0.2\n\
                 operator = { mass = 0.1, stiffness = 200.0, damping = 1.0, rest = 0.01 }\n\
                 environment.wall = { stiffness = 2000.0, damping = 1.0 }\neffects.delay.ticks = 1\n";
    place.put("scene.toml", scene);
    place.put("log.csv", include_str!("../../../scenes/logs/mujoco-wall.csv"));
    place
}

/// The page is one file: nothing in it is loaded from elsewhere.
fn is_offline(page: &str) {
    for far in ["src=", "<link", "@import", "url(", "href=\"http", "href=\"//", "fetch("] {
        assert!(!page.contains(far), "{far}");
    }
    // The name of a namespace is no address that anything loads.
    let page = page.replace("http://www.w3.org/", "");
    assert!(!page.contains("src=\"http") && page.contains("<svg"));
}

#[test]
fn every_command_that_computes_writes_page_json_rows_and_figures() {
    let place = place();
    let cases: [(&[&str], &str, &[&str]); 8] = [
        (&["run", "scene.toml"], "run", &["run.svg", "run.png"]),
        (&["bound", "scene.toml"], "bound", &["bound.svg", "bound.png"]),
        (&["explain", "scene.toml"], "explain", &["explain.svg", "explain.png"]),
        (&["observe", "log.csv"], "observe", &["observe.svg", "observe.png"]),
        (&["identify", "log.csv"], "identify", &["identify.svg", "identify.png", "identify.toml"]),
        (
            &["tune", "scene.toml", "--trials", "2", "--runs", "2"],
            "tune",
            &["tune.svg", "tune.png", "popc.toml"],
        ),
        (
            &["compare", "scene.toml", "--stabilizers", "none,popc"],
            "compare",
            &["scene.svg", "scene.png", "scene.energy.csv", "scene.trade-off.svg"],
        ),
        (
            &["map", "scene.toml", "--x", "device.mass=0.1..0.4:3"],
            "sweep",
            &["sweep.svg", "sweep.png", "verdicts.svg"],
        ),
    ];
    for (command, name, figures) in cases {
        let out = format!("new/{name}");
        let said = place.run(command.iter().chain(&["--out", &out, "--json"]));
        said.ended(0, &[]);
        assert_eq!(place.text(&format!("{out}/{name}.json")), said.out, "{name}");
        let rows = place.text(&format!("{out}/{name}.csv"));
        assert!(rows.lines().count() > 1, "{name}: {rows}");
        let width = |line: &str| line.split(',').count();
        assert!(rows.lines().all(|line| width(line) == width(rows.lines().next().unwrap())));
        for figure in figures {
            assert!(place.path(format!("{out}/{figure}")).is_file(), "{name}: {figure}");
        }
        let page = place.text(&format!("{out}/report.html"));
        is_offline(&page);
        assert!(page.len() < 1_000_000, "{name}: {}", page.len());
        // The page tells how to make it again.
        assert!(page.contains(&format!("lyapunov {}", command.join(" "))), "{name}");
        for file in page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            assert!(
                file.starts_with('#') || place.path(format!("{out}/{file}")).is_file(),
                "{file}"
            );
        }
    }
}

/// The rows of `--out` are those of `--csv`.
#[test]
fn the_rows_in_a_folder_are_the_rows_of_the_run() {
    let place = place();
    place.run(["run", "scene.toml", "--csv", "rows.csv", "--quiet"]).ended(0, &[]);
    place.run(["run", "scene.toml", "--out", "out"]).ended(0, &["verdict"]);
    assert_eq!(place.text("out/run.csv"), place.text("rows.csv"));
    assert_eq!(place.names("out"), ["report.html", "run.csv", "run.json", "run.png", "run.svg"]);
}

#[test]
fn no_folder_stays_behind_after_bad_input() {
    let place = place();
    fs::write(place.path("bad.toml"), "duration = -1\n").unwrap();
    for command in ["run", "bound", "explain", "effects", "tune"] {
        place.refuses([command, "bad.toml", "--out", "out"], &["bad.toml", "duration"]);
        place.refuses([command, "scene.toml", "--out", "scene.toml"], &["name a folder"]);
    }
}

/// The effects of a scene are those that it names.
#[test]
fn effects_of_a_scene() {
    let place = place();
    let said = place.run(["effects", "scene.toml", "--json", "--out", "out"]);
    said.ended(0, &[]);
    let told: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    let effects = told["scalars"][0]["effects"].as_array().unwrap();
    assert_eq!(effects.len(), 1);
    assert_eq!((&told["scene"], &effects[0]["effect"]), (&"scene.toml".into(), &"delay".into()));
    // Alone and with all others are the same loops here.
    assert_eq!(effects[0]["alone"], effects[0]["composed"]);
    is_offline(&place.text("out/report.html"));
    assert!(place.text("out/effects.csv").lines().count() == 3);
}
