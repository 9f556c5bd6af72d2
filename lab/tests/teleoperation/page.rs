//! The table of docs/teleoperation.md, computed again.

use std::fs;
use std::path::Path;

use lyapunov_lab::teleoperation::Score;

use crate::teleoperation::shipped::{compared, parsed, scores, text};

/// The number under `key` in a row.
fn number(row: &Score, key: &str) -> f64 {
    let found = match key {
        "`force_felt_n`" => row.felt,
        "`drift_end_mm`" => row.drift,
        "`shortfall_mj`" => row.shortfall,
        _ => panic!("a key that the test does not know: {key}"),
    };
    found.unwrap()
}

/// The file of a line: one of those that ship, or the first of them with another delay.
fn file(label: &str) -> String {
    match label.strip_prefix("the same, `delay = ") {
        Some(delay) => {
            let delay = format!("delay = {}", delay.trim_end_matches('`'));
            text("constant-delay").replace("delay = 20", &delay)
        }
        None => text(label.trim_matches('`')),
    }
}

#[test]
fn the_pages_numbers_are_what_the_runs_give() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/teleoperation.md");
    let page = fs::read_to_string(page).unwrap();
    let (_, numbers) = page.split_once("\n## In numbers\n").unwrap();
    let (numbers, _) = numbers.split_once("\n## ").unwrap();
    let mut lines = 0;
    for line in numbers.lines().filter(|line| line.starts_with("| ")).skip(1) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let rows = scores(&compared(&parsed(&file(cells[0]))));
        for (cell, row) in cells[2..].iter().zip(&rows[1..]) {
            let written: f64 = cell.replace('−', "-").parse().unwrap();
            let digits = cell.split_once('.').map_or(2, |(_, digits)| digits.len());
            let unit = 10.0_f64.powi(-(digits as i32));
            let found = number(row, cells[1]);
            assert!((found - written).abs() <= 0.5 * unit + 1e-9, "{line}\nfinds {found}");
        }
        lines += 1;
    }
    assert_eq!(lines, 15);
}
