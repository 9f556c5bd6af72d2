//! The report page: one self-contained file.

use maud::{Markup, html};

use super::table::{compared, number, outcome, with_unit};
use super::{Catalogue, Outcome, Row};
use crate::show::html;
use crate::show::table::{Cell, Heading, Table};

pub(super) fn page(catalogue: &Catalogue, command: &str) -> String {
    let passed = catalogue.rows.iter().filter(|row| row.passed).count();
    let body = html! {
        p { (passed) " of " (catalogue.rows.len()) " passed, by " (html::maker(command)) "." }
        p {
            "Each bound is a promise. " (subject(catalogue)) ", \u{201c}naive\u{201d} the paper\u{2019}s steps as printed, \
             in the same loop, \u{201c}none\u{201d} the loop without a stabilizer. A case passes if the bound is kept, \
             every output is finite, every correction is within its limit, the account closes and all kinds of number agree."
        }
        @for rows in catalogue.rows.chunk_by(|one, other| one.theme == other.theme) {
            h2 { (rows[0].theme) }
            (table(catalogue, rows).to_html("cases"))
        }
        h2 { "Scenes" }
        p { "Each can be run alone: " code { "lyapunov run scene.toml" } }
        @for row in &catalogue.rows {
            @if let Some(scene) = &row.scene {
                section id=(anchor(row.case)) {
                    h3 { (row.case) }
                    pre { (scene.trim()) }
                }
            }
        }
    };
    html::page("Hard cases", &body)
}

/// The stabilizer whose numbers the page shows.
fn subject(catalogue: &Catalogue) -> Markup {
    html! {
        @if let Some(name) = catalogue.stabilizer {
            code { (name) } " stands instead of ours; \u{201c}measured\u{201d} is its worst over f64 and f32, \
                             \u{201c}over\u{201d} tells of a bound that it does not promise and does not keep"
        } @else {
            "\u{201c}Ours\u{201d} is the worst over f64, f32 and lanes"
        }
    }
}

/// The table of the cases of one theme.
fn table(catalogue: &Catalogue, rows: &[Row]) -> Table {
    let [bound, ours] = compared(catalogue);
    let words = ["case", bound].map(Heading::word);
    let numbers = [ours, "naive", "none", "account off"].map(Heading::number);
    let headings = words.into_iter().chain(numbers).chain([Heading::word("")]);
    let other = |other: &Option<Outcome>| -> Cell {
        other.as_ref().map_or("\u{2013}".to_owned(), outcome).into()
    };
    Table::new(headings).with_rows(rows.iter().map(|row| {
        let bound = with_unit(row.bound, row.unit).replace(' ', "\u{a0}");
        let class = if row.passed { "yes" } else { "no" };
        [
            case(row).into(),
            format!("{} \u{2264}\u{a0}{bound}", row.quantity).into(),
            number(row.measured).into(),
            other(&row.naive),
            other(&row.without),
            number(row.ledger_off).into(),
            html::verdict(class, row.verdict()).into(),
        ]
    }))
}

/// The cell of a case: its name, its difficulty and its notes.
fn case(row: &Row) -> Markup {
    html! {
        strong {
            @if row.scene.is_some() { a href={ "#" (anchor(row.case)) } { (row.case) } }
            @else { (row.case) }
        }
        br;
        (row.hard)
        @for note in row.apart.into_iter().chain(row.broken.as_deref()) { br; em { (note) } }
    }
}

fn anchor(name: &str) -> String {
    name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect()
}
