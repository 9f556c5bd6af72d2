//! Comparison of entrants on one model.

use std::fmt;
use std::ops::ControlFlow;

use super::{document, picture, table};
use crate::files::models::Model;
use crate::measure::models::{Meter, Outcome, Score};
use crate::show::csv::{self, Field};
use crate::simulate::models::{Entrant, Tick, built};
use crate::studies::compare::compared::{BREATH, Compared, RunError, Watch, watched};
use crate::studies::compare::sheet::Sheet;
use crate::text::names::{Named, Names};

/// Entrants on one model; its `Display` is the table of `lyapunov compare`.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The model's name, usually the path of its file.
    pub name: String,
    /// The model.
    pub model: Model,
    /// V at the start.
    pub began: f64,
    pub(super) outcomes: Vec<Outcome>,
}

impl Compared for Comparison {
    type File = Model;
    type Entrant = Entrant;
    type Score = Score;

    const NOUN: &'static str = "model";
    const TITLE: &'static str = "Stabilizers of control-affine plants";
    const ABOUT: &'static str = "Each plant once without a stabilizer, once with the sum of what its input takes \
                                 from V (popc), once with the sum of all that V loses (lolc-decrease), and once \
                                 with V asked to decay as well (lolc-decay).";

    fn ticks(model: &Model) -> u64 {
        model.ticks() + 1
    }

    fn of(
        name: &str,
        model: &Model,
        entrants: &Names<Entrant>,
        watch: &Watch<'_>,
    ) -> Result<Self, RunError> {
        let built = built(model).map_err(|(_, error)| error)?;
        let breath = (BREATH / u64::from(model.steps_per_tick.get())).max(1);
        let run = |entrant| {
            let mut meter = Meter::new(model, built.began());
            let run = |each: &mut dyn FnMut(Tick) -> ControlFlow<()>| {
                built.run(entrant, each);
                Ok(())
            };
            watched((model.ticks() + 1, breath), watch, run, |tick| meter.add(tick))?;
            Ok::<_, RunError>(meter.finish(entrant))
        };
        let outcomes = entrants.iter().copied().map(run).collect::<Result<_, _>>()?;
        Ok(Self { name: name.to_owned(), model: model.clone(), began: built.began(), outcomes })
    }

    fn sheet(&self) -> Sheet {
        Sheet {
            name: self.name.clone(),
            setting: table::setting(self),
            start: table::start(self),
            tables: vec![table::of(self)],
            figure: picture::of(self),
            caption: "V over time. A curve that leaves the frame is cut off there.",
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

    /// Time in s and V of each entrant, at every tick, or for a long run the extremes of each of some thousand
    /// stretches.
    pub fn curves(&self) -> impl Iterator<Item = (Entrant, &[(f64, f64)])> {
        self.outcomes.iter().map(|outcome| (outcome.entrant, &outcome.curve[..]))
    }

    /// [`Comparison::curves`] as comma-separated values, in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let records = self.curves().flat_map(|(entrant, curve)| {
            let name = Field::Text(entrant.name());
            curve.iter().map(move |(t, v)| [name, Field::Number(*t), Field::Number(*v)])
        });
        csv::text(["stabilizer", "t", "v"], records)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.sheet().fmt(f)
    }
}
