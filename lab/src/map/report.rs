//! The report page of a map: one file that needs nothing else.

use std::fmt::Write;

use super::areas::cells;
use super::bounds::Bounds;
use super::picture::Drawn;
use super::survey::Survey;
use crate::html::{CLOSED, VERSION, escaped, opened};

/// The page of a map with its `figures`, as HTML; `command` made the map.
pub fn page(survey: &Survey, bounds: Option<&Bounds>, figures: &[Drawn], command: &str) -> String {
    let grid = survey.grid();
    let mut page = opened(&format!("Map of {} by {}", grid.y.key, grid.x.key));
    let _ = writeln!(
        page,
        "<p>{} by {} cells, computed by <code>{}</code>, lyapunov {VERSION}.</p>",
        grid.x.count,
        grid.y.count,
        escaped(command)
    );
    areas(&mut page, survey, bounds);
    page.push_str("<h2>Heat maps</h2>\n");
    for Drawn { name, words, figure } in figures {
        let _ = write!(
            page,
            "<figure id=\"{name}\">\n{}\n<figcaption>{}. Of cells that are not bounded only the first map tells.\
             </figcaption>\n</figure>\n",
            figure.to_svg(),
            escaped(words)
        );
    }
    let scene = toml::to_string(&grid.scene).unwrap_or_default();
    let _ = write!(
        page,
        "<h2>Scene</h2>\n<p>Every number, with its default in place; the two axes stand at the scene's own values. \
         All cells are in <a href=\"map.csv\">map.csv</a>.</p>\n<pre>{}</pre>\n{CLOSED}",
        escaped(&scene)
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
        let _ = write!(page, "<tr><td>{member}</td>");
        for cell in cells(survey, bounds, index) {
            let _ = write!(page, "<td class=\"number\">{}</td>", escaped(&cell));
        }
        page.push_str("</tr>\n");
    }
    let _ = write!(
        page,
        "</tbody>\n</table></div>\n<p>The area, in {}, is the share of the rectangle of both axes; a \
         logarithmic axis counts in decades. Of the exact bound: the stiffness below the first that is unstable, over the \
         exact bound of the loop without a stabilizer, the middle one over the values of the other axis; &gt;= where it holds \
         up to the edge of the map.</p>\n",
        survey.unit()
    );
}
