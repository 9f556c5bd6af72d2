//! Tables of a study, and its lines in the terminal.

use std::fmt;

use super::horizon::GROWN;
use super::ledger::TICKS;
use super::reference::Second;
use super::study::Row;
use super::{Study, timing};
use crate::show::html::verdict;
use crate::show::table::{Cell, Heading, Table};
use crate::text::{folded, found};

pub(super) fn write(study: &Study, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "{}: what accuracy costs\n", study.name)?;
    study.sentences().iter().try_for_each(|sentence| writeln!(f, "{}", folded("", sentence)))?;
    write!(f, "\n{}", study.settings())?;
    writeln!(
        f,
        "\n*  no other is as fast and as accurate   ~  less than 100 times the references' distance"
    )?;
    writeln!(f, "\nledger: a step of POPC over {TICKS} ticks that take 26.7 J\n")?;
    write!(f, "{}", study.ledgers())
}

/// A duration in a suitable unit.
pub(super) fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        ns if ns < 999.5 => (ns, "ns"),
        ns if ns < 999.5e3 => (1e-3 * ns, "µs"),
        ns => (1e-6 * ns, "ms"),
    };
    let digits = if value < 9.95 { 2 } else { usize::from(value < 99.5) };
    format!("{value:.digits$} {unit}")
}

impl Row {
    /// The error in a word.
    pub(super) fn error(&self) -> String {
        let sign = if self.is_known { "" } else { "~" };
        match self.max_error {
            None => "out of range".to_owned(),
            Some(0.0) => format!("{sign}0 m"),
            Some(error) => format!("{sign}{error:.1e} m"),
        }
    }
}

impl Study {
    /// The settings, the fastest first.
    pub(super) fn settings(&self) -> Table {
        let mut headings = vec![
            Heading::word("front"),
            Heading::number("per simulated\nsecond"),
            Heading::number("spread"),
            Heading::number("largest\nerror"),
            Heading::word("propagator"),
            Heading::number("steps,\ntolerance"),
            Heading::word("scalar"),
        ];
        let chaotic = self.basis.growth.chaotic;
        headings.extend(chaotic.then(|| Heading::number("believed for")));
        Table::new(headings).with_rows(self.rows.iter().map(|row| {
            let front = if row.is_on_front {
                Cell::new("*", verdict("yes", "front"))
            } else {
                Cell::from("")
            };
            let horizon = row.horizon.map(|time| format!("{} s", found(time)));
            let horizon = horizon.unwrap_or_else(|| "to the end".to_owned());
            [
                front,
                duration(row.time.median).into(),
                duration(row.time.spread).into(),
                row.error().into(),
                row.setting.integrator.name().into(),
                row.setting.detail().into(),
                row.setting.number.name().into(),
            ]
            .into_iter()
            .chain(chaotic.then(|| horizon.into()))
        }))
    }

    /// The ledgers' costs, and the errors of their sums.
    pub(super) fn ledgers(&self) -> Table {
        let headings = [
            Heading::word("scalar"),
            Heading::word("ledger"),
            Heading::number("error of\nthe sum"),
            Heading::number("per tick"),
            Heading::number("spread"),
        ];
        Table::new(headings).with_rows(self.ledger.iter().map(|row| {
            [
                row.scalar.into(),
                row.ledger.into(),
                format!("{:.1e} J", row.error).into(),
                duration(row.time.median).into(),
                duration(row.time.spread).into(),
            ]
        }))
    }

    /// The meaning of the numbers, sentence by sentence.
    pub(super) fn sentences(&self) -> Vec<String> {
        let (basis, period) = (&self.basis, self.scene.period());
        let seconds = |ticks: usize| found(ticks.saturating_sub(1) as f64 * period).to_string();
        let mut all = vec![format!(
            "Errors are the largest of the position over {} s ({} ticks), against the exact map in double-double; {} \
             is within {:.1e} m of it.",
            seconds(basis.ticks),
            basis.ticks,
            basis.second.name(),
            basis.distance
        )];
        if basis.second != Second::Extrapolation {
            all.push(
                "Part of this scene (friction, or a power of the depth) is worked out in f64 in any case: what \
                 stands behind a ~ is known to its size only."
                    .to_owned(),
            );
        }
        if basis.all_ticks < self.scene.ticks() as usize + 1 {
            all.push(format!("The study ends after {} s of the scene.", seconds(basis.all_ticks)));
        }
        if basis.ticks < basis.all_ticks {
            all.push(format!(
                "By then a deviation of the start has grown {GROWN:.0}-fold: what is off later says nothing of the method."
            ));
        }
        if let (true, Some(exponent)) = (basis.growth.chaotic, basis.growth.exponent) {
            all.push(format!(
                "The scene is chaotic: small deviations grow as exp(t / {:.2} s), its largest Lyapunov exponent is {:.2} \
                 /s. A trace is believed until it is off by {:.1e} m, a hundredth of the motion's reach; the references can tell \
                 up to {} s.",
                exponent.recip(),
                exponent,
                basis.believed,
                seconds(basis.agreeing)
            ));
        } else if let Some(exponent) = basis.growth.exponent {
            let way = if exponent > 0.0 { "grow" } else { "die away" };
            all.push(format!(
                "Small deviations {way}: the largest Lyapunov exponent is {exponent:.2} /s."
            ));
        }
        if self.scene.effects.encoder.is_some() {
            all.push(
                "The encoder may make a whole count of the smallest difference: errors are those of a count and of what \
                 follows from it."
                    .to_owned(),
            );
        }
        all.push(format!(
            "Times are medians of {} rounds in turns, over the first {} ticks of the loop alone.",
            basis.rounds,
            basis.all_ticks.min(timing::TICKS)
        ));
        all
    }
}
