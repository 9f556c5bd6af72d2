//! Report page of a run.

use maud::html;

use super::{Curves, Laid};
use crate::measure::Summary;
use crate::show::beside::beside;
use crate::show::described::EVERY_NUMBER;
use crate::show::html;
use crate::show::labelled::labelled;
use crate::studies::explain::{Hint, NEXT};

impl Curves {
    /// The page of the run of the scene called `name`, with the log that is `laid` over it, as HTML; `command` made it.
    pub fn to_html(
        &self,
        name: &str,
        summary: &Summary,
        laid: Option<&Laid>,
        command: &str,
    ) -> String {
        let scene = toml::to_string(&summary.scene).unwrap_or_default();
        let told = format!("{summary}\n{}", Hint::of(summary));
        // The command to ask next is a sentence of its own.
        let next = told.trim_end().strip_suffix(NEXT);
        let mut files =
            vec![("run.csv", "a row for each servo tick"), ("run.json", "the numbers above")];
        if laid.is_some() {
            files.push(("against.csv", "the differences from the log"));
        }
        let body = html! {
            p { "By " (html::maker(command)) "." }
            (labelled(next.unwrap_or(&told)))
            @if next.is_some() { p { (html::coded(NEXT)) "." } }
            h2 { "What the loop does" }
            (html::figure(Some("run"), &self.figure(name, summary), &html! { (Self::caption(summary)) }))
            @if let Some(laid) = laid { (laid.markup()) }
            (beside(&files))
            h2 { "Scene" }
            p { (EVERY_NUMBER) "." }
            pre { (scene) }
        };
        html::page(&format!("Run of {name}"), &body)
    }
}
