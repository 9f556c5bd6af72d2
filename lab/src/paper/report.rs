//! The report page of the paper: one file that needs nothing else.

use std::fmt::Write;

use super::claims::{Verdict, number};
use super::figures::Drawn;
use super::study::Study;

/// What the page is made of.
pub(super) struct Report<'a> {
    pub(super) study: &'a Study,
    pub(super) figures: &'a [Drawn],
    /// The command that made the page.
    pub(super) command: &'a str,
}

const STYLE: &str = include_str!("report.css");

impl Report<'_> {
    /// The page, as HTML.
    pub(super) fn to_html(&self) -> String {
        let mut page = String::new();
        let version = env!("CARGO_PKG_VERSION");
        page.push_str("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
        page.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
        page.push_str("<meta name=\"color-scheme\" content=\"light dark\">\n");
        let _ = write!(
            page,
            "<title>The paper, claim by claim</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
             <h1>The paper, claim by claim</h1>\n\
             <p>Section IV of <cite>Lyapunov Observer/Controller for Stable Haptic Interaction</cite> \
             (Jafari, Etoundi, Chong), computed by <code>{}</code>, lyapunov {version}.</p>\n",
            escape(self.command)
        );
        self.claims(&mut page);
        self.figures(&mut page);
        self.balances(&mut page);
        self.readings(&mut page);
        page.push_str(DEFINITIONS);
        page.push_str("</body>\n</html>\n");
        page
    }

    fn claims(&self, page: &mut String) {
        page.push_str(
            "<h2>Claims</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>The paper says</th>\
             <th>What was looked at</th><th class=\"number\">Median</th><th class=\"number\">Held</th>\
             <th>Verdict</th></tr></thead>\n<tbody>\n",
        );
        for claim in &self.study.claims {
            let (class, verdict) = match claim.verdict {
                Verdict::Reproduced => ("yes", "reproduced"),
                Verdict::NotReproduced => ("no", "not reproduced"),
                Verdict::Undecided => ("open", "undecided"),
            };
            let _ = writeln!(
                page,
                "<tr id=\"{}\"><td>{}</td><td>{}</td><td class=\"number\">{}</td>\
                 <td class=\"number\">{} of {}</td><td class=\"{class}\">{verdict}</td></tr>",
                claim.id,
                escape(claim.paper),
                escape(claim.reading),
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
            let scenes: Vec<String> = cases
                .iter()
                .map(|case| format!("<code>scenes/{}.toml</code>", case.name()))
                .collect();
            let _ = writeln!(
                page,
                "<figure id=\"{name}\">\n{}\n<figcaption>Scenes: {}. Rows: the CSV files beside this \
                 page.</figcaption>\n</figure>",
                figure.to_svg(),
                scenes.join(", ")
            );
        }
    }

    fn balances(&self, page: &mut String) {
        page.push_str(
            "<h2>Where the energy went</h2>\n<p>Millijoules over 30 s from the paper's start. A negative wall is \
             energy that the sampled loop generated; the last column is what the causes leave unexplained.</p>\n\
             <div class=\"wide\"><table>\n<thead><tr><th>Run</th><th class=\"number\">At the start</th>\
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
            "<h2>How it moves with what the paper leaves open</h2>\n<div class=\"wide\"><table>\n<thead><tr>\
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
                escape(&reading.name),
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

const DEFINITIONS: &str = "<h2>Definitions</h2>\n<ul>\n\
<li>A run is 30 s. The ensemble is 101 starts, evenly within 10 % of −4 mm; the loop at 8 kN/m is chaotic, so a single late \
trace means nothing.</li>\n\
<li>A claim is reproduced where it holds for at least 95 % of the starts, not reproduced where it holds for at most 5 %, and \
undecided in between, or where its number is undefined for most starts.</li>\n\
<li>Bounded: |x| stays within ten times the paper's start. Settled at t: |x| is at most 5 % of the start from t to the \
end.</li>\n\
<li>Swing: the largest |x| after the first contact. Jitter: the RMS velocity over the second after settling.</li>\n\
<li>Impulsive: the largest |ΔL| over the median |ΔL| of active ticks. At 50 kN/m most active ticks come after settling, where \
L no longer changes in double precision: the median is 0 and the number undefined.</li>\n\
<li>Taken by the controller: the work of its held force over the true displacement.</li>\n\
<li>Less conservative: less energy taken while both stay bounded, and more walls of a grid (1 to 50 kN/m, 0 to 100 N·s/m) on \
which the loop stays bounded and settles.</li>\n\
<li>The reading of the paper: operator and device move as one mass, the operator's spring rests at the wall, everything runs at \
100 Hz, held work, a damping cap of half of m / T.</li>\n</ul>\n";

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
