//! The report page of the paper: one self-contained file.

use maud::{Markup, PreEscaped, html};

use super::Case;
use super::claims::{Verdict, number};
use super::figures::NamedFigure;
use super::study::Study;
use crate::show::html;
use crate::show::table::{Cell, Heading, Table};

/// The parts of the page.
pub(super) struct Report<'a> {
    pub(super) study: &'a Study,
    pub(super) figures: &'a [NamedFigure],
    /// The command that made the page.
    pub(super) command: &'a str,
}

impl Report<'_> {
    /// The page, as HTML.
    pub(super) fn to_html(&self) -> String {
        let body = html! {
            p {
                "Section IV of " cite { "Lyapunov Observer/Controller for Stable Haptic Interaction" }
                " (Jafari, Etoundi, Chong), computed by " (html::maker(self.command)) "."
            }
            h2 { "Claims" }
            (self.claims().to_html(""))
            h2 { "Figures" }
            @for drawn in self.figures { (self.figure(drawn)) }
            h2 { "Where the energy went" }
            p {
                "Millijoules over 30 s from the paper's start. A negative wall is energy that the sampled loop generated; \
                 the last column is what the causes leave unexplained."
            }
            (self.balances().to_html("short"))
            h2 { "How the verdicts move with what the paper leaves open" }
            p {
                "Starts for which a claim holds, of 101, in the colour of the verdict. A cap of 0.5, everything at \
                 100 Hz, is the reading above; one thing is changed at a time. The wall stays at 100 Hz."
            }
            (self.verdicts().to_html("counts"))
            h2 { "How the ensembles move with it" }
            (self.readings().to_html("short"))
            (PreEscaped(DEFINITIONS))
            (self.scenes())
        };
        html::page("The paper, claim by claim", &body)
    }

    fn claims(&self) -> Table {
        let headings = [
            Heading::word("the paper says"),
            Heading::word("what was looked at"),
            Heading::number("median"),
            Heading::number("held"),
            Heading::word("verdict"),
        ];
        Table::new(headings).with_rows(self.study.claims.iter().map(|claim| {
            let (class, verdict) = told(claim.verdict);
            [
                html! { span id=(claim.id) { (claim.paper) } }.into(),
                claim.reading.into(),
                claim.measured().into(),
                format!("{} of {}", claim.held, claim.of).into(),
                html::verdict(class, verdict).into(),
            ]
        }))
    }

    fn figure(&self, (name, figure, cases): &NamedFigure) -> Markup {
        let caption = html! {
            "Drawn by " (html::maker(self.command)) ", from"
            @for (index, case) in cases.iter().map(|case| case.name()).enumerate() {
                @if index > 0 { " and" }
                " " a href={ "#" (case) } { "scenes/" (case) ".toml" }
                " (rows: " a href={ (case) ".csv" } { (case) ".csv" } ")"
            }
            "."
        };
        html::figure(Some(name), figure.to_svg(), &caption)
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

    fn verdicts(&self) -> Table {
        let readings = self.study.moved.iter().map(|moved| Heading::number(moved.name.as_str()));
        let headings = std::iter::once(Heading::word("the paper says")).chain(readings);
        let claims = self.study.moved.iter().take(1).flat_map(|moved| &moved.claims).enumerate();
        Table::new(headings).with_rows(claims.map(|(index, claim)| {
            let moved = self.study.moved.iter().filter_map(move |moved| moved.claims.get(index));
            let counts = moved.map(|claim| {
                let (class, verdict) = told(claim.verdict);
                html! { span class=(class) title=(verdict) { (claim.held) } }.into()
            });
            std::iter::once(Cell::from(claim.paper)).chain(counts)
        }))
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
            let numbers = parts.map(|joules| Cell::from(number(1e3 * joules)));
            std::iter::once(Cell::from(*name)).chain(numbers)
        }))
    }

    fn readings(&self) -> Table {
        let words = ["wall", "stabilizer", "reading"].map(Heading::word);
        let numbers = [
            "bounded",
            "settled",
            "median settling time, s",
            "ticks active",
            "taken by the controller, mJ",
        ];
        let headings = words.into_iter().chain(numbers.map(Heading::number));
        Table::new(headings).with_rows(self.study.readings.iter().map(|reading| {
            let percent = |share: f64| Cell::from(format!("{:.0} %", 100.0 * share));
            [
                format!("{} kN/m", 1e-3 * reading.setting.stiffness).into(),
                format!("{:?}", reading.setting.control).to_uppercase().into(),
                reading.name.as_str().into(),
                percent(reading.bounded),
                percent(reading.settled),
                reading.settling_time.map_or("\u{2013}".to_owned(), number).into(),
                percent(reading.active),
                number(1e3 * reading.taken).into(),
            ]
        }))
    }
}

const DEFINITIONS: &str = include_str!("definitions.html");

/// CSS class of a verdict, and its words.
fn told(verdict: Verdict) -> (&'static str, &'static str) {
    match verdict {
        Verdict::Reproduced => ("yes", "reproduced"),
        Verdict::NotReproduced => ("no", "not reproduced"),
        Verdict::Undecided => ("open", "undecided"),
    }
}
