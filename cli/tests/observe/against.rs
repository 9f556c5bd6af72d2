//! Logs laid over runs: a run against its own rows, and against logs whose difference is known.

use std::fs;
use std::path::{Path, PathBuf};

use approx::assert_relative_eq;
use serde_json::Value;
use tempfile::TempDir;

use crate::called::{prints, refuses};

/// Scenes, logs and results of one test.
struct Place(TempDir);

/// Row of our own columns: time, position, estimated velocity, force.
#[derive(Clone, Copy)]
struct Row {
    t: f64,
    x: f64,
    v: f64,
    f: f64,
}

fn shipped(name: &str) -> String {
    format!("{}/../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

impl Place {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn file(&self, name: &str, text: &str) -> String {
        let path = self.path(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    }

    /// The rows of a run, and the path of their file.
    fn rows(&self, scene: &str) -> (Vec<Row>, String) {
        let path = self.path("rows.csv").to_str().unwrap().to_owned();
        prints(["run", scene, "--csv", &path, "--quiet"]);
        let text = fs::read_to_string(&path).unwrap();
        let rows = text.lines().skip(1).map(|line| {
            let numbers: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
            Row { t: numbers[0], x: numbers[1], v: numbers[3], f: numbers[7] }
        });
        (rows.collect(), path)
    }
}

/// The log of these rows.
fn log(rows: impl IntoIterator<Item = Row>) -> String {
    let row = |Row { t, x, v, f }: Row| format!("{t:?},{x:?},{f:?},{v:?}\n");
    "t,x,f,v\n".to_owned() + &rows.into_iter().map(row).collect::<String>()
}

#[track_caller]
fn against(scene: &str, log: &str, more: &[&str]) -> Value {
    let arguments = ["run", scene, "--against", log, "--json"];
    let json: Value = serde_json::from_str(&prints([&arguments, more].concat())).unwrap();
    json["against"].clone()
}

const QUANTITIES: [&str; 3] = ["position", "velocity", "force"];
const VELOCITY: [&str; 2] = ["--columns", "t,x,f_act,v"];

/// The commands of a loop whose force acts two ticks late are, two rows later, what acts.
#[test]
fn a_late_force_is_laid_over_what_acts_then() {
    let place = Place::new();
    let scene = shipped("delay");
    let (_, rows) = place.rows(&scene);
    let commands = ["--columns", "t,x,f_out,v"];
    let off = |more: &[&str]| {
        let told = against(&scene, &rows, &[&commands[..], more].concat());
        told["force"]["rms"].as_f64().unwrap()
    };
    assert!(off(&[]) > 1.0 && off(&["--late", "1"]) > 0.5);
    assert_eq!(off(&["--late", "2"]), 0.0);
}

#[test]
fn a_run_differs_from_its_own_rows_by_nothing() {
    let place = Place::new();
    for name in ["paper-8k-none", "paper-50k-popc", "delay", "encoder", "hold", "link", "box"] {
        let scene = shipped(name);
        let (rows, path) = place.rows(&scene);
        for more in [&[][..], &VELOCITY] {
            let found = against(&scene, &path, more);
            assert_eq!(found["rows"], rows.len());
            for quantity in QUANTITIES {
                let it = &found[quantity];
                assert_eq!(
                    (&it["rms"], &it["largest"]),
                    (&0.0.into(), &0.0.into()),
                    "{name} {quantity}"
                );
            }
        }
    }
}

#[test]
fn a_shifted_and_a_scaled_log_give_the_stated_difference() {
    let place = Place::new();
    let scene = shipped("paper-8k-lolc");
    let (rows, _) = place.rows(&scene);
    let changed =
        rows.iter().map(|row| Row { x: row.x + 1e-3, v: 0.5 * row.v, f: 1.25 * row.f, ..*row });
    let path = place.file("changed.csv", &log(changed));
    let found = against(&scene, &path, &["--columns", "t,x,f,v"]);
    let rms = |of: &dyn Fn(&Row) -> f64| {
        (rows.iter().map(|row| of(row) * of(row)).sum::<f64>() / rows.len() as f64).sqrt()
    };
    let range = |of: &dyn Fn(&Row) -> f64| {
        let all = rows.iter().map(of);
        all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
    };
    let number = |quantity: &str, key: &str| found[quantity][key].as_f64().unwrap();
    let near =
        |found: f64, expected: f64| assert_relative_eq!(found, expected, max_relative = 1e-9);
    near(number("position", "rms"), 1.0);
    near(number("position", "largest"), -1.0);
    near(number("position", "range"), 1e3 * range(&|row| row.x));
    near(number("position", "rms_percent"), 0.1 / range(&|row| row.x));
    near(number("velocity", "rms"), 500.0 * rms(&|row| row.v));
    near(number("velocity", "range"), 500.0 * range(&|row| row.v));
    near(number("force", "rms"), 0.25 * rms(&|row| row.f));
    near(number("force", "rms_percent"), 20.0 * rms(&|row| row.f) / range(&|row| row.f));
    // A shift alone leaves the velocity of positions as it is.
    let found = against(&scene, &path, &[]);
    assert!(found["velocity"]["rms"].as_f64().unwrap() < 1e-9, "{found}");
}

#[test]
fn rows_at_another_rate_and_between_ticks_are_laid_over_the_run_there() {
    let place = Place::new();
    let scene = shipped("paper-8k-lolc");
    let (rows, _) = place.rows(&scene);
    let third = place.file("third.csv", &log(rows.iter().copied().step_by(3)));
    let between = rows.windows(2).map(|pair| {
        let mean = |one: f64, other: f64| 0.5 * (one + other);
        let [one, other] = [pair[0], pair[1]];
        Row { t: mean(one.t, other.t), x: mean(one.x, other.x), v: mean(one.v, other.v), f: one.f }
    });
    let between = place.file("between.csv", &log(between));
    for path in [third, between] {
        let found = against(&scene, &path, &["--columns", "t,x,f,v"]);
        for quantity in QUANTITIES {
            let share = found[quantity]["largest_percent"].as_f64().unwrap();
            assert!(share < 1e-9, "{path} {quantity}: {share} %");
        }
    }
}

#[test]
fn rounded_time_stamps_leave_each_row_at_its_tick() {
    let place = Place::new();
    let text = fs::read_to_string(shipped("paper-8k-lolc")).unwrap();
    assert!(text.contains("servo_rate = 100.0"));
    let thirds = text.replace("servo_rate = 100.0", "servo_rate = 3000.0");
    let thirds = place.file("thirds.toml", &thirds);
    for (scene, rate) in [(shipped("paper-8k-lolc"), 100), (thirds, 3000)] {
        let (rows, _) = place.rows(&scene);
        let made = |head: &str, stamp: &dyn Fn(usize) -> String| {
            let row =
                |(tick, row): (usize, &Row)| format!("{},{:?},{:?}\n", stamp(tick), row.x, row.f);
            head.to_owned() + "\n" + &rows.iter().enumerate().map(row).collect::<String>()
        };
        // To a microsecond; nanoseconds since 1970, of which an f64 tells 256 from 0; the same in seconds.
        let nanoseconds = |tick: usize| (tick * 1_000_000_000 + rate / 2) / rate;
        let short = made("t,x,f", &|tick| format!("{:.6}", tick as f64 / rate as f64));
        let long =
            made("t[ns],x,f", &|tick| (1_700_000_000_000_000_000 + nanoseconds(tick)).to_string());
        let seconds = made("t,x,f", &|tick| {
            let since = nanoseconds(tick);
            format!("{}.{:09}", 1_700_000_000 + since / 1_000_000_000, since % 1_000_000_000)
        });
        for (log, start) in [(short, "scene"), (long, "log"), (seconds, "log")] {
            let found = against(&scene, &place.file("rounded.csv", &log), &["--start", start]);
            assert_eq!(found["rows"], rows.len());
            for quantity in ["position", "force"] {
                assert_eq!(found[quantity]["largest"], 0.0, "{rate} Hz, {start}: {quantity}");
            }
        }
    }
}

#[test]
fn units_and_commas_give_the_identical_difference() {
    let place = Place::new();
    let scene = shipped("paper-8k-lolc");
    let (rows, _) = place.rows(&scene);
    let line = |row: &Row, marks: [&str; 3]| {
        let [t, x, f] = [row.t, row.x + 1e-4, row.f].map(|it| format!("{it:?}"));
        [t, x, f].into_iter().zip(marks).map(|(it, end)| it + end).collect::<Vec<_>>()
    };
    let made = |name: &str, head: &str, between: &str, exponents: [&str; 3]| {
        let rows = rows.iter().map(|row| {
            let fields = line(row, [""; 3]).into_iter().zip(exponents);
            let fields = fields.map(|(field, exponent)| match field.split_once('e') {
                Some((digits, power)) => {
                    let moved = power.parse::<i32>().unwrap() + exponent.parse::<i32>().unwrap();
                    format!("{digits}e{moved}")
                }
                None => format!("{field}e{exponent}"),
            });
            fields.collect::<Vec<_>>().join(between) + "\n"
        });
        head.to_owned()
            + "\n"
            + &rows.collect::<String>().replace('.', if name == "comma" { "," } else { "." })
    };
    let si = place.file("si", &made("si", "t,x,f", ",", ["0", "0", "0"]));
    let comma = place.file("comma", &made("comma", "time (ms);x [mm];f_kN", ";", ["3", "3", "-3"]));
    let [one, other] = [si, comma].map(|path| {
        let found = against(&scene, &path, &[]);
        QUANTITIES.map(|quantity| found[quantity].clone())
    });
    assert_eq!(one, other);
}

#[test]
fn a_run_may_start_where_the_log_does() {
    let place = Place::new();
    let text = fs::read_to_string(shipped("paper-8k-lolc")).unwrap();
    assert!(text.contains("position = -0.004"));
    let own = shipped("paper-8k-lolc");
    let other = place.file("other.toml", &text.replace("position = -0.004", "position = -0.001"));
    let (rows, _) = place.rows(&own);
    let later =
        place.file("later.csv", &log(rows.iter().map(|row| Row { t: row.t + 64.0, ..*row })));
    let found = against(&other, &later, &["--start", "log"]);
    assert_eq!((&found["start"], &found["from_s"]), (&"log".into(), &0.0.into()));
    for quantity in QUANTITIES {
        let share = found[quantity]["largest_percent"].as_f64().unwrap();
        assert!(share < 1e-6, "{quantity}: {share} %");
    }
    let apart = against(&other, &place.rows(&own).1, &[]);
    assert_relative_eq!(
        apart["position"]["largest"].as_f64().unwrap().abs(),
        3.0,
        max_relative = 0.5
    );
    refuses(
        &["run", &other, "--against", &later],
        &["begins at 64.0 s", "0 to 10.0 s", "--start log"],
    );
    let space = shipped("box");
    refuses(
        &["run", &space, "--against", &later, "--start", "log"],
        &["one axis", "leave --start log out"],
    );
}

#[test]
fn what_does_not_fit_is_told_and_not_guessed() {
    let place = Place::new();
    let scene = shipped("paper-8k-lolc");
    let (rows, path) = place.rows(&scene);
    let last = rows[rows.len() - 1];
    let long = log(rows.iter().copied().chain([Row { t: last.t + 0.5, ..last }]));
    let long = place.file("long.csv", &long);
    let reasons =
        ["log goes on until 10.5 s, and the scene ends at 10.0 s", "duration of 10.5 or more"];
    refuses(&["run", &scene, "--against", &long], &reasons);
    // A log with a clock of its own fits once it is counted from its first row.
    let late = log(rows.iter().map(|row| Row { t: row.t + 3.0, ..*row }));
    let late = place.file("late.csv", &late);
    let reasons = ["goes on until 13.0 s", "duration of 13.0 or more", "3.0 s", "--start"];
    refuses(&["run", &scene, "--against", &late], &reasons);
    assert_eq!(against(&scene, &late, &["--start", "log"])["rows"], rows.len());
    refuses(&["run", &scene, "--start", "log"], &["--against"]);
    refuses(&["run", &scene, "--against", "missing.csv"], &["missing.csv: there is no such file"]);
    refuses(&["run", &scene, "--against", &path, "--csv", &path], &["this is the log itself"]);
    let none = place.file("none.csv", "t,x,f\n0,0,0\n");
    refuses(&["run", &scene, "--against", &none], &["fewer than two good rows"]);

    // A short log is compared as far as it goes, with its bad rows left out.
    let short = "t,x,f\n".to_owned() + "0.0,-0.004,0\n0.01,nothing,0\n0.02,-0.004,0\n0.01,0,0\n";
    let found = against(&scene, &place.file("short.csv", &short), &[]);
    assert_eq!((&found["rows"], &found["bad_rows"]["count"]), (&2.into(), &2.into()));
    assert_eq!((&found["to_s"], &found["scene_s"]), (&0.02.into(), &10.0.into()));
    assert_eq!(found["position"]["rms_percent"], Value::Null);

    let turned = log(rows.iter().map(|row| Row { f: -row.f, ..*row }));
    let found = against(&scene, &place.file("turned.csv", &turned), &[]);
    assert_eq!(found["look_at"][0]["sign"], "reversed");
    assert_eq!(found["look_at"].as_array().map(Vec::len), Some(1), "{}", found["look_at"]);

    // Its own unit is told of a log too, and the factor that mends it.
    let far = log(rows.iter().map(|row| Row { x: 1e3 * row.x, ..*row }));
    let far = place.file("far.csv", &far);
    let found = against(&scene, &far, &[]);
    assert_eq!(found["look_at"][0]["sign"], "unit", "{}", found["look_at"]);
    assert!(found["look_at"][0]["text"].as_str().unwrap().contains("--scale x=1e-3"));
    let found = against(&scene, &far, &["--scale", "x=1e-3"]);
    assert_eq!(found["look_at"].as_array().map(Vec::len), Some(0));
}

#[test]
fn the_page_holds_table_and_figure() {
    let place = Place::new();
    let scene = shipped("paper-8k-none");
    let log = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/logs/mujoco-wall.csv");
    let out = place.path("out");
    let out = out.to_str().unwrap();
    let told = prints(["run", &scene, "--against", log, "--out", out]);
    assert!(told.contains("run - log") && told.contains("201 rows from 0 s to 2 s"), "{told}");
    let read = |name: &str| fs::read_to_string(Path::new(out).join(name)).unwrap();
    let page = read("report.html");
    assert!(page.contains("Against the log") && page.contains("id=\"against\""));
    assert!(read("against.csv").starts_with("quantity,unit,rms,largest,"));
    // The simulator of the log is another one, and the loop diverges.
    let json: Value = serde_json::from_str(&read("run.json")).unwrap();
    assert!(json["against"]["position"]["largest_percent"].as_f64().unwrap() < 1e-6, "{json}");
    assert!(read("against.svg").starts_with("<svg"));
}
