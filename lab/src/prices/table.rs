//! The table in the terminal, one part for each kind of number.

use std::fmt;

use super::{Column, Difference, Prices};

pub(super) fn write(prices: &Prices, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
    writeln!(f, "{scalar}, {what}: {bare_ns_per_step:.1} ns per step without effects")?;
    let heads = ["ns", "spread", "ratio"].map(|head| format!("{head:>9}")).concat();
    writeln!(f, "{:<20}{:>27}  {:>27}", "", "alone", "with all others")?;
    writeln!(f, "{:<20}{heads}  {heads}", "effect")?;
    for price in effects {
        let [alone, composed] = [price.alone, price.composed].map(cells);
        writeln!(f, "{:<20}{alone}  {composed}", price.effect)?;
    }
    Ok(())
}

fn cells(difference: Difference) -> String {
    let Difference { ns_per_step, spread_ns, ratio } = difference;
    format!(" {ns_per_step:>8.1} {spread_ns:>8.1} {ratio:>8.2}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prices::Price;

    #[test]
    fn the_table_fits_the_terminal() {
        let long = Difference { ns_per_step: -1234567.8, spread_ns: 1234567.8, ratio: 12345.67 };
        let price = Price { effect: "mass-spring-damper", alone: long, composed: long };
        let effects = vec![price];
        let column = Column { scalar: "f64x8", rollouts: 8, bare_ns_per_step: 1234.5, effects };
        let scalars = vec![column.clone(), column];
        let prices = Prices { not_deterministic: [""; 4], rounds: 41, ticks: 250, scalars };
        let text = prices.to_string();
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
        assert!(text.contains(" -1234567.8 "), "{text}");
    }
}
