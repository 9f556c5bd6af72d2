//! Text of a fit for the terminal.

use std::fmt;

use super::Identified;
use super::estimate::Estimate;
use super::report::Report;
use crate::show::table::{Cell, Heading, Table};
use crate::text::{folded, found, legible};

/// What is said of a run that does not stay by its log.
const LEAVES: &str = "a run of the scene below leaves the log: a loop at the edge of what is stable, a hand that moves, or a \
                      stabilizer in the recorded one";

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
        if self.bad_rows.count > 0 {
            say("bad rows", &format!("{}, left out", self.bad_rows.count));
        }
        let grid = self.resolution.map(|it| {
            let [step, error] = [1e6 * it, 1e6 * it / 12_f64.sqrt()].map(found);
            format!("; x has steps of {step} um, which alone leave about {error} um")
        });
        let (whole, grid) = (found(1e6 * self.residual.whole), grid.unwrap_or_default());
        say("residual", &format!("{whole} um between x and the model under the log's force{grid}"));
        match self.replayed {
            Some(error) if error <= self.furthest - self.nearest => {
                let error = found(1e3 * error);
                let words = "a run of the scene below stays within";
                say("run", &format!("{words} {error} mm of the log (root mean square)"));
            }
            _ => say("run", LEAVES),
        }
        if let Some(wall) = &self.wall {
            let left = found(wall.residual);
            say(
                "wall",
                &format!("{} rows in contact; it leaves {left} N of their force", wall.rows),
            );
        }
        self.notes.iter().for_each(|note| say("note", note));
        self.look_at.iter().for_each(|it| say("look at", &it.text));
        lines.push(String::new());
        lines.join("\n")
    }

    /// The numbers with their intervals.
    pub(super) fn table(&self) -> Table {
        let headings = [
            Heading::word("number"),
            Heading::number("fitted"),
            Heading::number("from"),
            Heading::number("to (95 %)"),
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
