//! What each stabilizer renders stably, in the terminal.

use std::fmt::Write;

use super::bounds::Bounds;
use super::survey::Survey;
use crate::summary::found;

/// How many columns there are beside the stabilizer's name.
const COLUMNS: usize = 5;

/// The table of areas, with what they are of.
pub fn areas(survey: &Survey, bounds: Option<&Bounds>) -> String {
    let grid = survey.grid();
    let mut text = format!("{}\n{}\narea in {}\n\n", grid.x, grid.y, survey.unit());
    let headings = ["stable", "of cells", "share", "area", "of exact bound"].map(str::to_owned);
    line(&mut text, "stabilizer", &headings);
    for (index, member) in grid.members.iter().enumerate() {
        line(&mut text, member.name(), &cells(survey, bounds, index));
    }
    text
}

fn line(text: &mut String, name: &str, [stable, judged, share, area, over]: &[String; COLUMNS]) {
    let _ =
        writeln!(text, "  {name:24} {stable:>10} {judged:>10} {share:>8}  {area:>12}  {over:>14}");
}

/// Stable cells, of how many, their share, their area, and how stiff over the exact bound; `-` for what is not known.
pub(super) fn cells(survey: &Survey, bounds: Option<&Bounds>, index: usize) -> [String; COLUMNS] {
    let area = survey.area(index);
    let over = bounds.and_then(|bounds| bounds.over_exact(survey, index));
    let or_dash = |told: Option<String>| told.unwrap_or_else(|| "-".to_owned());
    [
        area.stable.to_string(),
        area.judged.to_string(),
        or_dash(area.share.map(|share| format!("{:.2} %", 100.0 * share))),
        or_dash(area.area.map(|area| found(area).to_string())),
        or_dash(over.map(|over| over.to_string())),
    ]
}
