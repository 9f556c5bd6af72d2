//! Report page of the study: one self-contained file.

use maud::{Markup, html};

use super::Study;
use super::ledger::TICKS;
use crate::show::html;

impl Study {
    /// The page, as HTML; `command` made it, and `target` is the error that a setting was asked for, m.
    pub fn to_html(&self, command: &str, target: Option<f64>) -> String {
        let caption = "Each point is a step or a tolerance; further to the right is finer.";
        let body = html! {
            p { "By " (html::maker(command)) "." }
            @for sentence in self.sentences() { p { (sentence) } }
            @if let Some(metres) = target { (self.answer(metres)) }
            h2 { "Error against time" }
            (html::figure(Some("accuracy"), &self.figure(), &html! { (caption) }))
            h2 { "Settings" }
            p {
                "The fastest first. The front is marked: no other is as fast and as accurate. A ~ stands before an error \
                 of less than 100 times the references' distance."
            }
            (self.settings().to_html("short"))
            h2 { "The ledger" }
            p {
                "A step of POPC over " (TICKS) " ticks of 1 ms that take 26.7 J, against a sum in double-double. A scene \
                 names its ledger by the key " code { "ledger" } " of its stabilizer's table."
            }
            (self.ledgers().to_html("short"))
        };
        html::page(&format!("What accuracy costs: {}", self.name), &body)
    }

    fn answer(&self, metres: f64) -> Markup {
        let text = self.advice(metres);
        let (first, keys) = text.split_once('\n').unwrap_or((&text, ""));
        html! {
            h2 { "Within " (format!("{metres:e}")) " m" }
            p { (first) }
            pre { (keys) }
        }
    }
}
