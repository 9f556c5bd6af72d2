//! Table of what stabilizers would have done.

use super::Replay;
use super::group::Group;
use crate::show::csv;
use crate::show::table::{Cell, Heading, Table};
use crate::text::{folded, prefix};

impl Replay {
    /// The lines about who was asked, labelled.
    pub(in crate::studies::observe) fn lines(&self) -> String {
        let asked = format!("what each stabilizer would have done, set as {} says", self.scene);
        let mut lines = folded("  replay      ", &asked);
        let mut tell = |label: &str, text: &str| {
            lines += &format!("\n{}", folded(&format!("  {label:<12}"), text));
        };
        if let Some(first) = self.not_replayed.first() {
            let names: Vec<&str> = self.not_replayed.iter().map(|left| left.stabilizer).collect();
            tell("not asked", &format!("{}: {}", names.join(", "), first.reason));
        }
        for equal in self.groups().iter().filter_map(Group::equal) {
            tell("equal", &equal);
        }
        lines
    }

    /// A row for each stabilizer; those that cannot be told apart share one.
    pub(in crate::studies::observe) fn table(&self) -> Table {
        let energies = self.stabilizers.iter();
        let energies = energies.flat_map(|it| [it.energy_taken, it.shortfall, it.energy_given]);
        let (joule, joules) = prefix(energies.fold(0.0, |most, it| most.max(it.abs())));
        let headings = [
            Heading::word("stabilizer"),
            Heading::number("acts\nticks"),
            Heading::number("acts\n%"),
            Heading::number("first\ns"),
            Heading::number("largest\nN"),
            Heading::number("at\ns"),
            Heading::number("rms\nN"),
            Heading::number(format!("takes\n{joules}J")),
            Heading::number(format!("shortfall\n{joules}J")),
            Heading::number(format!("given\n{joules}J")),
        ];
        let rows = self.groups().into_iter().map(|group| {
            let row = group.row;
            [
                group.name().into(),
                row.active_ticks.to_string().into(),
                Cell::from(row.active_percent),
                row.first_at.into(),
                row.largest_force.into(),
                row.largest_force_at.into(),
                row.rms_force.into(),
                (joule * row.energy_taken).into(),
                (joule * row.shortfall).into(),
                (joule * row.energy_given).into(),
            ]
        });
        Table::new(headings).with_rows(rows)
    }

    /// The rows as comma-separated values, in SI units.
    pub fn csv(&self) -> String {
        csv::records(&self.stabilizers)
    }
}
