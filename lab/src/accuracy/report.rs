//! The report page: one file that needs nothing else.

use std::fmt::Write;

use super::Study;
use super::ledger::TICKS;
use super::table::duration;
use crate::html::{CLOSED, VERSION, escaped, opened};
use crate::summary::found;

impl Study {
    /// The page, as HTML; `command` is what made it, `target` what a setting was asked for, m.
    pub fn to_html(&self, command: &str, target: Option<f64>) -> String {
        let mut page = opened(&format!("What accuracy costs: {}", self.name));
        let _ = writeln!(page, "<p>By <code>{}</code>, lyapunov {VERSION}.</p>", escaped(command));
        for sentence in self.sentences() {
            let _ = writeln!(page, "<p>{}</p>", escaped(&sentence));
        }
        if let Some(metres) = target {
            self.answer(&mut page, metres);
        }
        let _ = write!(
            page,
            "<h2>Error against time</h2>\n<figure id=\"accuracy\">\n{}\n<figcaption>Each point is a step or a tolerance; \
             further to the right is finer.</figcaption>\n</figure>\n",
            self.figure().to_svg()
        );
        self.settings(&mut page);
        self.ledgers(&mut page);
        page.push_str(CLOSED);
        page
    }

    fn answer(&self, page: &mut String, metres: f64) {
        let _ = write!(page, "<h2>Within {metres:e} m</h2>\n<p>");
        let text = self.advice(metres);
        let (first, keys) = text.split_once('\n').unwrap_or((&text, ""));
        let _ = write!(page, "{}</p>\n<pre>{}</pre>\n", escaped(first), escaped(keys));
    }

    fn settings(&self, page: &mut String) {
        let chaotic = self.basis.growth.chaotic;
        let head = if chaotic { "<th class=\"number\">Believed for</th>" } else { "" };
        let _ = write!(
            page,
            "<h2>Settings</h2>\n<p>The fastest first. The front is marked: no other is as fast and as accurate. \
             A ~ stands before an error of less than 100 times the references' distance.</p>\n\
             <div class=\"wide\"><table class=\"short\">\n<thead><tr><th>Front</th><th class=\"number\">Per simulated \
             second</th><th class=\"number\">Spread</th><th class=\"number\">Largest error</th><th>Propagator</th>\
             <th class=\"number\">Steps, tolerance</th><th>Scalar</th>{head}</tr></thead>\n<tbody>\n"
        );
        for row in &self.rows {
            let front = if row.is_on_front { "<span class=\"yes\">front</span>" } else { "" };
            let horizon = match (chaotic, row.horizon) {
                (false, _) => String::new(),
                (true, None) => "<td class=\"number\">to the end</td>".to_owned(),
                (true, Some(time)) => format!("<td class=\"number\">{} s</td>", found(time)),
            };
            let _ = writeln!(
                page,
                "<tr><td>{front}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>\
                 <td class=\"number\">{}</td><td>{}</td><td class=\"number\">{}</td><td>{}</td>{horizon}</tr>",
                duration(row.time.median),
                duration(row.time.spread),
                row.error(),
                row.setting.integrator.name(),
                row.setting.detail(),
                row.setting.number.name(),
            );
        }
        page.push_str("</tbody>\n</table></div>\n");
    }

    fn ledgers(&self, page: &mut String) {
        let _ = write!(
            page,
            "<h2>The ledger</h2>\n<p>A step of POPC over {TICKS} ticks of 1 ms that take 26.7 J, against a sum in \
             double-double. A scene names its ledger by the key <code>ledger</code> of its stabilizer's table.</p>\n\
             <div class=\"wide\"><table class=\"short\">\n<thead><tr><th>Scalar</th><th>Ledger</th>\
             <th class=\"number\">Error of the sum</th><th class=\"number\">Per tick</th>\
             <th class=\"number\">Spread</th></tr></thead>\n<tbody>\n"
        );
        for row in &self.ledger {
            let _ = writeln!(
                page,
                "<tr><td>{}</td><td>{}</td><td class=\"number\">{:.1e} J</td><td class=\"number\">{}</td>\
                 <td class=\"number\">{}</td></tr>",
                row.scalar,
                row.ledger,
                row.error,
                duration(row.time.median),
                duration(row.time.spread),
            );
        }
        page.push_str("</tbody>\n</table></div>\n");
    }
}
