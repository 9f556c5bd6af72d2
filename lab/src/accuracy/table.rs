//! What the terminal shows: at most 100 columns.

use std::fmt::{self, Write};

use super::Study;
use super::horizon::GROWN;
use super::ledger::TICKS;
use super::reference::Second;
use super::study::Row;
use super::timing;
use crate::summary::found;

pub(super) fn write(study: &Study, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "{}: what accuracy costs\n", study.name)?;
    for sentence in study.sentences() {
        for line in folded(&sentence) {
            writeln!(f, "{line}")?;
        }
    }
    let chaotic = study.basis.growth.chaotic;
    let believed = if chaotic { "  believed for" } else { "" };
    writeln!(
        f,
        "\n   {:>16} {:>9}  {:>13}  {:<20} {:>9}  {:<7}{believed}",
        "per simulated s", "spread", "largest error", "propagator", "", "scalar"
    )?;
    for row in &study.rows {
        write!(f, "{}", line(row))?;
        match (chaotic, row.horizon) {
            (false, _) => writeln!(f)?,
            (true, Some(horizon)) => writeln!(f, "  {:>10} s", found(horizon).to_string())?,
            (true, None) => writeln!(f, "  {:>12}", "to the end")?,
        }
    }
    writeln!(
        f,
        "\n*  no other is as fast and as accurate   ~  less than 100 times the references' distance"
    )?;
    writeln!(f, "\nledger: a step of POPC over {TICKS} ticks that take 26.7 J\n")?;
    writeln!(f, "   {:>16} {:>9}  {:>13}  {:<20}", "per tick", "spread", "error", "ledger")?;
    for row in &study.ledger {
        let (time, spread) = (duration(row.time.median), duration(row.time.spread));
        let error = format!("{:.1e} J", row.error);
        writeln!(f, "   {time:>16} {spread:>9}  {error:>13}  {} {}", row.scalar, row.ledger)?;
    }
    Ok(())
}

fn line(row: &Row) -> String {
    let mark = if row.is_on_front { '*' } else { ' ' };
    let (time, spread) = (duration(row.time.median), duration(row.time.spread));
    let setting = row.setting;
    format!(
        "{mark}  {time:>16} {spread:>9}  {:>13}  {:<20} {:>9}  {:<7}",
        row.error(),
        setting.integrator.name(),
        setting.detail(),
        setting.number.name()
    )
}

/// A time in a unit that suits it.
pub(super) fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        ns if ns < 999.5 => (ns, "ns"),
        ns if ns < 999.5e3 => (1e-3 * ns, "µs"),
        ns => (1e-6 * ns, "ms"),
    };
    let digits = if value < 9.95 { 2 } else { usize::from(value < 99.5) };
    format!("{value:.digits$} {unit}")
}

/// The sentence in lines of at most 98 characters.
fn folded(sentence: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in sentence.split(' ') {
        let last = lines.last().map_or(0, |line| line.chars().count());
        if last > 0 && last + 1 + word.chars().count() > 98 {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            let gap = if line.is_empty() { "" } else { " " };
            let _ = write!(line, "{gap}{word}");
        }
    }
    lines
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
    /// What the numbers mean, sentence by sentence.
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
