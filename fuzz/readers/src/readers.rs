//! Readers of files and of command lines, over any bytes: each answers with a value or an error, and what it wrote it reads
//! again. The tests of the command take this file too, so that nothing is built twice.

use std::ffi::OsString;
use std::fs;
use std::path::PathBuf;

use lyapunov_cli::Bench;
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::map::{Axis, Checkpoint, Grid, Rows, Shard, Survey, TableHeader, table_name};
use lyapunov_lab::models::Model;
use lyapunov_lab::scene::{Diagnostic, Scene};
use lyapunov_lab::teleoperation::Teleoperator;
use lyapunov_lab::{Rollout, identify, observe};

/// What reads bytes.
type Reader = fn(&[u8]);

/// The readers, each with its name.
pub(crate) const KINDS: [(&str, Reader); 9] = [
    ("scene", scene),
    ("model", model),
    ("teleoperator", teleoperator),
    ("log", log),
    ("identified log", identified),
    ("table", table),
    ("unfinished table", unfinished),
    ("motion", motion),
    ("command line", command_line),
];

/// The text of a file; what is none is refused before it is read.
fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What a fault tells names a line of the text, if any, and is for a terminal.
fn is_told(fault: &Diagnostic, text: &str) {
    let shown = fault.to_string();
    assert!(!shown.trim().is_empty(), "nothing is told of {text:?}");
    assert!(!shown.contains(['\u{1b}', '\0', '\u{7}']), "control characters in {shown:?}");
    let lines = text.split('\n').count();
    assert!(fault.line().is_none_or(|line| line >= 1 && line <= lines), "{shown}");
}

fn scene(bytes: &[u8]) {
    let text = text(bytes);
    match Scene::parse(&text, "scene.toml") {
        Ok(scene) => {
            if scene.servo_rate.get() <= 1e6
                && let Ok(rollout) = Rollout::<f64>::of(&scene)
            {
                rollout.take(20).for_each(drop);
            }
            is_written(&scene);
        }
        Err(fault) => is_told(&fault, &text),
    }
}

/// The head of a table has the whole scene, and reads back as it was.
fn is_written(scene: &Scene) {
    let (x, y) = ("device.mass=0.1..1:2", "device.damping=0.1..1:2");
    let axes = [x, y].map(|it| it.parse::<Axis>().expect("an axis"));
    let [x, y] = axes;
    let none = "none".parse::<StabilizerNames>().expect("a name");
    let Ok(grid) = Grid::new(scene.clone(), x, y, none) else { return };
    let shard = "0/1".parse::<Shard>().expect("a shard");
    let head = TableHeader::of(&grid, shard);
    let read = TableHeader::read(&mut head.text().as_bytes()).expect("its own head");
    let (again, _) = read.parse().unwrap_or_else(|error| panic!("{error} in {}", head.text()));
    assert_eq!(TableHeader::of(&again, shard), head);
}

fn model(bytes: &[u8]) {
    let text = text(bytes);
    if let Err(fault) = Model::parse(&text, "model.toml") {
        is_told(&fault, &text);
    }
}

fn teleoperator(bytes: &[u8]) {
    let text = text(bytes);
    if let Err(fault) = Teleoperator::parse(&text, "teleoperator.toml") {
        is_told(&fault, &text);
    }
}

fn log(bytes: &[u8]) {
    match observe::observe(bytes, "log.csv", &observe::Settings::default()) {
        Ok(observed) => {
            // The names of the columns come first, also where there is no contact.
            let rows = observed.csv().lines().count();
            assert_eq!(rows, observed.report.contacts.worst.len() + 1);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

fn identified(bytes: &[u8]) {
    match identify::identify(bytes, "log.csv", &identify::Settings::default()) {
        Ok(found) => assert!(Scene::parse(&found.scene, "found").is_ok(), "{}", found.scene),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

fn table(mut bytes: &[u8]) {
    let Ok(head) = TableHeader::read(&mut bytes) else { return };
    let Ok((grid, _)) = head.parse() else { return };
    let mut rows = Rows::new(bytes, grid, 0);
    while let Ok(Some(_)) = rows.next_cell() {}
}

/// A folder for what is read from a place only.
fn scratch() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("lyapunov-readers-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a scratch folder");
    folder
}

const SMALL: &str = "duration = 0.01\nservo_rate = 1000.0\ndevice.mass = 0.2\ndevice.damping = 0.1\n\
                     environment.wall.stiffness = 8000.0\n";

/// A small map.
fn grid() -> (Grid, Shard) {
    let scene = Scene::parse(SMALL, "small.toml").expect("a scene");
    let axis = |text: &str| text.parse::<Axis>().expect("an axis");
    let (x, y) = (axis("device.mass=0.1..1:2"), axis("device.damping=0.1..1:2"));
    let none = "none".parse::<StabilizerNames>().expect("a name");
    let grid = Grid::new(scene, x, y, none).expect("a grid");
    (grid, "0/1".parse::<Shard>().expect("a shard"))
}

/// The unfinished table of that map, with all of its rows.
#[cfg(test)]
pub(crate) fn written_table() -> Vec<u8> {
    let (grid, shard) = grid();
    let folder = scratch();
    let mut survey = Survey::of(&grid);
    let part = folder.join(table_name(shard).replace(".csv", ".part.csv"));
    // A run before may have been killed.
    let _gone = fs::remove_file(&part);
    let begun = Checkpoint::open(&folder, &grid, shard, false, &mut survey, &|| true);
    drop(begun.expect("an empty folder"));
    let text = fs::read(&part).expect("a file");
    fs::remove_file(&part).expect("it is there");
    text
}

fn unfinished(bytes: &[u8]) {
    let (grid, shard) = grid();
    let (folder, mut survey) = (scratch(), Survey::of(&grid));
    let part = folder.join(table_name(shard).replace(".csv", ".part.csv"));
    fs::write(&part, bytes).expect("a file");
    if let Ok(checkpoint) = Checkpoint::open(&folder, &grid, shard, true, &mut survey, &|| true) {
        assert!(checkpoint.next() <= grid.cells());
        // What is taken was written by this program: random bytes have no right checksum.
        assert_eq!(survey.judged(0), checkpoint.next());
        drop(checkpoint);
        let kept = fs::read(&part).expect("a file");
        let whole = bytes.starts_with(&kept) || !kept.is_empty();
        assert!(whole, "{} bytes are left of {}", kept.len(), bytes.len());
    }
    fs::remove_file(&part).expect("it is there");
}

fn motion(bytes: &[u8]) {
    let folder = scratch();
    let text = format!(
        "{SMALL}operator = {{ mass = 0.1, motion = {{ kind = \"file\", path = \"motion.csv\" }} }}\n"
    );
    fs::write(folder.join("motion.csv"), bytes).expect("a file");
    fs::write(folder.join("scene.toml"), &text).expect("a file");
    if let Err(fault) = Scene::load(&folder.join("scene.toml")) {
        is_told(&fault, &text);
    }
}

/// Words between line breaks, as the arguments of the command.
fn command_line(bytes: &[u8]) {
    let text = text(bytes);
    let words = std::iter::once("lyapunov").chain(text.split('\n'));
    if let Err(told) = Bench::new().understands(words.map(OsString::from)) {
        assert!(!told.is_empty(), "nothing is told of {text:?}");
    }
}

#[cfg(test)]
#[path = "mutated.rs"]
mod mutated;
