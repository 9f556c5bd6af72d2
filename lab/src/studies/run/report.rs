//! Report page of a run.

use maud::html;

use super::Curves;
use crate::measure::Summary;
use crate::show::beside::beside;
use crate::show::html;
use crate::show::labelled::labelled;
use crate::studies::explain::Hint;

impl Curves {
    /// The page of the run of the scene called `name`, as HTML; `command` made it.
    pub fn to_html(&self, name: &str, summary: &Summary, command: &str) -> String {
        let scene = toml::to_string(&summary.scene).unwrap_or_default();
        let lines = format!("{summary}\n{}", Hint::of(summary));
        let body = html! {
            p { "By " (html::maker(command)) "." }
            (labelled(&lines))
            h2 { "What the loop does" }
            (html::figure(Some("run"), &self.figure(name, summary), &html! { (self.caption(summary)) }))
            (beside(&[
                ("run.csv", "a row for each servo tick"),
                ("run.json", "the numbers above"),
            ]))
            h2 { "Scene" }
            p { "Every number, with its default in place." }
            pre { (scene) }
        };
        html::page(&format!("Run of {name}"), &body)
    }
}
