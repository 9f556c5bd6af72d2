//! Price table in the terminal, one part for each kind of number.

use std::fmt;

use super::{Column, Costs, Difference};
use crate::show::table::{Cell, Heading, Table};

pub(super) fn write(prices: &Costs, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (index, column) in prices.scalars.iter().enumerate() {
        if index > 0 {
            writeln!(f)?;
        }
        part(column, f)?;
    }
    writeln!(f)?;
    let (rounds, ticks) = (prices.rounds, prices.ticks);
    writeln!(
        f,
        "ns per step with the effect less without; medians of {rounds} rounds, {ticks} ticks a run"
    )
}

fn part(column: &Column, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let Column { scalar, rollouts, bare_ns_per_step, effects } = column;
    let what = match rollouts {
        1 => String::from("one rollout"),
        several => format!("{several} rollouts at once"),
    };
    writeln!(f, "{scalar}, {what}: {bare_ns_per_step:.1} ns per step without effects\n")?;
    let numbers = ["alone", "with all\nothers"].map(|company| {
        ["ns", "spread", "ratio"].map(|what| Heading::number(format!("{company}\n{what}")))
    });
    let headings = std::iter::once(Heading::word("effect")).chain(numbers.into_iter().flatten());
    let rows = effects.iter().map(|price| {
        let numbers = [price.alone, price.composed].into_iter().flat_map(cells);
        std::iter::once(price.effect.into()).chain(numbers)
    });
    write!(f, "{}", Table::new(headings).with_rows(rows))
}

fn cells(difference: Difference) -> [Cell; 3] {
    let Difference { ns_per_step, spread_ns, ratio } = difference;
    [format!("{ns_per_step:.1}"), format!("{spread_ns:.1}"), format!("{ratio:.2}")].map(Cell::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::studies::effects::Cost;

    #[test]
    fn the_table_fits_the_terminal() {
        let long = Difference { ns_per_step: -1234567.8, spread_ns: 1234567.8, ratio: 12345.67 };
        let price = Cost { effect: "mass-spring-damper", alone: long, composed: long };
        let effects = vec![price];
        let column = Column { scalar: "f64x8", rollouts: 8, bare_ns_per_step: 1234.5, effects };
        let scalars = vec![column.clone(), column];
        let prices = Costs { not_deterministic: [""; 4], rounds: 41, ticks: 250, scalars };
        let text = prices.to_string();
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
        assert!(text.contains(" -1234567.8 "), "{text}");
    }
}
