//! Tests of `lyapunov map` with one axis.

use serde_json::Value;

use crate::cli::place::Place;

const SCENE: &str = "duration = 1.5\nservo_rate = 1000.0\nenvironment_rate = 200.0\ndevice.mass = 0.2\n\
    operator = { mass = 0.1, stiffness = 200.0, damping = 1.0, rest = 0.01 }\n\
    environment.wall = { stiffness = STIFFNESS, damping = 1.0 }\n";

fn place(stiffness: &str) -> Place {
    let place = Place::new();
    place.put("scene.toml", SCENE.replace("STIFFNESS", stiffness));
    place
}

/// The rows of a command, without the time of a step and the name of the scene.
fn rows(place: &Place, arguments: &[&str]) -> Vec<Value> {
    let said = place.run(arguments.iter().chain(&["--json"]));
    said.ended(0, &[]);
    let told: Value = serde_json::from_str(&said.out).unwrap();
    let bare = |row: &Value| {
        let mut row = row.clone();
        for key in ["ns_per_step", "scene", "value"] {
            row.as_object_mut().unwrap().remove(key);
        }
        row
    };
    told["rows"].as_array().unwrap().iter().map(bare).collect()
}

const NAMES: [&str; 2] = ["--stabilizers", "none,popc,tank"];

#[test]
fn a_sweep_is_as_many_comparisons() {
    let x = "environment.wall.stiffness=1000..9000:3";
    let swept = rows(&place("2000.0"), &["map", "scene.toml", "--x", x, NAMES[0], NAMES[1]]);
    let mut alone = Vec::new();
    for stiffness in ["1000.0", "5000.0", "9000.0"] {
        alone.extend(rows(&place(stiffness), &["compare", "scene.toml", NAMES[0], NAMES[1]]));
    }
    assert_eq!(swept, alone);
    let verdicts = |word: &str| swept.iter().filter(|row| row["verdict"] == word).count();
    assert!((1..swept.len()).contains(&verdicts("grows")), "{swept:?}");
}

#[test]
fn one_value_makes_a_sweep() {
    let x = "environment.wall.stiffness=5000..5000:1";
    let place = place("2000.0");
    let swept = rows(&place, &["map", "scene.toml", "--x", x, NAMES[0], NAMES[1], "--out", "out"]);
    assert_eq!(swept, rows(&self::place("5000.0"), &["compare", "scene.toml", NAMES[0], NAMES[1]]));
    assert_eq!(place.text("out/sweep.csv").lines().count(), 1 + 3);
    // A map of one column has as many cells as values of the other axis.
    let y = "environment.wall.damping=0..2:3";
    place.run(["map", "scene.toml", "--x", x, "--y", y, "--out", "map"]).ended(0, &["bounded"]);
    let refuses = |x: &str, words: &[&str]| {
        place.refuses(["map", "scene.toml", "--x", x], words);
    };
    refuses("device.mass=1..2:1", &["one value is a range of its own, 1..1:1"]);
    refuses("device.mass=1..1:2", &["1..1 is empty"]);
}

/// An axis over a table applies to that stabilizer, which the scene need not have, and to no other.
#[test]
fn an_axis_over_a_stabilizer_leaves_the_others_alone() {
    let place = place("6000.0");
    let caps = "stabilizer.popc.damping_cap=0.05..0.5:2";
    let all = ["--stabilizers", "popc,lolc-device-damping"];
    let swept = rows(&place, &["map", "scene.toml", "--x", caps, all[0], all[1]]);
    for (index, cap) in ["0.05", "0.5"].into_iter().enumerate() {
        let scene = SCENE.replace("STIFFNESS", "6000.0");
        place.put("capped.toml", format!("{scene}stabilizer.popc.damping_cap = {cap}\n"));
        let capped = rows(&place, &["compare", "capped.toml", "--stabilizers", "popc"]);
        assert_eq!(swept[2 * index], capped[0], "{cap}");
    }
    let usual = rows(&place, &["compare", "scene.toml", all[0], "lolc-device-damping"]);
    assert_eq!([&swept[1], &swept[3]], [&usual[0]; 2]);
    assert_ne!(swept[0], swept[2]);

    // The same in the cells of a map, on lanes as well as one by one.
    let stiffness = "environment.wall.stiffness=6000..9000:2";
    let axes = ["map", "scene.toml", "--x", caps, "--y", stiffness, all[0], all[1], "--out", "map"];
    place.run(axes).ended(0, &[]);
    let table = place.text("map/map.csv");
    let cell = |cap: &str, name: &str| -> Vec<String> {
        let start = format!("{cap},6000.0,{name},");
        let line = table.lines().find_map(|line| line.strip_prefix(&start)).unwrap();
        line.split(',').map(str::to_owned).collect()
    };
    let of =
        |row: &Value, key: &str| row[key].as_f64().map_or(String::new(), |it| format!("{it:?}"));
    for (index, cap) in ["0.05", "0.5"].into_iter().enumerate() {
        for (at, name) in ["popc", "lolc-device-damping"].into_iter().enumerate() {
            let (told, row) = (cell(cap, name), &swept[2 * index + at]);
            assert_eq!(told[0], row["verdict"].as_str().unwrap(), "{name} {cap}");
            if told[0] != "grows" {
                assert_eq!(told[3], of(row, "settling_time_s"), "{name} {cap}");
                assert_eq!(told[8], of(row, "energy_given_mj"), "{name} {cap}");
            }
        }
    }
    assert_eq!(
        place.run(axes[..8].iter().chain(&["--json"])).out.matches("\"method\": \"lanes\"").count(),
        1
    );
}

#[test]
fn errors_name_the_file_and_the_remedy() {
    let place = place("6000.0");
    let refuses = |x: &str, words: &[&str]| {
        place.refuses(["map", "scene.toml", "--x", x, "--out", "out"], words);
    };
    refuses("stabilizer.tank.start=1e-4..1e-3:3", &["scene.toml: ", "add `tank` to --stabilizers"]);
    refuses("stabilizer.tnk.start=1e-4..1e-3:3", &["scene.toml: ", "did you mean `tank`?"]);
    refuses("stabilizer.popc.cap=1..2:3", &["scene.toml: ", "`stabilizer.popc.cap`"]);
    refuses("stabilizer.popc.damping_cap=-1..2:3", &["scene.toml: ", "damping_cap"]);
    refuses("device.mas=1..2:3", &["scene.toml: ", "did you mean `device.mass`?"]);
    refuses(
        "effects.dropout.probability=0..1:3",
        &["scene.toml: ", "has no table [effects.dropout]", "add the table to the scene"],
    );
    refuses("environment.plane.stiffness=1..2:3", &["did you mean `environment.wall.stiffness`?"]);
    place.refuses(["map", "scene.toml", "--x", "device.mass=1..2:3", "--resume"], &["--y"]);
}
