//! Smallest scene that breaks the same promise.

use toml::{Table, Value};

use super::breach::Breach;
use super::promises;
use crate::files::Scene;

/// Shares of a duration that are tried, the shortest first.
const SHORTER: [f64; 3] = [0.5, 0.75, 0.9];

/// Digits of a number that are tried, the fewest first.
const DIGITS: [usize; 2] = [0, 2];

/// The text of a scene from which nothing can be left out, and what it breaks: the same promise as `scene`. None if
/// the scene does not break it once it is written and read.
pub(super) fn shrunk(scene: &Scene, breach: Breach) -> Option<(String, Breach)> {
    let mut smallest = Smallest { table: Table::try_from(scene).ok()?, breach };
    let whole = smallest.table.clone();
    if !smallest.takes(whole) {
        return None;
    }
    loop {
        let before = smallest.table.clone();
        smallest.shorten();
        smallest.leave_out();
        smallest.round();
        if smallest.table == before {
            return Some((toml::to_string(&smallest.table).ok()?, smallest.breach));
        }
    }
}

/// The smallest scene so far.
struct Smallest {
    table: Table,
    breach: Breach,
}

impl Smallest {
    /// Takes `table` if it is a scene that breaks the same promise.
    fn takes(&mut self, table: Table) -> bool {
        let broken = toml::to_string(&table)
            .ok()
            .and_then(|text| Scene::parse(&text, "a smaller scene").ok())
            .and_then(|scene| promises::breach(&scene).ok()?)
            .filter(|broken| broken.is_like(&self.breach));
        if let Some(broken) = broken {
            (self.table, self.breach) = (table, broken);
        }
        broken.is_some()
    }

    /// Shortens the run, by half at first, as long as that takes ticks away.
    fn shorten(&mut self) {
        while SHORTER.into_iter().any(|share| self.takes_share(share)) {}
    }

    fn takes_share(&mut self, share: f64) -> bool {
        let number = |key| self.table.get(key).and_then(Value::as_float);
        let (Some(duration), Some(rate)) = (number("duration"), number("servo_rate")) else {
            return false;
        };
        let mut table = self.table.clone();
        table.insert("duration".to_owned(), (share * duration).into());
        share * duration * rate >= 1.0 && self.takes(table)
    }

    /// Leaves out tables and keys, a table before its keys. The stabilizer stays: it is what breaks the promise, and
    /// without one there is none.
    fn leave_out(&mut self) {
        let may_go = |path: &Vec<String>| path[0] != "stabilizer" || path.len() > 2;
        for path in paths(&self.table).into_iter().filter(may_go) {
            let mut table = self.table.clone();
            let (last, above) = (&path[path.len() - 1], &path[..path.len() - 1]);
            if within(&mut table, above).and_then(|inner| inner.remove(last)).is_some() {
                self.takes(table);
            }
        }
    }

    /// Rounds numbers to fewer digits.
    fn round(&mut self) {
        for path in paths(&self.table) {
            for digits in DIGITS {
                let mut table = self.table.clone();
                let (last, above) = (&path[path.len() - 1], &path[..path.len() - 1]);
                let value = within(&mut table, above).and_then(|inner| inner.get_mut(last));
                let Some(Value::Float(number)) = value else { break };
                let Ok(rounded) = format!("{number:.digits$e}").parse() else { break };
                if *number == rounded {
                    break;
                }
                *number = rounded;
                if self.takes(table) {
                    break;
                }
            }
        }
    }
}

/// The paths of all tables and keys, each table before its keys.
fn paths(table: &Table) -> Vec<Vec<String>> {
    let below = |(key, value): (&String, &Value)| {
        let inner = value.as_table().map(paths).unwrap_or_default();
        let inner = inner.into_iter().map(|path| [vec![key.clone()], path].concat());
        std::iter::once(vec![key.clone()]).chain(inner).collect::<Vec<_>>()
    };
    table.iter().flat_map(below).collect()
}

/// The table at a path.
fn within<'a>(table: &'a mut Table, path: &[String]) -> Option<&'a mut Table> {
    path.iter().try_fold(table, |table, key| table.get_mut(key)?.as_table_mut())
}
