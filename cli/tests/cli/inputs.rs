//! Inputs and outputs of a command: none is both, whatever the paths, and an output that cannot be written is known before the work.

use std::fs;
use std::os::unix::fs::symlink;
use std::process::Command;
use std::time::Duration;

use crate::cli::place::{Place, SCENE};

fn motion() -> Place {
    let place = Place::new();
    place.put("scene.toml", include_str!("../../../scenes/motion-file.toml"));
    place.put("motion-file.csv", include_str!("../../../scenes/motion-file.csv"));
    place
}

#[test]
fn the_rows_never_replace_the_motion() {
    let place = motion();
    symlink("motion-file.csv", place.path("link.csv")).unwrap();
    fs::hard_link(place.path("motion-file.csv"), place.path("twin.csv")).unwrap();
    for csv in ["motion-file.csv", "./motion-file.csv", "link.csv", "twin.csv"] {
        let words = [csv, "this is the motion of the scene itself", "of their own"];
        place.refuses(["run", "scene.toml", "--csv", csv], &words);
    }
    fs::create_dir(place.path("out")).unwrap();
    fs::hard_link(place.path("motion-file.csv"), place.path("out/run.csv")).unwrap();
    place.refuses(
        ["run", "scene.toml", "--out", "out"],
        &["out/run.csv", "the motion of the scene"],
    );
}

#[test]
fn a_folder_of_results_never_replaces_what_they_are_made_of() {
    let place = Place::with_scene();
    fs::create_dir(place.path("out")).unwrap();
    place.put("out/popc.toml", SCENE);
    place.put("out/observe.csv", include_str!("../../../scenes/logs/mujoco-wall.csv"));
    let quick = ["tune", "out/popc.toml", "--out", "out", "--trials", "2", "--runs", "2"];
    place.refuses(quick, &["out/popc.toml", "this is the scene itself"]);
    place.refuses(["observe", "out/observe.csv", "--out", "out"], &["this is the log itself"]);
    for (command, file) in [("bound", "bound.csv"), ("explain", "explain.csv"), ("run", "run.csv")]
    {
        let file = format!("out/{file}");
        place.put(&file, SCENE);
        place.refuses([command, &file, "--out", "out"], &[&file, "this is the scene itself"]);
    }
    place.put("out/compare.csv", SCENE);
    place.refuses(["compare", "out/compare.csv", "--out", "out"], &["this is the scene itself"]);
    place.put("out/map.csv", SCENE);
    let axes = ["--x", "device.mass=0.1..0.4:3", "--y", "duration=1..2:2", "--out", "out"];
    let map = [&["map", "out/map.csv"], &axes[..]].concat();
    place.refuses(map, &["out/map.csv", "this is the scene itself"]);
}

/// Hours of work come after what can be known at once.
#[test]
fn a_folder_in_the_way_is_noticed_before_the_work() {
    let place = Place::new();
    place.put_scene("long.toml", "duration = 10.0", "duration = 1e7");
    place.put("log.csv", include_str!("../../../scenes/logs/mujoco-wall.csv"));
    let axes = ["--x", "device.mass=0.1..0.4:300", "--y", "duration=1e6..2e6:300"];
    let map = [&["map", "long.toml"], &axes[..]].concat();
    let sweep = &map[..4];
    let cases: [(&[&str], &[&str]); 11] = [
        (&["run", "long.toml"], &["report.html", "run.json", "run.csv", "run.svg", "run.png"]),
        (&["bound", "long.toml"], &["bound.json", "bound.png", "bound.csv"]),
        (&["explain", "long.toml"], &["explain.json", "explain.svg", "explain.csv"]),
        (&["observe", "log.csv"], &["observe.json", "observe.svg", "observe.csv"]),
        (&["tune", "long.toml"], &["tune.csv", "popc.toml", "lolc.toml"]),
        (
            &["compare", "long.toml"],
            &["compare.csv", "long.svg", "long.energy.csv", "long.trade-off.png", "long.force.svg"],
        ),
        (&map, &["map.csv", "map.json", "verdict.png", "stiffness_felt.svg", "report.html"]),
        (sweep, &["sweep.csv", "sweep.json", "verdicts.svg", "sweep.png"]),
        (&["accuracy", "long.toml"], &["accuracy.csv", "accuracy.png"]),
        (&["effects", "long.toml"], &["effects.csv", "effects.svg"]),
        (&["paper"], &["figure-9.png", "claims.json", "paper-8k-lolc.csv"]),
    ];
    for (command, files) in cases {
        for file in files {
            let folder = format!("out/{file}");
            fs::create_dir_all(place.path(&folder)).unwrap();
            let words = [&format!("{folder} cannot be written: this is a folder")[..]];
            let said = place.refuses(command.iter().chain(&["--out", "out"]), &words);
            assert!(said.took < Duration::from_secs(5), "{command:?} {file}: {:?}", said.took);
            fs::remove_dir_all(place.path("out")).unwrap();
        }
    }
    place.refuses(["hard", "--out", "long.toml"], &["name a folder"]);
}

#[test]
fn a_pipe_is_no_place_for_results() {
    let place = Place::with_scene();
    fs::create_dir(place.path("out")).unwrap();
    assert!(Command::new("mkfifo").arg(place.path("out/run.json")).status().unwrap().success());
    place.refuses(["run", "scene.toml", "--out", "out"], &["out/run.json", "this is a pipe"]);
}

/// A motion of one endless line, and one that tries to colour the terminal.
#[test]
fn errors_quote_little_and_nothing_that_controls_the_terminal() {
    let place = motion();
    fs::remove_file(place.path("motion-file.csv")).unwrap();
    symlink("/dev/zero", place.path("motion-file.csv")).unwrap();
    let quoted = |words: &[&str]| {
        let said = place.refuses(["run", "scene.toml"], words);
        assert!(said.err.len() < 1000, "{} bytes", said.err.len());
        assert!(!said.err.contains(|it: char| it.is_control() && it != '\n'), "{said:?}");
    };
    quoted(&["line 1", "goes on for too long"]);
    fs::remove_file(place.path("motion-file.csv")).unwrap();
    let long = "9".repeat(3000);
    for (text, words) in [
        (format!("t,rest\n0,0\n{long}\n"), "line 3"),
        (format!("t,rest\n0,0\n{}", "1".repeat(1 << 20)), "line 3"),
        ("t,rest\n\u{1b}[31mred\u{1b}[0m\n".to_owned(), "line 2"),
        ("\u{1b}]0;title\u{7}\n".to_owned(), "line 1"),
        (format!("t,rest,{long}\n"), "not `t,rest`"),
    ] {
        place.put("motion-file.csv", text);
        quoted(&[words]);
    }
    let scene = place.text("scene.toml").replace("\"motion-file.csv\"", "\"\\u001b[31m.csv\"");
    place.put("scene.toml", scene);
    quoted(&["cannot be read"]);
    let said = place.run(["run", "\u{1b}[31m.toml"]);
    assert!(!said.err.contains('\u{1b}'), "{said:?}");
    let said = place.run(["run", "scene.toml", "--csv", "\u{1b}[31m/rows.csv"]);
    assert!(!said.err.contains('\u{1b}'), "{said:?}");
}

#[test]
fn a_name_that_controls_the_terminal_is_shown_without() {
    let place = Place::with_scene();
    place.put("\u{1b}[31m.toml", place.text("scene.toml"));
    for command in ["run", "compare", "explain", "bound"] {
        let said = place.run([command, "\u{1b}[31m.toml"]);
        assert!(said.out.contains("[31m.toml"), "{said:?}");
        assert!(!said.out.contains('\u{1b}'), "{said:?}");
    }
}

#[test]
fn a_range_error_of_accuracy_names_file_and_key() {
    let place = Place::new();
    let scene = |damping: &str, stiffness: &str| {
        format!(
            "duration = 0.01\nservo_rate = 1000.0\ndevice.mass = 0.2\n\
             operator = {{ mass = 0.1, damping = {damping}, stiffness = {stiffness} }}\n\
             environment.wall = {{ stiffness = 2000.0, damping = 1.0 }}\n"
        )
    };
    for (damping, stiffness, key) in
        [("1e300", "200.0", "operator.damping"), ("2.0", "1e150", "operator.stiffness")]
    {
        place.put("scene.toml", scene(damping, stiffness));
        let words = ["scene.toml: ", key, "stands out; give a value nearer to 1"];
        place.refuses(["accuracy", "scene.toml", "--out", "out"], &words);
    }
}
