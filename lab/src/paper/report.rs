//! The report page of the paper: one file that needs nothing else.

use std::fmt::Write;

use super::Case;
use super::claims::{Verdict, number};
use super::figures::Drawn;
use super::study::Study;
use crate::html::{CLOSED, VERSION, escaped, opened};

/// What the page is made of.
pub(super) struct Report<'a> {
    pub(super) study: &'a Study,
    pub(super) figures: &'a [Drawn],
    /// The command that made the page.
    pub(super) command: &'a str,
}

impl Report<'_> {
    /// The page, as HTML.
    pub(super) fn to_html(&self) -> String {
        let mut page = opened("The paper, claim by claim");
        let _ = writeln!(
            page,
            "<p>Section IV of <cite>Lyapunov Observer/Controller for Stable Haptic Interaction</cite> \
             (Jafari, Etoundi, Chong), computed by <code>{}</code>, lyapunov {VERSION}.</p>",
            escaped(self.command)
        );
        self.claims(&mut page);
        self.figures(&mut page);
        self.balances(&mut page);
        self.verdicts(&mut page);
        self.readings(&mut page);
        page.push_str(DEFINITIONS);
        self.scenes(&mut page);
        page.push_str(CLOSED);
        page
    }

    fn claims(&self, page: &mut String) {
        page.push_str(
            "<h2>Claims</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>The paper says</th>\
             <th>What was looked at</th><th class=\"number\">Median</th><th class=\"number\">Held</th>\
             <th>Verdict</th></tr></thead>\n<tbody>\n",
        );
        for claim in &self.study.claims {
            let (class, verdict) = told(claim.verdict);
            let _ = writeln!(
                page,
                "<tr id=\"{}\"><td>{}</td><td>{}</td><td class=\"number\">{}</td>\
                 <td class=\"number\">{} of {}</td><td class=\"{class}\">{verdict}</td></tr>",
                claim.id,
                escaped(claim.paper),
                escaped(claim.reading),
                claim.measured(),
                claim.held,
                claim.of
            );
        }
        page.push_str("</tbody>\n</table></div>\n");
    }

    fn figures(&self, page: &mut String) {
        page.push_str("<h2>Figures</h2>\n");
        for (name, figure, cases) in self.figures {
            let _ = write!(
                page,
                "<figure id=\"{name}\">\n{}\n<figcaption>Drawn by <code>{}</code>, lyapunov {VERSION}, from",
                figure.to_svg(),
                escaped(self.command)
            );
            for (index, case) in cases.iter().enumerate() {
                let (and, case) = (if index == 0 { "" } else { " and" }, case.name());
                let _ = write!(
                    page,
                    "{and} <a href=\"#{case}\">scenes/{case}.toml</a> (rows: <a href=\"{case}.csv\">{case}.csv</a>)"
                );
            }
            page.push_str(".</figcaption>\n</figure>\n");
        }
    }

    /// The scene files of the figures, and how to run them alone.
    fn scenes(&self, page: &mut String) {
        page.push_str("<h2>Scenes</h2>\n");
        let mut cases: Vec<Case> = Vec::new();
        for case in self.figures.iter().flat_map(|(_, _, cases)| *cases) {
            if !cases.contains(case) {
                cases.push(*case);
            }
        }
        for case in cases {
            let (name, text) = (case.name(), escaped(case.text()));
            let _ = writeln!(
                page,
                "<section id=\"{name}\">\n<h3><code>scenes/{name}.toml</code></h3>\n\
                 <p>Alone: <code>lyapunov run scenes/{name}.toml --csv {name}.csv</code></p>\n\
                 <pre>{text}</pre>\n</section>"
            );
        }
    }

    fn verdicts(&self, page: &mut String) {
        page.push_str(
            "<h2>How the verdicts move with what the paper leaves open</h2>\n<p>Starts for which a claim holds, of \
             101, in the colour of the verdict. A cap of 0.5, everything at 100 Hz, is the reading above; one \
             thing is changed at a time. The wall stays at 100 Hz.</p>\n\
             <div class=\"wide\"><table class=\"counts\">\n<thead><tr><th>The paper says</th>",
        );
        for moved in &self.study.moved {
            let _ = write!(page, "<th class=\"number\">{}</th>", escaped(&moved.name));
        }
        page.push_str("</tr></thead>\n<tbody>\n");
        for (index, claim) in self.study.moved.first().iter().flat_map(|it| &it.claims).enumerate()
        {
            let _ = write!(page, "<tr><td>{}</td>", escaped(claim.paper));
            for claim in self.study.moved.iter().filter_map(|moved| moved.claims.get(index)) {
                let (class, verdict) = told(claim.verdict);
                let _ = write!(
                    page,
                    "<td class=\"number\"><span class=\"{class}\" title=\"{verdict}\">{}</span></td>",
                    claim.held
                );
            }
            page.push_str("</tr>\n");
        }
        page.push_str("</tbody>\n</table></div>\n");
    }

    fn balances(&self, page: &mut String) {
        page.push_str(
            "<h2>Where the energy went</h2>\n<p>Millijoules over 30 s from the paper's start. A negative wall is \
             energy that the sampled loop generated; the last column is what the causes leave unexplained.</p>\n\
             <div class=\"wide\"><table class=\"short\">\n<thead><tr><th>Run</th><th class=\"number\">At the start</th>\
             <th class=\"number\">Burnt by operator and device</th><th class=\"number\">Taken by the wall</th>\
             <th class=\"number\">Taken by the controller</th><th class=\"number\">At the end</th>\
             <th class=\"number\">Residual</th></tr></thead>\n<tbody>\n",
        );
        for (name, balance) in &self.study.balances {
            let _ = write!(page, "<tr><td>{name}</td>");
            let parts =
                [balance.start, balance.burnt, balance.wall, balance.controller, balance.end];
            for joules in parts.into_iter().chain([balance.residual()]) {
                let _ = write!(page, "<td class=\"number\">{}</td>", number(1e3 * joules));
            }
            page.push_str("</tr>\n");
        }
        page.push_str("</tbody>\n</table></div>\n");
    }

    fn readings(&self, page: &mut String) {
        page.push_str(
            "<h2>How the ensembles move with it</h2>\n<div class=\"wide\"><table class=\"short\">\n<thead><tr>\
             <th>Wall</th><th>Stabilizer</th><th>Reading</th><th class=\"number\">Bounded</th>\
             <th class=\"number\">Settled</th><th class=\"number\">Median settling time, s</th>\
             <th class=\"number\">Ticks active</th><th class=\"number\">Taken by the controller, mJ</th>\
             </tr></thead>\n<tbody>\n",
        );
        for reading in &self.study.readings {
            let _ = writeln!(
                page,
                "<tr><td>{} kN/m</td><td>{}</td><td>{}</td><td class=\"number\">{:.0} %</td>\
                 <td class=\"number\">{:.0} %</td><td class=\"number\">{}</td>\
                 <td class=\"number\">{:.0} %</td><td class=\"number\">{}</td></tr>",
                1e-3 * reading.setting.stiffness,
                format!("{:?}", reading.setting.control).to_uppercase(),
                escaped(&reading.name),
                100.0 * reading.bounded,
                100.0 * reading.settled,
                reading.settling_time.map_or("–".to_owned(), number),
                100.0 * reading.active,
                number(1e3 * reading.taken)
            );
        }
        page.push_str("</tbody>\n</table></div>\n");
    }
}

const DEFINITIONS: &str = include_str!("definitions.html");

/// The class of a verdict and its words.
fn told(verdict: Verdict) -> (&'static str, &'static str) {
    match verdict {
        Verdict::Reproduced => ("yes", "reproduced"),
        Verdict::NotReproduced => ("no", "not reproduced"),
        Verdict::Undecided => ("open", "undecided"),
    }
}
