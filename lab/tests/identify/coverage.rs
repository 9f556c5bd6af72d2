//! Share of logs in which the 95 % interval of each number holds the truth.

use lyapunov_lab::identify::{Estimate, Report, Settings, identify};
use rayon::prelude::*;

use super::loops::{Chance, PLAIN, Truth};

/// Logs of each kind, and their rows.
const LOGS: u64 = 60;
const ROWS: usize = 800;

/// What a log may suffer.
const KINDS: [Truth; 4] = [
    Truth { encoder: 1e-5, ..PLAIN },
    Truth { encoder: 1e-4, ..PLAIN },
    Truth { noise: 5e-6, late: 2, ..PLAIN },
    Truth { blur: 2e-6, ..PLAIN },
];

const NAMES: [&str; 7] =
    ["mass", "damping", "stiffness", "rest", "wall", "wall's stiffness", "wall's damping"];

/// Each number of a report with its truth; where no spring is told, the constant force with that of the spring.
fn numbers(report: &Report, truth: &Truth) -> [(Estimate, f64); 7] {
    let wall = report.wall.unwrap();
    let [place, stiffness, damping] = truth.wall;
    let rest = match report.rest {
        Some(rest) => (rest, truth.rest),
        None => (report.load, truth.stiffness * truth.rest),
    };
    [
        (report.mass, truth.mass),
        (report.damping, truth.damping),
        (report.stiffness, truth.stiffness),
        rest,
        (wall.position, place),
        (wall.stiffness, stiffness),
        (wall.damping, damping),
    ]
}

fn held(truth: Truth, seed: u64) -> [bool; 7] {
    let mut chance = Chance::new(seed);
    let truth = truth.varied(&mut chance);
    let log = truth.log(ROWS, &mut chance);
    let found = identify(log.as_bytes(), "log", &Settings::default()).unwrap();
    numbers(&found.report, &truth).map(|(told, truth)| (told.low..=told.high).contains(&truth))
}

/// Three standard deviations of a share about 95 % are the margin. The wall's numbers are exact where the log holds what the
/// wall saw, as in all kinds but the last, so they may be held more often.
#[test]
fn intervals_hold_the_truth_in_about_95_of_100_logs() {
    let mut all = [0_u64; 7];
    for (kind, truth) in KINDS.into_iter().enumerate() {
        let seeds = (0..LOGS).into_par_iter().map(|log| 1 + log + 1000 * kind as u64);
        let held: Vec<_> = seeds.map(|seed| held(truth, seed)).collect();
        let counts: [u64; 7] =
            std::array::from_fn(|it| held.iter().filter(|held| held[it]).count() as u64);
        println!("kind {kind}: {counts:?} of {LOGS}");
        all = std::array::from_fn(|it| all[it] + counts[it]);
    }
    let logs = (LOGS * KINDS.len() as u64) as f64;
    let margin = 3.0 * (0.95 * 0.05 / logs).sqrt();
    for (name, count) in NAMES.into_iter().zip(all) {
        let share = count as f64 / logs;
        let most = if name.starts_with("wall") { 1.0 } else { 0.95 + margin };
        assert!((0.95 - margin..=most).contains(&share), "{name}: {share}, {all:?}");
    }
}
