//! Price table in the terminal, one part for each kind of number.

use std::fmt;

use super::{Column, Cost, Costs, Difference};
use crate::show::table::{Cell, Heading, Table};

pub(super) fn write(costs: &Costs, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if let Some(scene) = &costs.scene {
        writeln!(f, "{scene}\n")?;
    }
    writeln!(f, "{}", prices(costs))?;
    for (index, column) in costs.scalars.iter().enumerate() {
        if index > 0 {
            writeln!(f)?;
        }
        writeln!(f, "{}\n", column.bare())?;
        if column.effects.is_empty() {
            writeln!(f, "the scene names no effect")?;
        } else {
            write!(f, "{}", table(column))?;
        }
    }
    writeln!(f, "\n{}", costs.note())
}

impl Costs {
    /// The sentence that the numbers need.
    pub(super) fn note(&self) -> String {
        let (rounds, ticks) = (self.rounds, self.ticks);
        format!(
            "ns per step with the effect less without; medians of {rounds} rounds, {ticks} ticks a run"
        )
    }
}

impl Column {
    /// The time of a step without effects, in words.
    pub(super) fn bare(&self) -> String {
        let Self { scalar, rollouts, instructions, bare_ns_per_step, .. } = self;
        let what = match rollouts {
            1 => String::from("one rollout"),
            several => format!("{several} rollouts at once"),
        };
        format!(
            "{scalar}, {what} ({instructions}): {bare_ns_per_step:.1} ns per step without effects"
        )
    }
}

/// The price of each effect alone for one rollout, by itself and as one of several on lanes: of the first kind of number
/// and of the second, if the effect or the scene has lanes.
pub(super) fn prices(costs: &Costs) -> Table {
    let headings = [
        Heading::word("effect"),
        Heading::number("by itself\nns a rollout"),
        Heading::number("on lanes\nns a rollout"),
        Heading::number("times\nless"),
    ];
    let Some((one, lanes)) = costs.scalars.split_first() else { return Table::new(headings) };
    let lanes = lanes.first();
    let row = |name: &'static str, one: f64, on_lanes: Option<f64>, told: bool| {
        let share = lanes.zip(on_lanes).map(|(lanes, ns)| ns / lanes.rollouts as f64);
        let gain = share.filter(|_| told).map(|share| tenths(one / share));
        let or_dash = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned()).into();
        let share = share.map(|share| format!("{share:.2}"));
        [name.into(), tenths(one).into(), or_dash(share), or_dash(gain)]
    };
    let bare = lanes.map(|lanes| lanes.bare_ns_per_step);
    let bare = row("(the loop)", one.bare_ns_per_step, bare, true);
    let rows = one.effects.iter().map(|cost| {
        let same = |on: &&Cost| on.effect == cost.effect;
        let on = lanes.and_then(|lanes| lanes.effects.iter().find(same)).map(|it| it.alone);
        let told = cost.alone.is_told() && on.is_some_and(|on| on.is_told());
        row(cost.effect, cost.alone.ns_per_step, on.map(|on| on.ns_per_step), told)
    });
    Table::new(headings).with_rows(std::iter::once(bare).chain(rows))
}

/// The costs of each effect for one kind of number.
pub(super) fn table(column: &Column) -> Table {
    let numbers = ["alone", "with all\nothers"].map(|company| {
        ["ns", "spread", "ratio"].map(|what| Heading::number(format!("{company}\n{what}")))
    });
    let headings = std::iter::once(Heading::word("effect")).chain(numbers.into_iter().flatten());
    let rows = column.effects.iter().map(|cost| {
        let numbers = [cost.alone, cost.composed].into_iter().flat_map(cells);
        std::iter::once(cost.effect.into()).chain(numbers)
    });
    Table::new(headings).with_rows(rows)
}

fn cells(difference: Difference) -> [Cell; 3] {
    let Difference { ns_per_step, spread_ns, ratio } = difference;
    [tenths(ns_per_step), tenths(spread_ns), format!("{ratio:.2}")].map(Cell::from)
}

/// A number with one decimal; what rounds to nothing has no sign.
fn tenths(number: f64) -> String {
    let text = format!("{number:.1}");
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_fits_the_terminal() {
        let long = Difference { ns_per_step: -1234567.8, spread_ns: 1234567.8, ratio: 12345.67 };
        let cost = Cost { effect: "mass-spring-damper", alone: long, composed: long };
        let effects = vec![cost];
        let column = Column {
            scalar: "f64x8",
            rollouts: 8,
            instructions: "avx512",
            bare_ns_per_step: 1234.5,
            effects,
        };
        let scalars = vec![column.clone(), column];
        let costs =
            Costs { scene: None, not_deterministic: [""; 4], rounds: 41, ticks: 250, scalars };
        let text = costs.to_string();
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
        assert!(text.contains(" -1234567.8 "), "{text}");
    }

    #[test]
    fn nothing_has_no_sign() {
        let told = [-0.04, -0.0, 0.04, -0.06, 0.06].map(tenths);
        assert_eq!(told, ["0.0", "0.0", "0.0", "-0.1", "0.1"]);
    }
}
