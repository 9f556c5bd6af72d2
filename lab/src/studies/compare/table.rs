//! Scene in a line, and table in the terminal: three parts, one below the other.

use std::fmt;

use super::Comparison;
use super::column::Column;
use super::equal::Equals;
use super::look_at::LookAt;
use crate::files::Scene;
use crate::show::described;
use crate::show::table::{Cell, Table};
use crate::show::verdict::by_speed;
use crate::studies::explain::in_balance;
use crate::text::{folded, given};

/// Columns of the loop's behaviour.
const BEHAVIOUR: [Column; 8] = [
    Column::Stabilizer,
    Column::Verdict,
    Column::SettlingTime,
    Column::ShortPeak,
    Column::LongPeak,
    Column::EnergyInjected,
    Column::EnergyTaken,
    Column::Shortfall,
];

/// Columns of feel and cost.
const FEEL: [Column; 8] = [
    Column::Stabilizer,
    Column::StiffnessFelt,
    Column::StiffnessPercent,
    Column::ForceError,
    Column::Chatter,
    Column::Active,
    Column::StepTime,
    Column::StateBytes,
];

/// Columns of energy and force on the true motion.
const PHYSICAL: [Column; 6] = [
    Column::Stabilizer,
    Column::EnergyGiven,
    Column::EnergyBeyondDamper,
    Column::ForceFelt,
    Column::BrokeIt,
    Column::JudgedBy,
];

pub(super) fn write(comparison: &Comparison, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "{}: {}", comparison.name, Setting(&comparison.scene))?;
    writeln!(f, "POPC and LOLC: {}", comparison.settings)?;
    for remark in remarks(comparison) {
        writeln!(f, "{remark}")?;
    }
    for names in equal_names(comparison) {
        writeln!(f, "{}", folded("equal as shown (median ns of a step): ", &names))?;
    }
    tables(comparison).iter().try_for_each(|table| write!(f, "\n{table}"))
}

/// The remarks that the tables need.
pub(super) fn remarks(comparison: &Comparison) -> Vec<String> {
    let cap = described::exceeded_cap(&comparison.scene);
    let by = by_speed(&comparison.scene).map(|by| format!("judged {by}"));
    let undisturbed = comparison.scores().all(|score| score.settling_time == Some(0.0));
    let balance = undisturbed.then(|| folded("note: ", &in_balance("each run", "")));
    let signs = LookAt::of(comparison).into_iter();
    let signs = signs.map(|sign| sign.line(comparison.outcomes.len()));
    [cap, by, balance].into_iter().flatten().chain(signs).collect()
}

/// Room for a name in the first column, in characters.
const ROOM: usize = 23;

/// The names of each group of entrants whose runs are equal.
pub(super) fn equal_names(comparison: &Comparison) -> Vec<String> {
    let groups = Equals::of(&comparison.outcomes).into_iter();
    groups.filter(Equals::are_many).map(|group| group.names()).collect()
}

/// The tables, with equal rows once.
pub(super) fn tables(comparison: &Comparison) -> Vec<Table> {
    let groups = Equals::of(&comparison.outcomes);
    let of = |columns: &[Column]| {
        let headings = columns.iter().map(|column| column.heading());
        let rows = groups.iter().map(|group| {
            let cell = |column: &Column| cell(*column, group);
            columns.iter().map(cell).collect::<Vec<_>>()
        });
        Table::new(headings).with_rows(rows)
    };
    [&BEHAVIOUR[..], &FEEL, &PHYSICAL].map(of).into()
}

/// The cell of a group; what a step costs differs within it: the medians, which the line of the names tells one by one.
fn cell(column: Column, group: &Equals<'_>) -> Cell {
    let several = |of_what: &str, of: &dyn Fn(&super::Score) -> Option<f64>, decimals: usize| {
        let values: Vec<f64> = group.scores().filter_map(of).collect();
        let low = values.iter().copied().reduce(f64::min);
        let high = values.iter().copied().reduce(f64::max);
        let told = low.zip(high).map(|(low, high)| match low == high {
            true => format!("{of_what}{low:.decimals$}"),
            // As a range of times is written, so that a long name in the first column has room.
            false => format!("{of_what}{low:.decimals$}-{high:.decimals$}"),
        });
        Cell::from(told)
    };
    match column {
        Column::Stabilizer => group.short_name(ROOM).into(),
        Column::StepTime if group.are_many() => {
            several("medians ", &|score| score.step_time.map(|time| time.median), 2)
        }
        Column::StateBytes if group.are_many() => {
            several("", &|score| Some(score.state_bytes as f64), 0)
        }
        _ => column.cell(&group.first().score),
    }
}

pub(super) struct Setting<'a>(pub(super) &'a Scene);

impl fmt::Display for Setting<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = self.0;
        let (duration, rate) = (given(scene.duration.get()), given(scene.servo_rate.get()));
        write!(f, "{duration} s at {rate} Hz")?;
        if scene.environment_ratio() > 1 {
            write!(f, " over {} Hz", given(scene.environment_rate()))?;
        }
        write!(f, ", {} {}", scene.environment.name(), described::environment(scene))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Entrants, StepTime};
    use super::*;
    use crate::studies::paper::Case;
    use crate::studies::scenes::text_of;

    #[test]
    fn the_heading_tells_the_numbers_of_the_environment() {
        for (name, words) in [
            ("cubic-spring", "200 N/m, 1e6 N/m^3"),
            ("moving-wall", "mm at"),
            ("hold", "N/m"),
            ("mass-spring-damper", "kg"),
        ] {
            let scene = Scene::parse(text_of(name).unwrap(), name).unwrap();
            let told = Setting(&scene).to_string();
            assert!(told.contains(&format!(", {} ", scene.environment.name())), "{told}");
            assert!(told.contains(words), "{told}");
        }
    }

    /// A step of each costs something else, though the runs are equal.
    #[test]
    fn equal_entrants_show_their_costs_as_a_range() {
        let scene = Case::Plain50k.scene().unwrap();
        let mut comparison = Comparison::of("test", &scene, &Entrants::<f64>::standard()).unwrap();
        for (outcome, median) in comparison.outcomes.iter_mut().zip([1.0, 2.25, 4.5, 8.0, 16.0]) {
            let time = outcome.score.step_time.unwrap();
            outcome.score.step_time = Some(StepTime { median, min: median, max: median, ..time });
        }
        let shown = comparison.to_string();
        let rows = shown.lines().filter(|line| line.starts_with("popc + "));
        let told = "medians 2.25-8.00  16-24";
        assert!(rows.into_iter().any(|row| row.contains(told)), "{shown}");
        // The longest name that ships stands in each of the three tables in full.
        let full = shown.lines().filter(|line| line.starts_with("lolc-mass-spring-damper "));
        assert_eq!(full.count(), 3, "{shown}");
        let words: Vec<&str> = shown.split_whitespace().collect();
        let line = words.join(" ");
        for words in ["equal as shown (median ns of a step): ", "popc (2.25) = "] {
            assert!(line.contains(words), "{words}: {shown}");
        }
    }
}
