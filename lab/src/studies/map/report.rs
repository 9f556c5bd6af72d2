//! The table of areas by verdict, and the self-contained report page of a map.

use maud::{Markup, html};
use serde_json::json;

use super::axis::Axis;
use super::picture::{NamedFigure, label, middle};
use super::remarks::remarks;
use super::survey::Survey;
use crate::measure::Verdict;
use crate::show::described::EVERY_NUMBER;
use crate::show::html;
use crate::show::table::{Heading, Table};
use crate::show::verdict::by_speed;
use crate::studies::explain::in_balance;
use crate::text::shell_word;

/// The page of a map with its `figures`, as HTML; `command` made the map of the file `scene`.
pub fn page(survey: &Survey, figures: &[NamedFigure], command: &str, scene: &str) -> String {
    let grid = survey.grid();
    let text = toml::to_string(&grid.scene).unwrap_or_default();
    let body = html! {
        p {
            (grid.x.count) " by " (grid.y.count) " cells, computed by " (html::maker(command)) "."
        }
        @for note in notes(survey) { p { (note) } }
        h2 { "Which runs settle, and which stay bounded" }
        p { "Rows: " (ORDER) "." }
        (table(survey).to_html("short"))
        p {
            "Bounded are the cells whose run settles or is swinging; an area, in " (survey.unit()) ", is the share of its \
             cells of the rectangle of both axes, where a logarithmic axis counts in decades."
        }
        (rendered(survey).to_html("short"))
        p {
            "Means of force and stiffness felt, and the largest energies given, over the measured cells. Broken cells are \
             bounded without a stabilizer and grow under this one. A law that adds no damping is judged by energy and force: \
             it may bound a swing without ending it."
        }
        h2 { "Heat maps" }
        @for NamedFigure { name, words, figure } in figures {
            @let caption = html! {
                (words) ". Of runs that grow only the first map tells."
            };
            (html::figure(Some(name), figure, &caption))
        }
        h2 { "Scene" }
        p {
            (EVERY_NUMBER) ". The two axes stand at the scene's own values. All cells are in "
            a href="map.csv" { "map.csv" } "."
        }
        pre { (text) }
        (axes(survey, scene))
    };
    html::page(&format!("Map of {} by {}", grid.y.key, grid.x.key), &body)
}

/// The values of the axes, and the command to which a cell's own values are added.
fn axes(survey: &Survey, scene: &str) -> Markup {
    let grid = survey.grid();
    let size = survey.size();
    let [columns, rows] = [size.0, size.1].map(|count| count as u64);
    let of = |axis: &Axis, elements: u64| {
        let value = |element| axis.value(middle(axis, element, elements));
        let values: Vec<_> = (0..elements).map(|at| format!("{:?}", value(at))).collect();
        json!({ "key": axis.key, "name": label(axis), "values": values })
    };
    let several = columns != grid.x.count || rows != grid.y.count;
    // Else it would be taken for an option.
    let path = if scene.starts_with('-') { format!("./{scene}") } else { scene.to_owned() };
    let command = format!("lyapunov map {}", shell_word(&path));
    html::values(
        "axes",
        &json!({
            "x": of(&grid.x, columns),
            "y": of(&grid.y, rows),
            "command": command,
            "several": several,
        }),
    )
}

/// Tables of areas and of what is rendered, for the terminal, with the axes and the unit.
pub fn areas(survey: &Survey) -> String {
    let grid = survey.grid();
    let notes: String = notes(survey).iter().map(|note| format!("{note}\n")).collect();
    let (area, rendered) = (table(survey), rendered(survey));
    format!(
        "{}\n{}\narea in {}\n{notes}{ORDER}\n\n{area}\n{rendered}",
        grid.x,
        grid.y,
        survey.unit()
    )
}

/// The order of the rows, in words.
const ORDER: &str =
    "the most rendered first: a bounded cell counts by the share of the force that is felt";

/// Remarks that the verdicts need.
fn notes(survey: &Survey) -> Vec<String> {
    let all = survey.grid().cells();
    let stabilizers = 0..survey.grid().stabilizers.len();
    let short = stabilizers.map(|index| survey.cells(index, Verdict::TooShort)).max().unwrap_or(0);
    let told =
        |cells: u64, what: &str| (cells > 0).then(|| format!("{cells} of {all} cells {what}"));
    let by_speed = match by_speed(&survey.grid().scene) {
        Some(by) if survey.by_speed() == all => Some(format!("judged {by}")),
        _ => told(survey.by_speed(), "are judged by speed: they have no place to rest at"),
    };
    let calm = survey.undisturbed();
    let calm = (calm > 0).then(|| in_balance(&format!("in {calm} of {all} cells each run"), ""));
    let sign = survey.look_at().map(|it| format!("look at: {}", it.text));
    let grid = survey.grid();
    let first = [by_speed, calm, told(short, "are too short to judge")].into_iter().flatten();
    first.chain(remarks(&grid.scene, &[&grid.x, &grid.y])).chain(sign).collect()
}

/// Table of the shares that settle and that stay bounded, the judged cells, the areas of both, and what is rendered; `-` for an
/// unknown number. A force limit bounds every run, and the bounded area is the same for all then.
fn table(survey: &Survey) -> Table {
    let headings = [
        Heading::word("stabilizer"),
        Heading::number("settles"),
        Heading::number("bounded"),
        Heading::number("bounded\ncells"),
        Heading::number("of"),
        Heading::number("settled\narea"),
        Heading::number("bounded\narea"),
        Heading::number("rendered"),
    ];
    Table::new(headings).with_rows(survey.ranking().into_iter().map(|index| {
        let (settling, bounded) = (survey.settling(index), survey.bounded(index));
        // Where nothing has a place to rest at, a share of 0 would blame the stabilizer.
        let can_settle = settling.cells > 0 || survey.by_speed() < survey.grid().cells();
        let settled = Some(settling).filter(|_| can_settle);
        [
            survey.grid().stabilizers[index].name().into(),
            settled.and_then(|it| it.share).map(|share| percent(100.0 * share)).into(),
            bounded.share.map(|share| percent(100.0 * share)).into(),
            bounded.cells.to_string().into(),
            survey.judged(index).to_string().into(),
            settled.and_then(|it| it.area).into(),
            bounded.area.into(),
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
