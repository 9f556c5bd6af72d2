//! The report page of a map: one file that needs nothing else.

use std::fmt::Write;

use super::bounds::Bounds;
use super::picture::Drawn;
use super::survey::Survey;

const VERSION: &str = env!("CARGO_PKG_VERSION");
const STYLE: &str = include_str!("../paper/report.css");

/// The page, as HTML.
pub(super) fn page(
    survey: &Survey,
    bounds: Option<&Bounds>,
    figures: &[Drawn],
    command: &str,
) -> String {
    let grid = survey.grid();
    let mut page =
        String::from("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    page.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    page.push_str("<meta name=\"color-scheme\" content=\"light dark\">\n");
    let title = format!("{} by {}", grid.y.key, grid.x.key);
    let _ = write!(
        page,
        "<title>Map of {title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>Map of {title}</h1>\n\
         <p>{} by {} cells, computed by <code>{}</code>, lyapunov {VERSION}.</p>\n",
        grid.x.count,
        grid.y.count,
        escape(command)
    );
    areas(&mut page, survey, bounds);
    page.push_str("<h2>Heat maps</h2>\n");
    for Drawn { name, words, figure } in figures {
        let _ = write!(
            page,
            "<figure id=\"{name}\">\n{}\n<figcaption>{}. Of cells that are not bounded only the first map tells.\
             </figcaption>\n</figure>\n",
            figure.to_svg(),
            escape(words)
        );
    }
    let scene = toml::to_string(&grid.scene).unwrap_or_default();
    let _ = write!(
        page,
        "<h2>Scene</h2>\n<p>Every number, with its default in place; the two axes stand at the scene's own values. \
         All cells are in <a href=\"map.csv\">map.csv</a>.</p>\n<pre>{}</pre>\n</body>\n</html>\n",
        escape(&scene)
    );
    page
}

fn areas(page: &mut String, survey: &Survey, bounds: Option<&Bounds>) {
    page.push_str(
        "<h2>What is rendered stably</h2>\n<div class=\"wide\"><table class=\"short\">\n<thead><tr><th>Stabilizer</th>\
         <th class=\"number\">Stable cells</th><th class=\"number\">Of</th><th class=\"number\">Share</th>\
         <th class=\"number\">Area</th><th class=\"number\">Of the exact bound</th></tr></thead>\n<tbody>\n",
    );
    for (index, member) in survey.grid().members.iter().enumerate() {
        let area = survey.area(index);
        let over = bounds.and_then(|bounds| bounds.over_exact(survey, index));
        let _ = writeln!(
            page,
            "<tr><td>{member}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>\
             <td class=\"number\">{:.2} %</td><td class=\"number\">{:.5e}</td><td class=\"number\">{}</td></tr>",
            area.stable,
            area.judged,
            100.0 * area.share,
            area.area,
            over.map_or("–".to_owned(), |over| format!("{over:.3}"))
        );
    }
    page.push_str(
        "</tbody>\n</table></div>\n<p>The area is the share of the rectangle of both axes, in their units; a \
         logarithmic axis counts in decades. Of the exact bound: the largest stiffness up to which every cell is stable, over the \
         exact bound of the loop without a stabilizer, the middle one over the values of the other axis at which both are on \
         the map.</p>\n",
    );
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
