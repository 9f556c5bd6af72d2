//! The report page: one file that needs nothing else.

use std::fmt::Write;

use super::table::{number, outcome, with_unit};
use super::{Catalogue, Outcome, Row};
use crate::html::{CLOSED, VERSION, escaped, opened};

pub(super) fn page(catalogue: &Catalogue, command: &str) -> String {
    let passed = catalogue.rows.iter().filter(|row| row.passed).count();
    let subject = match catalogue.stabilizer {
        None => "\u{201c}Ours\u{201d} is the worst over f64, f32 and lanes".to_owned(),
        Some(name) => format!(
            "<code>{name}</code> stands in the place of ours; \u{201c}measured\u{201d} is its worst over f64 and f32, \
             \u{201c}over\u{201d} tells of a bound that it does not promise and does not keep"
        ),
    };
    let [bound, ours] = match catalogue.stabilizer {
        Some(_) => ["Bound", "Measured"],
        None => ["Promised", "Ours"],
    };
    let mut page = opened("Hard cases");
    let _ = write!(
        page,
        "<p>{passed} of {} passed, by <code>{}</code>, lyapunov {VERSION}.</p>\n\
         <p>Each bound is a promise. {subject}, \u{201c}naive\u{201d} the paper\u{2019}s steps as printed, in the same loop, \
         \u{201c}none\u{201d} the loop without a stabilizer. A case passes if the bound is kept, every output is finite, every \
         correction is within its limit, the account closes and all kinds of number agree.</p>\n",
        catalogue.rows.len(),
        escaped(command)
    );
    let mut theme = "";
    for row in &catalogue.rows {
        if row.theme != theme {
            if !theme.is_empty() {
                page.push_str("</tbody>\n</table></div>\n");
            }
            theme = row.theme;
            let _ = write!(
                page,
                "<h2>{theme}</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>Case</th><th>{bound}</th>\
                 <th class=\"number\">{ours}</th><th class=\"number\">Naive</th><th class=\"number\">None</th>\
                 <th class=\"number\">Account off</th><th></th></tr></thead>\n<tbody>\n"
            );
        }
        one(row, &mut page);
    }
    page.push_str("</tbody>\n</table></div>\n");
    scenes(catalogue, &mut page);
    page.push_str(CLOSED);
    page
}

fn one(row: &Row, page: &mut String) {
    let verdict = row.verdict();
    let class = if row.passed { "yes" } else { "no" };
    let other = |other: &Option<Outcome>| other.as_ref().map_or("\u{2013}".to_owned(), outcome);
    let notes = row.apart.into_iter().map(str::to_owned).chain(row.broken.clone());
    let notes: String = notes.map(|note| format!("<br><em>{}</em>", escaped(&note))).collect();
    let name = match &row.scene {
        None => row.case.to_owned(),
        Some(_) => format!("<a href=\"#{}\">{}</a>", anchor(row.case), row.case),
    };
    let _ = writeln!(
        page,
        "<tr><td><strong>{name}</strong><br>{}{notes}</td><td>{} \u{2264}\u{a0}{}</td>\
         <td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>\
         <td class=\"number\">{}</td><td class=\"{class}\">{verdict}</td></tr>",
        escaped(row.hard),
        row.quantity,
        with_unit(row.bound, row.unit).replace(' ', "\u{a0}"),
        number(row.measured),
        other(&row.naive),
        other(&row.without),
        number(row.ledger_off),
    );
}

/// The scenes of the cases that are scenes, to be run alone.
fn scenes(catalogue: &Catalogue, page: &mut String) {
    page.push_str(
        "<h2>Scenes</h2>\n<p>Each can be run alone: <code>lyapunov run scene.toml</code></p>\n",
    );
    for row in &catalogue.rows {
        let Some(scene) = &row.scene else { continue };
        let (anchor, text) = (anchor(row.case), escaped(scene.trim()));
        let _ = writeln!(
            page,
            "<section id=\"{anchor}\">\n<h3>{}</h3>\n<pre>{text}</pre>\n</section>",
            row.case
        );
    }
}

fn anchor(name: &str) -> String {
    name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect()
}
