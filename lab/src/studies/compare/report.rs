//! Report page of comparisons on scenes, and their rows.

use maud::{Markup, html};

use super::table::{Setting, equal_names, remarks, tables};
use super::{Broken, Column, Comparison, Score};
use crate::show::beside::{beside, unfit};
use crate::show::csv::{self, Field};
use crate::show::described::EVERY_NUMBER;
use crate::show::html;
use lyapunov_figures::Figure;

/// The page of `comparisons`, each with its figures and their captions, as HTML; `command` made it, and `left_out` has
/// the files that did not fit, with the reasons.
pub fn report(
    comparisons: &[(&Comparison, Vec<(&Figure, &str)>)],
    left_out: &[String],
    command: &str,
) -> String {
    let all: Vec<Comparison> = comparisons.iter().map(|(one, _)| (*one).clone()).collect();
    let broken = Broken::of(&all);
    let body = html! {
        p { "By " (html::maker(command)) ". A " code { "-" } " stands where a column does not apply." }
        (unfit(left_out))
        @if comparisons.len() > 1 {
            ul {
                @for (index, (one, _)) in comparisons.iter().enumerate() {
                    li { a href=(format!("#scene-{index}")) { (one.name) } ": " (Setting(&one.scene).to_string()) }
                }
            }
        }
        @for (index, (one, figures)) in comparisons.iter().enumerate() {
            (section(index, one, figures))
        }
        @if comparisons.len() > 1 && !broken.is_empty() {
            h2 { "All scenes" }
            (broken.table().to_html("short"))
        }
        (beside(&[("compare.csv", "a row for each scene and stabilizer"), ("compare.json", "the same, and the settings")]))
    };
    let title = match comparisons {
        [(one, _)] => format!("Stabilizers on {}", one.name),
        many => format!("Stabilizers on {} scenes", many.len()),
    };
    html::page(&title, &body)
}

fn section(index: usize, comparison: &Comparison, figures: &[(&Figure, &str)]) -> Markup {
    let equal = equal_names(comparison);
    html! {
        h2 id=(format!("scene-{index}")) { (comparison.name) }
        p {
            (Setting(&comparison.scene).to_string()) ". POPC and LOLC: " (comparison.settings.to_string()) "."
        }
        @for remark in remarks(comparison) { p { (remark) } }
        @if !equal.is_empty() {
            p { "Equal in every number and every curve as they are shown, and shown once, each name with the median ns of a step:" }
            ul { @for names in &equal { li { (names) } } }
        }
        @for table in tables(comparison) { (table.to_html("short")) }
        @for (figure, caption) in figures { (html::figure(None, figure, &html! { (caption) })) }
        h3 { "Scene" }
        p { (EVERY_NUMBER) ". Each row has its own stabilizer in place of the scene's." }
        pre { (toml::to_string(&comparison.scene).unwrap_or_default()) }
    }
}

/// A row for each scene and entrant, with the columns of `compare.json`, as comma-separated values.
pub fn csv(comparisons: &[Comparison]) -> String {
    let rows = comparisons.iter().flat_map(|comparison| {
        comparison.scores().map(|score| {
            let cells = Column::ALL.map(|column| field(column, score));
            std::iter::once(Field::Text(&comparison.name)).chain(cells)
        })
    });
    csv::text(std::iter::once("scene").chain(Column::ALL.map(Column::key)), rows)
}

/// A column of a row.
pub(crate) fn field(column: Column, score: &Score) -> Field<'_> {
    match column {
        Column::Stabilizer => Field::Text(&score.stabilizer),
        Column::Verdict => Field::Text(score.verdict.word()),
        Column::JudgedBy => score.judged_by.map_or(Field::Nothing, |it| Field::Text(it.word())),
        Column::BrokeIt => score
            .broke_it
            .map_or(Field::Nothing, |it| Field::Text(if it { "true" } else { "false" })),
        Column::StateBytes => Field::Count(score.state_bytes),
        _ => column.value(score).into(),
    }
}
