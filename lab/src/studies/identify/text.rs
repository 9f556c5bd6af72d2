//! Text of a fit for the terminal.

use std::fmt;

use super::Identified;
use super::estimate::Estimate;
use super::report::{Report, WallReport};
use super::wall::EDGE;
use crate::files::log::described;
use crate::show::table::{Cell, Heading, Table};
use crate::text::{folded, found, legible, prefixed};

/// Causes of a run that does not stay by its log.
const LEAVES: &str = "a loop at the edge of what is stable, a hand that moves, a stabilizer in the recorded one, uneven \
                      steps of t, or an offset or a clipping of f";

/// Error of a run, in residuals of the fit, up to which it is by its log; one with noise that the scene has not reaches 8.
const NEAR: f64 = 10.0;

/// Share of the travel up to which it is as well: the numbers of a scene are rounded, and a loop that grows makes that larger.
const ROUNDING: f64 = 1e-4;

impl fmt::Display for Identified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.report.lines())?;
        writeln!(f, "\n{}", textwrap::indent(&self.report.table().to_string(), "  "))?;
        f.write_str(&self.scene)
    }
}

impl Report {
    /// Lines of a label and a text.
    pub(super) fn lines(&self) -> String {
        let name = legible(&self.log);
        let period = found(1e3 * self.median_period);
        let mut lines = vec![format!(
            "{name}: {} rows over {} s, median period {period} ms",
            self.rows,
            found(self.duration)
        )];
        let mut say = |label: &str, text: &str| lines.push(folded(&format!("  {label:<12}"), text));
        if let Some(told) = described(&self.columns, self.decimal_commas) {
            say("columns", &told);
        }
        for (line, text) in self.bad_rows_told().iter().enumerate() {
            say(if line == 0 { "bad rows" } else { "" }, text);
        }
        let grid = self.resolution.map(|it| {
            let [step, error] = [it, it / 12_f64.sqrt()].map(|it| prefixed(it, "m"));
            format!("; x has steps of {step}, which alone leave about {error}")
        });
        let (whole, grid) = (prefixed(self.residual.whole, "m"), grid.unwrap_or_default());
        say("residual", &format!("{whole} between x and the model under the log's force{grid}"));
        say("run", &self.run());
        if let Some(wall) = &self.wall {
            say("wall", &wall.line());
        }
        self.notes.iter().for_each(|note| say("note", note));
        self.look_at.iter().for_each(|it| say("look at", &it.text));
        lines.push(String::new());
        lines.join("\n")
    }

    /// The lines about bad rows.
    pub(super) fn bad_rows_told(&self) -> Vec<String> {
        self.bad_rows.lines(", left out")
    }

    /// The distance of a run of the scene from the log, with possible causes where it is large.
    fn run(&self) -> String {
        let Some(error) = self.replayed else {
            return format!("a run of the scene below leaves the range of numbers: {LEAVES}");
        };
        let off = prefixed(error, "m");
        let text = format!("a run of the scene below is {off} off the log (root mean square)");
        let near = (NEAR * self.residual.whole).max(ROUNDING * (self.furthest - self.nearest));
        if error <= near { text } else { format!("{text}: {LEAVES}") }
    }

    /// The numbers with their intervals.
    pub(super) fn table(&self) -> Table {
        let headings = [
            Heading::word("number"),
            Heading::number("fitted"),
            Heading::number("from"),
            // What pushes moves the numbers by more than the intervals know.
            Heading::number(if self.residual.is_pushed { "to" } else { "to (95 %)" }),
            Heading::word("unit"),
        ];
        let rows = self.named().into_iter().map(|(_, name, unit, it)| {
            let [value, low, high] = it.words().map(Cell::from);
            [name.into(), value, low, high, unit.into()]
        });
        Table::new(headings).with_rows(rows)
    }

    /// The numbers by key of a scene, with name and unit.
    pub(super) fn named(&self) -> Vec<(&'static str, &'static str, &'static str, Estimate)> {
        let mut named = vec![
            ("device.mass", "mass", "kg", self.mass),
            ("device.damping", "damping", "N.s/m", self.damping),
            ("operator.stiffness", "hand's spring", "N/m", self.stiffness),
        ];
        match self.rest {
            Some(rest) => named.push(("operator.rest", "its rest", "m", rest)),
            None => named.push(("effects.load.force", "load", "N", self.load)),
        }
        if let Some(wall) = self.wall {
            named.extend([
                ("environment.wall.position", "wall at", "m", wall.position),
                ("environment.wall.stiffness", "wall's stiffness", "N/m", wall.stiffness),
                ("environment.wall.damping", "wall's damping", "N.s/m", wall.damping),
            ]);
        }
        named
    }
}

impl WallReport {
    fn line(&self) -> String {
        // Of forces that are exact to rounding.
        let left = if self.residual <= EDGE * self.peak {
            "nothing but rounding".to_owned()
        } else {
            format!("{} of their force", prefixed(self.residual, "N"))
        };
        format!("{} rows in contact; it leaves {left}", self.rows)
    }
}
