//! Report page of a sweep.

use maud::html;

use super::Sweep;
use crate::show::beside::beside;
use crate::show::described::EVERY_NUMBER;
use crate::show::html;
use crate::show::verdict::by_speed;
use crate::studies::map::remarks::remarks;

impl Sweep {
    /// The page of the sweep, as HTML; `command` made it.
    pub fn to_html(&self, command: &str) -> String {
        let body = html! {
            p {
                (self.x.count) " values of " code { (self.x.key) } " on " (self.name) ", by " (html::maker(command)) "."
                @if let Some(by) = by_speed(&self.scene) { " The scene is judged " (by) "." }
            }
            @for note in remarks(&self.scene, &[&self.x]) { p { (note) } }
            h2 { "Which runs settle, and which stay bounded" }
            (html::figure(Some("verdicts"), &self.verdicts(), &html! { "The verdict on the run at each value." }))
            (self.counts().to_html("short"))
            (self.stretches().to_html("short"))
            p { "Settles at, bounded at: the stretches of neighbouring values that all settle, and that all settle or swing, the longest first." }
            h2 { "Curves" }
            (html::figure(Some("sweep"), &self.curves(), &html! {
                "Runs that grow are left out; equal curves are drawn once."
            }))
            (beside(&[
                ("sweep.csv", "a row for each value and stabilizer"),
                ("sweep.json", "the same rows"),
            ]))
            h2 { "Rows" }
            details { summary { "All runs" } (self.runs().to_html("short")) }
            h2 { "Scene" }
            p { (EVERY_NUMBER) ". The swept one stands at the scene's own value." }
            pre { (toml::to_string(&self.scene).unwrap_or_default()) }
        };
        html::page(&format!("Sweep of {}", self.x.key), &body)
    }
}
