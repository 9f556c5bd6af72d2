//! Comparison of entrants on one teleoperator.

use std::fmt;
use std::ops::ControlFlow;

use super::{document, picture, table};
use crate::files::teleoperation::Teleoperator;
use crate::measure::teleoperation::{Curves, Meter, Outcome, Score};
use crate::show::csv::{self, Field};
use crate::simulate::teleoperation::{Entrant, Tick, rig};
use crate::studies::compare::compared::{BREATH, Compared, RunError, Watch, watched};
use crate::studies::compare::sheet::Sheet;
use crate::text::names::{Named, Names};

/// Entrants on one teleoperator; its `Display` is the table of `lyapunov compare`.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The file's name, usually its path.
    pub name: String,
    /// The teleoperator.
    pub file: Teleoperator,
    pub(super) outcomes: Vec<Outcome>,
}

impl Compared for Comparison {
    type File = Teleoperator;
    type Entrant = Entrant;
    type Score = Score;

    const NOUN: &'static str = "teleoperator";
    const TITLE: &'static str = "Teleoperators over a channel";
    const ABOUT: &'static str = "Stabilizers of a link with delay: none; a passivity controller at each port by itself \
                                 (popc-at-each-end); the two-port passivity controller (two-port-popc), and the \
                                 same taking back its drift (drift-compensated); forces limited by energy tanks \
                                 that the master fills (two-layer); wave variables, before the slave's own damper, \
                                 before one that matches them, and that with wave filters.";

    fn ticks(file: &Teleoperator) -> u64 {
        file.ticks() + 1
    }

    fn of(
        name: &str,
        file: &Teleoperator,
        entrants: &Names<Entrant>,
        watch: &Watch<'_>,
    ) -> Result<Self, RunError> {
        let run = |entrant| {
            let mut meter = Meter::new(file);
            let run = |each: &mut dyn FnMut(Tick) -> ControlFlow<()>| rig::run(file, entrant, each);
            watched((file.ticks() + 1, BREATH), watch, run, |tick| meter.add(tick))?;
            Ok::<_, RunError>(meter.finish(entrant))
        };
        let outcomes = entrants.iter().copied().map(run).collect::<Result<_, _>>()?;
        Ok(Self { name: name.to_owned(), file: file.clone(), outcomes })
    }

    fn sheet(&self) -> Sheet {
        Sheet {
            name: self.name.clone(),
            setting: table::setting(&self.file),
            start: table::start(&self.file),
            tables: table::of(self),
            figure: picture::of(self),
            caption: "Positions over time. What leaves a frame is cut off there.",
            csv: self.csv(),
        }
    }

    fn document(comparisons: &[Self], left_out: &[String]) -> String {
        document::of(comparisons, left_out)
    }

    fn named_scores(&self) -> impl Iterator<Item = (&str, &Score)> {
        self.scores().map(|score| (&self.name[..], score))
    }
}

impl Comparison {
    /// The score of each entrant.
    pub fn scores(&self) -> impl Iterator<Item = &Score> {
        self.outcomes.iter().map(|outcome| &outcome.score)
    }

    /// The motion of master and slave under each entrant.
    pub fn curves(&self) -> impl Iterator<Item = (Entrant, &Curves)> {
        self.outcomes.iter().map(|outcome| (outcome.entrant, &outcome.curves))
    }

    /// [`Comparison::curves`] as comma-separated values, in numbers that read back exactly.
    fn csv(&self) -> String {
        let records = self.curves().flat_map(|(entrant, curves)| {
            let devices = [("master", &curves.master), ("slave", &curves.slave)];
            devices.into_iter().flat_map(move |(device, curve)| {
                let names = [entrant.name(), device].map(Field::Text);
                curve
                    .iter()
                    .map(move |(t, x)| [names[0], names[1], Field::Number(*t), Field::Number(*x)])
            })
        });
        csv::text(["stabilizer", "device", "t", "x"], records)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.sheet().fmt(f)
    }
}
