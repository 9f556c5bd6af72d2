//! Files that stay: the hash of what each command writes and prints, in `golden.csv` beside this file.
//!
//! They say that something changed, not that it is right. `cargo test -p lyapunov-cli --test command -- --ignored golden`
//! writes the file anew: look at what differs before that.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::cli::place::Place;

const HEADS: &str = "command,file,hash";

/// Names and commands, of scenes that have most effects between them.
const COMMANDS: &[(&str, &str)] = &[
    ("run", "run tour.toml"),
    ("plane", "run plane.toml"),
    ("none", "run paper-50k-none.toml"),
    ("bound", "bound press-1khz.toml"),
    ("explain", "explain tour.toml"),
    ("help", "explain paper-50k-none.toml"),
    ("observe", "observe mujoco-wall.csv"),
    ("replay", "observe mujoco-wall.csv --scene paper-8k-none.toml --stabilizers all"),
    ("identify", "identify mujoco-encoder.csv"),
    ("gaps", "observe gaps.csv"),
    ("later", "identify gaps.csv"),
    ("moving", "run moving-wall.toml"),
    ("cubic", "bound cubic-spring.toml"),
    ("varying", "explain varying-spring.toml"),
    ("claims", "paper --draws 40 --seed 3"),
    ("tune", "tune delay.toml --trials 3 --runs 2"),
    (
        "stiff",
        "tune press-1khz.toml --objective stiffness --trials 2 --runs 2 --stabilizers popc,popc-bounded",
    ),
    ("sweep", "map tour.toml --x device.mass=0.1..0.4:7 --stabilizers none,popc"),
    (
        "map",
        "map press-1khz.toml --x environment.wall.stiffness=500..8000:12 --y device.damping=0.1..4:9 --stabilizers none,popc",
    ),
    (
        "refine",
        "map hold.toml --x environment.wall.stiffness=500..8000:256 --y device.damping=0.1..4:256 --refine",
    ),
    ("compare", "compare encoder.toml tour.toml --stabilizers none,popc,lolc-spring"),
    ("messages", "compare constant-delay.toml lossy.toml varying-delay.toml"),
    ("robots", "compare two-link-arm.toml prosthetic-leg.toml --stabilizers none,popc"),
    ("machines", "compare admittance-device.toml dc-motor.toml --stabilizers none,popc"),
    ("oscillators", "compare inverted-pendulum.toml van-der-pol.toml --stabilizers none,popc"),
];

/// The command that measures times, which are in all that it writes but its pictures and its JSON.
const TIMED: &str = "compare";

/// Part of a printed line that tells the machine.
const MACHINE: &str = " cells at once ";

/// FNV-1a over the bytes.
fn hash(bytes: &[u8]) -> u64 {
    let next = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01B3);
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, next)
}

/// A document without what it says is not deterministic.
fn deterministic(document: &str) -> String {
    fn strip(value: &mut Value, keys: &[String]) {
        match value {
            Value::Object(object) => {
                object.retain(|key, _| !keys.contains(key));
                object.values_mut().for_each(|it| strip(it, keys));
            }
            Value::Array(array) => array.iter_mut().for_each(|it| strip(it, keys)),
            _ => {}
        }
    }
    let mut document: Value = serde_json::from_str(document).unwrap();
    let keys = document["not_deterministic"].clone();
    let keys: Vec<String> = serde_json::from_value(keys).unwrap_or_default();
    strip(&mut document, &keys);
    document.to_string()
}

fn place() -> Place {
    let place = Place::new();
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    for folder in ["", "logs", "models", "teleoperation"] {
        for entry in fs::read_dir(scenes.join(folder)).unwrap() {
            let entry = entry.unwrap();
            if entry.file_type().unwrap().is_file() {
                place.put(entry.file_name(), fs::read(entry.path()).unwrap());
            }
        }
    }
    place.put("gaps.csv", gaps(&place.text("mujoco-encoder.csv")));
    place
}

/// A log five seconds later, of which a tenth of a second and the numbers of two rows are lost.
fn gaps(log: &str) -> String {
    let row = |(n, line): (usize, &str)| {
        let (time, rest) = line.split_once(',').unwrap();
        match time.parse::<f64>() {
            Err(_) => Some(format!("{line}\n")),
            Ok(_) if (500..600).contains(&n) => None,
            Ok(time) if n % 700 == 350 => Some(format!("{:?},nan,nan\n", time + 5.0)),
            Ok(time) => Some(format!("{:?},{rest}\n", time + 5.0)),
        }
    };
    log.lines().enumerate().filter_map(row).collect()
}

/// A line for what a command prints, and for each of its files. Pixels are left out: other processors round them otherwise.
fn lines() -> Vec<String> {
    let place = place();
    let mut lines = Vec::new();
    for (name, command) in COMMANDS {
        let said = place.run(command.split(' ').chain(["--out", name]));
        said.ended(0, &[]);
        let mut add = |file: &str, lasting: &str| {
            lines.push(format!("{name},{file},{:016x}", hash(lasting.as_bytes())));
        };
        if *name != TIMED {
            let lasting: Vec<_> = said.out.lines().filter(|it| !it.contains(MACHINE)).collect();
            add("printed", &lasting.join("\n"));
        }
        for file in place.names(name) {
            let text = |file: &str| place.text(&format!("{name}/{file}"));
            match file.rsplit('.').next().unwrap() {
                "png" => {}
                "json" => add(&file, &deterministic(&text(&file))),
                "csv" | "html" if *name == TIMED => {}
                _ => add(&file, &text(&file)),
            }
        }
    }
    lines
}

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cli/golden.csv")
}

#[test]
fn every_file_is_as_it_was() {
    let kept = fs::read_to_string(file()).expect("cli/tests/cli/golden.csv");
    let kept: Vec<&str> = kept.lines().skip(1).collect();
    let lines = lines();
    let differ: Vec<&String> = lines.iter().filter(|it| !kept.contains(&it.as_str())).collect();
    assert!(
        differ.is_empty() && kept.len() == lines.len(),
        "of {} lines of cli/tests/cli/golden.csv {} files are these: {differ:#?}\n\
         Look at them, and write them anew as the head of golden.rs says",
        kept.len(),
        lines.len(),
    );
}

/// Scenes of one device are in `scenes/golden.csv`.
#[test]
fn every_shipped_model_and_teleoperator_is_kept() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let commands: Vec<&str> = COMMANDS.iter().flat_map(|it| it.1.split(' ')).collect();
    for folder in ["models", "teleoperation"] {
        let files = fs::read_dir(scenes.join(folder)).unwrap();
        let names = files.map(|it| it.unwrap().file_name().into_string().unwrap());
        let names: Vec<String> = names.filter(|it| it.ends_with(".toml")).collect();
        assert!(names.len() >= 3, "{folder}: {names:?}");
        for name in names {
            assert!(commands.contains(&&*name), "no command of golden.rs runs {name}");
        }
    }
}

#[test]
#[ignore = "writes golden.csv; what differs is looked at before"]
fn golden_files_are_written() {
    fs::write(file(), [vec![HEADS.to_owned()], lines(), vec![String::new()]].concat().join("\n"))
        .expect("golden.csv is written");
}
