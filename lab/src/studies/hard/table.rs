//! The table in the terminal.

use std::fmt;

use super::{Catalogue, Outcome};
use crate::show::table::{Heading, Table};
use crate::text::folded;

pub(super) fn write(catalogue: &Catalogue, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if let Some(name) = catalogue.stabilizer {
        writeln!(f, "{name} instead of ours, in f64 and f32\n")?;
    }
    write!(f, "{}", table(catalogue))?;
    let passed = catalogue.rows.iter().filter(|row| row.passed).count();
    writeln!(f, "\n{passed} of {} passed", catalogue.rows.len())?;
    match catalogue.rows.iter().filter(|row| row.verdict() == "over").count() {
        0 => Ok(()),
        over => writeln!(f, "over a bound that this stabilizer does not promise: {over} of them"),
    }
}

fn table(catalogue: &Catalogue) -> Table {
    let [bound, ours] = compared(catalogue);
    let headings = [Heading::word(""), Heading::word("case")];
    let numbers = [bound, ours, "naive"].map(Heading::number);
    let mut table = Table::new(headings.into_iter().chain(numbers));
    let mut theme = "";
    for row in &catalogue.rows {
        if row.theme != theme {
            theme = row.theme;
            table.say(format!("\n{theme}"));
        }
        table.push([
            row.verdict().into(),
            row.case.into(),
            format!("{} <= {}", row.quantity, with_unit(row.bound, row.unit)).into(),
            number(row.measured).into(),
            row.naive.as_ref().map(outcome).into(),
        ]);
        table.say(folded("      ", row.hard));
        row.broken.iter().for_each(|broken| table.say(folded("      ", broken)));
    }
    table
}

/// Headings of the bound and of the measured value.
pub(super) fn compared(catalogue: &Catalogue) -> [&'static str; 2] {
    match catalogue.stabilizer {
        // Another stabilizer may not promise the bound.
        Some(_) => ["bound", "measured"],
        None => ["promised", "ours"],
    }
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

/// A number with four digits, in the shorter form.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_in_the_shorter_form() {
        for (value, shown) in [
            (0.0, "0"),
            (1.0, "1"),
            (-2.5, "-2.5"),
            (0.001_234_6, "0.001235"),
            (123.456, "123.5"),
            (9999.0, "9999"),
            (12_345.0, "1.23e4"),
            (0.000_5, "5.00e-4"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(number(value), shown);
        }
    }
}
