//! The tables of docs/teleoperation.md, computed again.

use std::fs;
use std::path::Path;

use lyapunov_lab::teleoperation::Score;
use serde_json::Value;

use crate::teleoperation::shipped::{compared, parsed, scores, text};

/// The file of a heading: one of those that ship, or the first of them with another delay.
fn file(heading: &str) -> String {
    let names: Vec<&str> = heading.split('`').collect();
    let shipped = text(names[1]);
    let Some(delay) = names.get(3) else { return shipped };
    assert!(shipped.contains("delay = 20\n") && delay.starts_with("delay = "), "{heading}");
    shipped.replace("delay = 20", delay)
}

/// The number under `key` in a row of `compare.json`.
fn number(row: &Score, key: &str) -> f64 {
    let row: Value = serde_json::to_value(row).unwrap();
    row[key.trim_matches('`')].as_f64().unwrap_or_else(|| panic!("no number under {key}"))
}

fn cells(line: &str) -> Vec<&str> {
    line.trim_matches('|').split('|').map(str::trim).collect()
}

/// Holds a table, the heading of its file first, against the runs.
fn check(table: &str) {
    let rows = scores(&compared(&parsed(&file(table.lines().next().unwrap()))));
    let mut lines = table.lines().filter(|line| line.starts_with("| "));
    let keys = cells(lines.next().unwrap());
    let bounded: Vec<&str> =
        rows.iter().filter(|row| row.verdict.is_bounded()).map(|row| row.stabilizer).collect();
    let mut names = Vec::new();
    for line in lines {
        let cells = cells(line);
        let name = cells[0].trim_matches('`');
        let row = rows.iter().find(|row| row.stabilizer == name).unwrap();
        for (cell, key) in cells[1..].iter().zip(&keys[1..]) {
            let written: f64 = cell.replace('−', "-").parse().unwrap();
            let digits = cell.split_once('.').map_or(0, |(_, digits)| digits.len());
            let unit = 10.0_f64.powi(-(digits as i32));
            let found = number(row, key);
            assert!((found - written).abs() <= 0.5 * unit + 1e-9, "{key} in {line}\nis {found}");
        }
        names.push(name);
    }
    assert_eq!(names, bounded, "{table}");
}

#[test]
fn the_pages_numbers_are_what_the_runs_give() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/teleoperation.md");
    let page = fs::read_to_string(page).unwrap();
    let (_, numbers) = page.split_once("\n## In numbers\n").unwrap();
    let (numbers, _) = numbers.split_once("\n## ").unwrap();
    let tables: Vec<&str> = numbers.split("\n### ").skip(1).collect();
    tables.iter().for_each(|table| check(table));
    assert_eq!(tables.len(), 5);
}
