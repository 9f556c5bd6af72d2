//! The report page of the paper: one self-contained file.

use maud::{Markup, PreEscaped, html};

use super::Case;
use super::claims::{Claim, Judged, RATES, Verdict};
use super::figures::PaperFigure;
use super::study::Study;
use crate::show::html;
use crate::show::table::{Cell, Heading, Table};
use crate::text::found;

/// The parts of the page.
pub(super) struct Report<'a> {
    pub(super) study: &'a Study,
    pub(super) figures: &'a [PaperFigure],
    /// The command that made the page.
    pub(super) command: &'a str,
}

impl Report<'_> {
    /// The page, as HTML.
    pub(super) fn to_html(&self) -> String {
        let count = self.study.draws.count;
        let body = html! {
            p {
                "Judged is this repository's reading of the controller (held work, a limited damping); the controller as \
                 the paper prints it (sampled work, any damping) stands beside it."
            }
            p {
                "Section IV of " cite { "Lyapunov Observer/Controller for Stable Haptic Interaction" }
                " (Jafari, Etoundi, Chong), computed by " (html::maker(self.command)) " over " (count)
                " draws of what the paper does not state."
            }
            h2 { "Claims" }
            (self.verdicts().to_html("counts"))
            h2 { "Numbers" }
            p {
                "Of our controller: the median over the draws that have the number, and the range without the lowest and the \
                 highest 5 %. The last column is a single run, at the paper's numbers and in one phase of the clock."
            }
            (self.numbers().to_html(""))
            h2 { "What moves the claims" }
            p {
                "Main effects on our controller: the share of the variance between draws that a constant explains by itself, \
                 in percent. Those of 5 % and more are named; all others are smaller."
            }
            (self.influences().to_html("counts"))
            h2 { "Runs that settle and runs that grow" }
            p {
                "In percent of the runs, by the observer's rate. The rest is still swinging after 30 s. The last columns are the \
                 median settling times of those that settle, in seconds."
            }
            (self.outcomes().to_html("short"))
            h2 { "Figures" }
            p { "Each curve is a single run, at the paper's numbers and in one phase of the clock." }
            @for drawn in self.figures { (self.figure(drawn)) }
            h2 { "Where the energy went" }
            p {
                "Millijoules of single runs, from the paper's start until the run has settled. A negative wall is energy that \
                 the sampled loop generated; the last column is what the causes leave unexplained."
            }
            (self.balances().to_html("short"))
            (PreEscaped(DEFINITIONS))
            (self.scenes())
        };
        html::page("The paper, claim by claim", &body)
    }

    fn verdicts(&self) -> Table {
        let headings = [
            Heading::word("the paper says"),
            Heading::word("as printed"),
            Heading::number("holds in %\n(95 % interval)"),
            Heading::word("ours"),
            Heading::number("holds in %\n(95 % interval)"),
        ];
        Table::new(headings).with_rows(self.study.claims.iter().map(|claim| {
            [
                html! { span id=(claim.id) { (claim.paper) } }.into(),
                verdict(&claim.printed),
                claim.printed.share().into(),
                verdict(&claim.ours),
                claim.ours.share().into(),
            ]
        }))
    }

    fn numbers(&self) -> Table {
        let headings = [
            Heading::word("the paper says"),
            Heading::word("what was looked at"),
            Heading::number("median"),
            Heading::number("5 % to 95 %"),
            Heading::number("single run"),
        ];
        Table::new(headings).with_rows(self.study.claims.iter().map(|claim| {
            let judged = &claim.ours;
            let range =
                judged.range.map(|[low, high]| format!("{} to {}", found(low), found(high)));
            [
                claim.paper.into(),
                claim.reading.into(),
                with_unit(claim, judged.median).into(),
                range.unwrap_or_else(dash).into(),
                with_unit(claim, judged.single).into(),
            ]
        }))
    }

    fn influences(&self) -> Table {
        let headings = [
            Heading::word("the paper says"),
            Heading::word("moved by"),
            Heading::number("main effect, %"),
            Heading::word("value: holds in %"),
        ];
        let rows = self.study.claims.iter().flat_map(|claim| {
            claim.ours.influences.iter().map(|influence| {
                let groups = influence
                    .groups
                    .iter()
                    .map(|group| format!("{}: {}", group.values, group.percent()));
                let groups = groups.collect::<Vec<_>>().join("; ");
                let effect = format!("{:.0}", 100.0 * influence.effect);
                [claim.paper.into(), influence.constant.into(), effect.into(), groups.into()]
            })
        });
        Table::new(headings).with_rows(rows)
    }

    fn outcomes(&self) -> Table {
        let words = ["wall", "stabilizer"].map(Heading::word);
        let at = |what: &str| RATES.map(|rate| Heading::number(format!("{what}\n{rate} Hz")));
        let headings = words.into_iter().chain(at("settles")).chain(at("grows"));
        let headings = headings.chain(at("median s,"));
        Table::new(headings).with_rows(self.study.outcomes.iter().map(|outcomes| {
            let percent = |count: usize, of: usize| {
                Cell::from(format!("{:.0}", 100.0 * count as f64 / of.max(1) as f64))
            };
            let words = [outcomes.wall.into(), outcomes.stabilizer.into()];
            let settle = outcomes.rates.map(|share| percent(share.settle, share.of));
            let grow = outcomes.rates.map(|share| percent(share.grow, share.of));
            let times = outcomes.rates.map(|share| Cell::from(share.settling_time));
            words.into_iter().chain(settle).chain(grow).chain(times)
        }))
    }

    fn figure(&self, (name, figure, cases): &PaperFigure) -> Markup {
        let caption = html! {
            "Drawn by " (html::maker(self.command)) ", from"
            @for (index, case) in cases.iter().map(|case| case.name()).enumerate() {
                @if index > 0 { " and" }
                " " a href={ "#" (case) } { "scenes/" (case) ".toml" }
                " (rows: " a href={ (case) ".csv" } { (case) ".csv" } ")"
            }
            "."
        };
        html::figure(Some(name), figure, &caption)
    }

    /// The section with the scene files of the figures and the commands to run them alone.
    fn scenes(&self) -> Markup {
        let mut cases: Vec<Case> = Vec::new();
        for case in self.figures.iter().flat_map(|(_, _, cases)| *cases) {
            if !cases.contains(case) {
                cases.push(*case);
            }
        }
        html! {
            h2 { "Scenes" }
            @for (name, text) in cases.into_iter().map(|case| (case.name(), case.text())) {
                section id=(name) {
                    h3 { code { "scenes/" (name) ".toml" } }
                    p { "Alone: " code { "lyapunov run scenes/" (name) ".toml --csv " (name) ".csv" } }
                    pre { (text) }
                }
            }
        }
    }

    fn balances(&self) -> Table {
        let parts = [
            "at the start",
            "burnt by operator and device",
            "taken by the wall",
            "taken by the controller",
            "at the end",
            "residual",
        ];
        let headings = std::iter::once(Heading::word("run")).chain(parts.map(Heading::number));
        Table::new(headings).with_rows(self.study.balances.iter().map(|(name, balance)| {
            let parts = [
                balance.start,
                balance.burnt,
                balance.wall,
                balance.controller,
                balance.end,
                balance.residual(),
            ];
            let numbers = parts.map(|joules| Cell::from(1e3 * joules));
            std::iter::once(Cell::from(*name)).chain(numbers)
        }))
    }
}

const DEFINITIONS: &str = include_str!("definitions.html");

fn dash() -> String {
    "\u{2013}".to_owned()
}

/// A number of a claim with its unit, to four digits; a dash where there is none.
fn with_unit(claim: &Claim, value: Option<f64>) -> String {
    let unit = if claim.unit == "1" { String::new() } else { format!(" {}", claim.unit) };
    value.map_or_else(dash, |value| format!("{}{unit}", found(value)))
}

/// A verdict, its word in its colour.
fn verdict(judged: &Judged) -> Cell {
    let class = match judged.verdict {
        Verdict::Reproduced => "yes",
        Verdict::DependsOn(_) | Verdict::TooFew => "open",
        Verdict::NotReproduced => "no",
    };
    let (words, word) = (judged.verdict.to_string(), judged.verdict.word());
    let rest = words.strip_prefix(word).unwrap_or_default();
    html! { (html::verdict(class, word)) (rest) }.into()
}
