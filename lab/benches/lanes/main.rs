//! Gain of lanes of boxes: for each shipped scene on a line, and for each member of the family on `press-1khz`, the time
//! of a small map run cell by cell over that on lanes, on one core and on each set of instructions.
//!
//! Prints a table in Markdown, of those rows alone whose names are given (`-- tour friction`). Times are the processor's, so that other programs disturb them little; both take turns.

use std::time::Instant;

use lyapunov_lab::Scene;
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::map::{Grid, Instructions, Run};
use lyapunov_lab::scene::Positive;
use lyapunov_lab::scenes::SCENES;

/// The least time of a measurement, s: a clock of the processor's time counts hundredths.
const LEAST: f64 = 0.3;

/// Measurements of each, of which the smallest counts.
const ROUNDS: usize = 3;

/// The processor's time of this program, s; where the system does not tell it, the time that passed since `start`.
fn seconds(start: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/self/stat").ok().and_then(|text| {
        let fields: Vec<&str> = text.rsplit(')').next()?.split_whitespace().collect();
        let ticks = |index: usize| fields.get(index)?.parse::<f64>().ok();
        Some((ticks(11)? + ticks(12)?) / 100.0)
    });
    told.unwrap_or_else(|| start.elapsed().as_secs_f64())
}

/// A shipped scene of one dimension over two seconds at most.
fn scene(name: &str) -> Option<Scene> {
    let path = format!(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/{}.toml"), name);
    let mut draft = Scene::load(path.as_ref()).expect("a shipped scene").to_draft();
    draft.duration = Positive::new(draft.duration.get().min(2.0)).expect("a duration");
    (draft.dimensions() == 1).then(|| draft.check().expect("a shorter scene"))
}

fn grid(scene: Scene, members: &[&str]) -> Grid {
    let x = "device.mass=0.1..0.4:8".parse().expect("an axis");
    let y = "initial.velocity=-0.02..0.02:4".parse().expect("an axis");
    let members = members.iter().map(|name| name.parse::<StabilizerName>().expect("a name"));
    Grid::new(scene, x, y, members).expect("a grid")
}

/// The time of `run`, s.
fn time(run: &Run<'_>, cells: u64, start: Instant) -> f64 {
    let (began, mut count) = (seconds(start), 0);
    loop {
        run.cells(0..cells, &|| true, &mut |_, _| Ok(())).expect("a map");
        count += 1;
        let taken = seconds(start) - began;
        if taken >= LEAST {
            return taken / f64::from(count);
        }
    }
}

/// Whether a row of that name was asked for.
fn asked(name: &str) -> bool {
    let mut names = std::env::args().skip(1).filter(|given| given != "--bench").peekable();
    names.peek().is_none() || names.any(|given| given == name)
}

fn row(name: &str, grid: &Grid, start: Instant) {
    if !asked(name) {
        return;
    }
    let alone = Run::one_by_one(grid, Some(1)).expect("a run");
    let lanes = |set| Run::on_boxes(grid, set, Some(1)).expect("a run");
    let lanes: Vec<Run<'_>> = Instructions::all().into_iter().map(lanes).collect();
    let mut least = vec![f64::INFINITY; 1 + lanes.len()];
    for _ in 0..ROUNDS {
        for (least, run) in least.iter_mut().zip([&alone].into_iter().chain(&lanes)) {
            *least = least.min(time(run, grid.cells(), start));
        }
    }
    let steps = 32.0 * grid.stabilizers.iter().len() as f64 * (grid.scene.ticks() + 1) as f64;
    let gains: Vec<String> =
        least[1..].iter().map(|lanes| format!("{:.1}", least[0] / lanes)).collect();
    println!("| {name} | {:.0} | {} |", 1e9 * least[0] / steps, gains.join(" | "));
}

fn main() {
    let start = Instant::now();
    let sets: Vec<&str> = Instructions::all().into_iter().map(Instructions::name).collect();
    println!("| scene | ns a tick, one by one | {} |", sets.join(" | "));
    println!("|---|---|{}", "---|".repeat(sets.len()));
    for shipped in SCENES {
        if let Some(scene) = scene(shipped.name) {
            row(shipped.name, &grid(scene, &["none", "popc", "lolc"]), start);
        }
    }
    let tour = scene("tour").map(|scene| scene.to_draft());
    if let Some(mut draft) = tour {
        draft.effects.friction = None;
        let scene = draft.clone().check().expect("a scene");
        row("tour without friction", &grid(scene, &["none", "popc", "lolc"]), start);
        draft.effects.jitter = None;
        let scene = draft.check().expect("a scene");
        row("tour without friction and jitter", &grid(scene, &["none", "popc", "lolc"]), start);
    }
    for member in StabilizerName::ALL {
        if let Some(scene) = scene("press-1khz") {
            row(&format!("press-1khz, {member}"), &grid(scene, &[member.name()]), start);
        }
    }
}
