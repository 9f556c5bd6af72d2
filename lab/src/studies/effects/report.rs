//! Report page of the costs.

use maud::html;

use super::Costs;
use super::table::{prices, table};
use crate::show::beside::beside;
use crate::show::csv::{self, Field};
use crate::show::html;

impl Costs {
    /// The page, as HTML; `command` made it.
    pub fn to_html(&self, command: &str) -> String {
        let names_none = self.scalars.iter().all(|column| column.effects.is_empty());
        let title = match &self.scene {
            Some(scene) => format!("What the effects of {scene} cost"),
            None => "What each effect costs".to_owned(),
        };
        let body = html! {
            p { "By " (html::maker(command)) ", on the machine it ran on. " (self.note()) "." }
            @if names_none {
                p { "The scene names no effect." }
            } @else {
                (html::figure(Some("effects"), &self.figure(), &html! {
                    "Logarithmic; a cost within its spread, or below 0 where a step is faster with the effect, has no dot."
                }))
            }
            h2 { "Price list" }
            (prices(self).to_html("short"))
            @for column in &self.scalars {
                h2 { (column.bare()) }
                @if !column.effects.is_empty() { (table(column).to_html("short")) }
            }
            (beside(&[("effects.csv", "the rows"), ("effects.json", "all numbers")]))
        };
        html::page(&title, &body)
    }

    /// The rows as comma-separated values, in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let rows = self.scalars.iter().flat_map(|column| {
            column.effects.iter().map(|cost| {
                let costs = [cost.alone, cost.composed];
                let numbers = costs.map(|it| [it.ns_per_step, it.spread_ns, it.ratio]);
                let words = [column.scalar, cost.effect].map(Field::Text);
                words.into_iter().chain(numbers.into_iter().flatten().map(Field::Number))
            })
        });
        let names = [
            "scalar",
            "effect",
            "alone_ns_per_step",
            "alone_spread_ns",
            "alone_ratio",
            "composed_ns_per_step",
            "composed_spread_ns",
            "composed_ratio",
        ];
        csv::text(names, rows)
    }
}
