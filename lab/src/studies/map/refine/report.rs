//! Table and report page of the edges.

use std::fmt;

use maud::html;

use super::Refined;
use crate::show::beside::beside;
use crate::show::described::EVERY_NUMBER;
use crate::show::html;
use crate::show::table::{Heading, Table};
use crate::studies::map::bounds::Bounds;
use crate::studies::map::remarks::remarks;

impl Refined {
    /// The page of the edges, as HTML; `command` made it.
    pub fn to_html(&self, bounds: Option<&Bounds>, command: &str) -> String {
        let grid = self.grid();
        let body = html! {
            p {
                "The edge of bounded runs on " (grid.x.count) " by " (grid.y.count) " cells, by " (html::maker(command)) "."
            }
            @for note in remarks(&grid.scene, &[&grid.x, &grid.y]) { p { (note) } }
            (self.table().to_html("short"))
            p { (MEANING) }
            (html::figure(Some("edge"), &self.figure(bounds), &html! {
                "On which side each cell lies. Of the cells between judged ones, the side of the block around them. Dots: "
                "blocks in which the edge is ragged."
            }))
            (beside(&[
                ("judged.csv", "a row for each judged cell and stabilizer"),
                ("refined.json", "the table"),
            ]))
            h2 { "Scene" }
            p { (EVERY_NUMBER) ". The two axes stand at the scene's own values." }
            pre { (toml::to_string(&grid.scene).unwrap_or_default()) }
        };
        html::page(&format!("Edge over {} and {}", grid.x.key, grid.y.key), &body)
    }

    fn table(&self) -> Table {
        let headings = [
            Heading::word("stabilizer"),
            Heading::number("bounded"),
            Heading::number("edge"),
            Heading::number("judged\ncells"),
            Heading::number("of all"),
            Heading::number("edge\nblocks"),
            Heading::number("ragged"),
            Heading::word("edge\nknown to"),
        ];
        let cells = self.grid().cells() as f64;
        Table::new(headings).with_rows(self.edges().map(|(member, edge)| {
            let (shares, judged) = (edge.shares(), edge.judged().len());
            let known = match edge.unresolved() {
                None => "the cell".to_owned(),
                Some([across, up]) => format!("{across} by {up} cells"),
            };
            [
                member.name().into(),
                percent(shares.sides[0]).into(),
                format!("± {}", percent(0.5 * shares.passed)).into(),
                judged.to_string().into(),
                percent(judged as f64 / cells).into(),
                edge.passed_blocks().to_string().into(),
                edge.ragged_blocks().to_string().into(),
                known.into(),
            ]
        }))
    }
}

const MEANING: &str = "Bounded: the share of the rectangle between the first and last values of both axes, known to within \
                       half of the blocks that the edge passes, but for islands that no judged cell meets. Of the blocks \
                       that the search starts with, the edge passes some; it is ragged in those in which it passes more \
                       neighbouring cells than an edge can that only rises or only falls.";

/// Limit of the table's `±`, for a reader without the page.
const CAVEAT: &str = "The edge is ± half of the blocks that it passes; islands that no judged cell meets are not in it.";

impl fmt::Display for Refined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let grid = self.grid();
        writeln!(f, "{}\n{}", grid.x, grid.y)?;
        for note in remarks(&grid.scene, &[&grid.x, &grid.y]) {
            writeln!(f, "{note}")?;
        }
        write!(f, "\n{}{CAVEAT}\n", self.table())
    }
}

fn percent(share: f64) -> String {
    format!("{:.3} %", 100.0 * share)
}
