//! The table of stable areas, and the self-contained report page of a map.

use maud::html;

use super::bounds::Bounds;
use super::picture::NamedFigure;
use super::survey::Survey;
use crate::show::html;
use crate::show::table::{Heading, Table};

/// The page of a map with its `figures`, as HTML; `command` made the map.
pub fn page(
    survey: &Survey,
    bounds: Option<&Bounds>,
    figures: &[NamedFigure],
    command: &str,
) -> String {
    let grid = survey.grid();
    let scene = toml::to_string(&grid.scene).unwrap_or_default();
    let body = html! {
        p {
            (grid.x.count) " by " (grid.y.count) " cells, computed by " (html::maker(command)) "."
        }
        h2 { "What is rendered stably" }
        (table(survey, bounds).to_html("short"))
        p {
            "The area, in " (survey.unit()) ", is the share of the rectangle of both axes; a logarithmic axis counts in \
             decades. Of the exact bound: the stiffness below the first that is unstable, over the exact bound of the loop \
             without a stabilizer, the middle one over the values of the other axis; >= where it holds up to the edge of \
             the map."
        }
        h2 { "Heat maps" }
        @for NamedFigure { name, words, figure } in figures {
            @let caption = html! {
                (words) ". Of cells that are not bounded only the first map tells."
            };
            (html::figure(Some(name), figure.to_svg(), &caption))
        }
        h2 { "Scene" }
        p {
            "Every number, with its default in place; the two axes stand at the scene's own values. All cells are in "
            a href="map.csv" { "map.csv" } "."
        }
        pre { (scene) }
    };
    html::page(&format!("Map of {} by {}", grid.y.key, grid.x.key), &body)
}

/// Table of areas for the terminal, with the axes and the unit.
pub fn areas(survey: &Survey, bounds: Option<&Bounds>) -> String {
    let grid = survey.grid();
    format!("{}\n{}\narea in {}\n\n{}", grid.x, grid.y, survey.unit(), table(survey, bounds))
}

/// Table of the stable cells, the judged cells, their share, their area, and the stiffness over the exact bound; `-`
/// for an unknown number.
fn table(survey: &Survey, bounds: Option<&Bounds>) -> Table {
    let headings = [
        Heading::word("stabilizer"),
        Heading::number("stable\ncells"),
        Heading::number("of"),
        Heading::number("share"),
        Heading::number("area"),
        Heading::number("of the\nexact bound"),
    ];
    Table::new(headings).with_rows(survey.grid().stabilizers.iter().enumerate().map(
        |(index, member)| {
            let area = survey.area(index);
            let over = bounds.and_then(|bounds| bounds.over_exact(survey, index));
            [
                member.name().into(),
                area.stable.to_string().into(),
                area.judged.to_string().into(),
                area.share.map(|share| format!("{:.2} %", 100.0 * share)).into(),
                area.area.into(),
                over.map(|over| over.to_string()).into(),
            ]
        },
    ))
}
