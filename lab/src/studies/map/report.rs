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
        p { "Rows: " (ORDER) "." }
        (table(survey, bounds).to_html("short"))
        p {
            "The area, in " (survey.unit()) ", is the share of the rectangle of both axes; a logarithmic axis counts in \
             decades. Of the exact bound: the stiffness below the first that is unstable, over the exact bound of the loop \
             without a stabilizer, the middle one over the values of the other axis; >= where it holds up to the edge of \
             the map."
        }
        (rendered(survey).to_html("short"))
        p {
            "Means of force and stiffness felt, and the largest energies given, over the measured cells. Broken cells are \
             stable without a stabilizer and not under this one. A law that adds no damping is judged by energy and force: \
             it may bound a swing without ending it."
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

/// Tables of areas and of what is rendered, for the terminal, with the axes and the unit.
pub fn areas(survey: &Survey, bounds: Option<&Bounds>) -> String {
    let grid = survey.grid();
    let (area, rendered) = (table(survey, bounds), rendered(survey));
    format!("{}\n{}\narea in {}\n{ORDER}\n\n{area}\n{rendered}", grid.x, grid.y, survey.unit())
}

/// The order of the rows, in words.
const ORDER: &str =
    "the most rendered first: a stable cell counts by the share of the force that is felt";

/// Table of the stable cells, the judged cells, their share, their area, the stiffness over the exact bound, and what is
/// rendered; `-` for an unknown number.
fn table(survey: &Survey, bounds: Option<&Bounds>) -> Table {
    let headings = [
        Heading::word("stabilizer"),
        Heading::number("stable\ncells"),
        Heading::number("of"),
        Heading::number("share"),
        Heading::number("area"),
        Heading::number("of the\nexact bound"),
        Heading::number("rendered"),
    ];
    Table::new(headings).with_rows(survey.ranking().into_iter().map(|index| {
        let area = survey.area(index);
        let over = bounds.and_then(|bounds| bounds.over_exact(survey, index));
        [
            survey.grid().stabilizers[index].name().into(),
            area.stable.to_string().into(),
            area.judged.to_string().into(),
            area.share.map(|share| percent(100.0 * share)).into(),
            area.area.into(),
            over.map(|over| over.to_string()).into(),
            survey.rendered(index).percent.map(percent).into(),
        ]
    }))
}

/// Table of what is felt, what the port gave, and what is broken.
fn rendered(survey: &Survey) -> Table {
    let headings = [
        Heading::word("stabilizer"),
        Heading::number("force\nfelt"),
        Heading::number("stiffness\nfelt"),
        Heading::number("given\nby port\nmJ"),
        Heading::number("given beyond\nthe damper\nmJ"),
        Heading::number("broken\ncells"),
        Heading::word("judged by"),
    ];
    Table::new(headings).with_rows(survey.ranking().into_iter().map(|index| {
        let (member, it) = (survey.grid().stabilizers[index], survey.rendered(index));
        [
            member.name().into(),
            it.force_felt.map(percent).into(),
            it.stiffness_felt.map(percent).into(),
            it.energy_given.into(),
            it.energy_given_beyond_damper.into(),
            it.broke.map(|cells| cells.to_string()).into(),
            member.judgement().words().into(),
        ]
    }))
}

fn percent(value: f64) -> String {
    format!("{value:.2} %")
}
