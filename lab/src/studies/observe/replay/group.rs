//! Stabilizers that show the same numbers.

use super::{Replay, Replayed};
use crate::text::{found, shortened_names};

/// Characters of the names that a heading has room for.
const ROOM: usize = 28;

/// Stabilizers that show the same numbers; the first stands for all.
#[derive(Clone, Debug)]
pub(super) struct Group<'a> {
    names: Vec<&'static str>,
    /// Its place among the rows.
    pub(super) index: usize,
    pub(super) row: &'a Replayed,
}

impl Group<'_> {
    /// All names, `popc = lolc-spring`; none of a stabilizer by itself.
    pub(super) fn equal(&self) -> Option<String> {
        (self.names.len() > 1).then(|| self.names.join(" = "))
    }

    /// All names, or for a narrow place the first and the number of the others.
    pub(super) fn name(&self) -> String {
        shortened_names(&self.names, ROOM)
    }
}

impl Replay {
    /// The groups, each in the place of its first.
    pub(super) fn groups(&self) -> Vec<Group<'_>> {
        let mut groups: Vec<Group<'_>> = Vec::new();
        for (index, row) in self.stabilizers.iter().enumerate() {
            match groups.iter_mut().find(|group| shown(group.row) == shown(row)) {
                Some(group) => group.names.push(row.stabilizer),
                None => groups.push(Group { names: vec![row.stabilizer], index, row }),
            }
        }
        groups
    }
}

/// The numbers of a row as they are shown.
fn shown(row: &Replayed) -> Vec<String> {
    let number = |value: f64| found(value).to_string();
    let at = |time: Option<f64>| time.map_or_else(String::new, number);
    let sizes =
        [row.largest_force, row.rms_force, row.energy_taken, row.shortfall, row.energy_given];
    let times = [row.first_at, row.largest_force_at].map(at);
    sizes.map(number).into_iter().chain(times).chain([row.active_ticks.to_string()]).collect()
}
