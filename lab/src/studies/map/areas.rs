//! What each stabilizer renders stably.

use super::bounds::Bounds;
use super::survey::Survey;
use crate::show::table::{Heading, Table};

/// The table of areas for the terminal, with what they are of.
pub fn areas(survey: &Survey, bounds: Option<&Bounds>) -> String {
    let grid = survey.grid();
    format!("{}\n{}\narea in {}\n\n{}", grid.x, grid.y, survey.unit(), table(survey, bounds))
}

/// Stable cells, of how many, their share, their area, and how stiff over the exact bound; `-` for what is not known.
pub(super) fn table(survey: &Survey, bounds: Option<&Bounds>) -> Table {
    let headings = [
        Heading::word("stabilizer"),
        Heading::number("stable\ncells"),
        Heading::number("of"),
        Heading::number("share"),
        Heading::number("area"),
        Heading::number("of the\nexact bound"),
    ];
    Table::new(headings).with_rows(survey.grid().members.iter().enumerate().map(
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
