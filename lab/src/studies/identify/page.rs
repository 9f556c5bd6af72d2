//! Report page of a fit.

use maud::html;

use super::Identified;
use crate::show::beside::beside;
use crate::show::csv::{self, Field};
use crate::show::html;
use crate::show::json;
use crate::show::labelled::labelled_in_parts;

impl Identified {
    /// The page of the fit, as HTML; `command` made it.
    pub fn to_html(&self, command: &str) -> String {
        let lines = self.report.lines();
        // The first line is the heading.
        let (setting, lines) = lines.split_once('\n').unwrap_or((&lines, ""));
        let caption = "Log and run of the fitted scene; what the model leaves of the position under the log's own force; the force \
                       over the position, with the wall at rest.";
        let body = html! {
            p { "By " (html::maker(command)) ". " (setting) "." }
            (labelled_in_parts(lines, "bad rows", &self.report.bad_rows_told()))
            h2 { "Numbers" }
            (self.report.table().to_html("short"))
            h2 { "Log and model" }
            (html::figure(Some("identify"), &self.figure(), &html! { (caption) }))
            (beside(&[
                ("identify.toml", "the scene"),
                ("identify.csv", "the numbers with their intervals"),
                ("identify.json", "all of it, in SI units"),
            ]))
            h2 { "Scene" }
            pre { (self.scene) }
        };
        html::page(&format!("Scene of {}", self.report.log), &body)
    }

    /// The numbers with their intervals as comma-separated values, in SI units, by key of the scene.
    pub fn csv(&self) -> String {
        let rows = self.report.named().into_iter().map(|(key, _, unit, it)| {
            let [value, low, high] = [it.value, it.low, it.high].map(Field::Number);
            [Field::Text(key), value, low, high, Field::Text(unit)]
        });
        csv::text(["key", "value", "low", "high", "unit"], rows)
    }

    /// Report and scene as JSON.
    pub fn to_json(&self) -> String {
        let mut value = serde_json::to_value(&self.report).unwrap_or_default();
        value["scene"] = self.scene.as_str().into();
        json::text(&value)
    }
}
