//! Report page of a log.

use maud::html;

use super::Observed;
use crate::show::beside::beside;
use crate::show::csv::{self, Field};
use crate::show::html;
use crate::show::labelled::{labelled, labelled_in_parts};

impl Observed {
    /// The page of the log, as HTML; `command` made it.
    pub fn to_html(&self, command: &str) -> String {
        let lines = self.report.lines();
        // The first line is the heading.
        let (setting, lines) = lines.split_once('\n').unwrap_or((&lines, ""));
        let marked = if self.traces.has_marks() {
            " Below stand the gaps, and the time between the good rows on both sides of bad ones."
        } else {
            ""
        };
        let caption =
            format!("Force, the energy that each of both sums observes, and position.{marked}");
        let mut files =
            vec![("observe.csv", "the contacts"), ("observe.json", "all numbers, in SI units")];
        if self.report.replay.is_some() {
            files.push(("stabilizers.csv", "what each stabilizer would have done"));
        }
        let body = html! {
            p { "By " (html::maker(command)) ". " (setting) "." }
            (labelled_in_parts(lines, "bad rows", &self.report.bad_rows_told()))
            @if let Some(contacts) = self.report.worst_contacts() {
                h2 { "Contacts that generated most" }
                (contacts.to_html("short"))
            }
            h2 { "Over time" }
            (html::figure(Some("observe"), &self.figure(), &html! { (caption) }))
            @if let Some(replay) = &self.report.replay {
                h2 { "What stabilizers would have done" }
                p { (replay.note) }
                (labelled(&replay.lines()))
                (replay.table().to_html("short"))
                @if let Some(figure) = self.would_have() {
                    (html::figure(Some("stabilizers"), &figure, &html! { (replay.caption()) }))
                }
            }
            (beside(&files))
        };
        html::page(&format!("Log {}", self.report.log), &body)
    }

    /// The contacts of the table as comma-separated values, in SI units.
    pub fn csv(&self) -> String {
        let names = ["start", "end", "absorbed", "released", "generated", "peak_force", "damping"];
        let contacts = self.report.contacts.worst.iter().map(|it| {
            let known = [it.start, it.end, it.absorbed, it.released, it.generated, it.peak_force];
            known.map(Field::Number).into_iter().chain([it.damping.into()])
        });
        csv::text(names, contacts)
    }
}
