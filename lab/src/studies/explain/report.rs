//! Report page of an explanation.

use maud::{Markup, html};

use super::words::{Heads, Told};
use super::{Explanation, Remedy};
use crate::show::beside::beside;
use crate::show::html;
use crate::show::labelled::labelled;

impl Explanation {
    /// The page of the explanation of the scene called `name`, as HTML; `command` made it.
    pub fn to_html(&self, name: &str, command: &str) -> String {
        let caption = html! {
            "Energy by cause: the upper bar is what came in, the lower one where it went; both are equally long."
        };
        let body = html! {
            p { "By " (html::maker(command)) "." }
            (labelled(&Heads(self).to_string()))
            h2 { "Where the energy came from" }
            @match &self.first_contact {
                Some(first) => {
                    (html::figure(Some("energy"), &self.figure(name), &caption))
                    (self.balances(first).to_html("short"))
                }
                None => p { "No contact: " (self.untouched()) "." }
            }
            h2 { "What helps" }
            (self.help())
            (beside(&[("explain.csv", "the energies"), ("explain.json", "all numbers")]))
            h2 { "Scene" }
            pre { (toml::to_string(&self.scene).unwrap_or_default()) }
        };
        html::page(&format!("Explanation of {name}"), &body)
    }

    fn help(&self) -> Markup {
        let told = |remedy: &Remedy| {
            let text = Told(remedy).to_string();
            let (changes, outcome) = text.split_once('\n').unwrap_or((&text, ""));
            html! { li { code { (changes) } @for line in outcome.lines() { br; (line.trim()) } } }
        };
        match self.lack() {
            Some(mut lack) => {
                if let Some(first) = lack.get_mut(..1) {
                    first.make_ascii_uppercase();
                }
                html! { p { (lack) "." } }
            }
            None => html! {
                p { "Each " (self.tried()) "." }
                ul { @for remedy in &self.remedies { (told(remedy)) } }
            },
        }
    }
}
