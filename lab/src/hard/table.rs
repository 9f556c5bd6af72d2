//! The table in the terminal.

use std::fmt;

use super::{Catalogue, Outcome, Row};

pub(super) fn write(catalogue: &Catalogue, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if let Some(name) = catalogue.stabilizer {
        writeln!(f, "{name} in the place of ours, in f64 and f32\n")?;
    }
    let mut theme = "";
    let [bound, ours] = match catalogue.stabilizer {
        // Of another one a bound may be no promise.
        Some(_) => ["bound", "measured"],
        None => ["promised", "ours"],
    };
    for row in &catalogue.rows {
        if row.theme != theme {
            let gap = if theme.is_empty() { "" } else { "\n" };
            theme = row.theme;
            writeln!(f, "{gap}      {theme:31} {bound:>36} {ours:>11} {:>11}", "naive")?;
        }
        one(row, f)?;
    }
    let passed = catalogue.rows.iter().filter(|row| row.passed).count();
    writeln!(f, "\n{passed} of {} passed", catalogue.rows.len())?;
    match catalogue.rows.iter().filter(|row| row.verdict() == "over").count() {
        0 => Ok(()),
        over => writeln!(f, "over a bound that this stabilizer does not promise: {over} of them"),
    }
}

fn one(row: &Row, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let verdict = row.verdict();
    let bound = format!("{} <= {}", row.quantity, with_unit(row.bound, row.unit));
    let naive = row.naive.as_ref().map_or("-".to_owned(), outcome);
    let ours = number(row.measured);
    writeln!(f, "{verdict}  {:31} {bound:>36} {ours:>11} {naive:>11}", row.case)?;
    writeln!(f, "      {}", row.hard)?;
    if let Some(broken) = &row.broken {
        writeln!(f, "      {broken}")?;
    }
    Ok(())
}

pub(super) fn outcome(outcome: &Outcome) -> String {
    match outcome.not_finite_from {
        Some(tick) => format!("NaN at {tick}"),
        None => number(outcome.measured),
    }
}

pub(super) fn with_unit(value: f64, unit: &str) -> String {
    if unit.is_empty() { number(value) } else { format!("{} {unit}", number(value)) }
}

/// Four digits, in the shorter form.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value.abs()) {
        let digits = (3.0 - value.abs().max(1e-3).log10().floor()).clamp(0.0, 6.0) as usize;
        let text = format!("{value:.digits$}");
        let cut = if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.')
        } else {
            &text
        };
        cut.to_owned()
    } else {
        format!("{value:.2e}")
    }
}
