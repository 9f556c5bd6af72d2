//! The table of an own stabilizer.

use super::super::kind::{Numbers, StabilizerKind};
use super::super::{Basis, Parameter, Pledge};
use super::{Declared, Loop};
use crate::files::scene::OutOfRange;

/// The most numbers that an own stabilizer may have.
pub(super) const MOST: usize = 8;

/// The table of an own stabilizer in a scene: `[stabilizer.NAME]`, with the numbers that it writes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnTable {
    own: &'static Declared,
    written: [Option<f64>; MOST],
}

impl OwnTable {
    /// The table without a written number.
    pub(crate) fn of(own: &'static Declared) -> Self {
        Self { own, written: [None; MOST] }
    }

    /// The stabilizer.
    pub(crate) fn own(&self) -> &'static Declared {
        self.own
    }

    /// The written numbers with their keys.
    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, bool, f64)> {
        let numbers = self.own.numbers.iter().zip(self.written);
        numbers.filter_map(|(it, written)| Some((it.key, it.allowed.is_whole(), written?)))
    }

    fn place(&self, key: &str) -> Option<usize> {
        self.own.numbers.iter().position(|number| number.key == key)
    }
}

impl Numbers for OwnTable {
    fn name(&self) -> &'static str {
        self.own.name
    }

    fn parameters(&self, on: &Basis) -> Vec<Parameter> {
        let seen = Loop::new(on, self);
        let numbers = self.own.numbers.iter().zip(self.own.keys.iter().skip(1)).zip(self.written);
        let parameter = |((number, key), written): ((&super::OwnNumber, &super::super::Key), _)| {
            let default = (number.default)(&seen);
            Parameter {
                key: key.path,
                unit: number.unit,
                written,
                default: number.allowed.check(default).ok(),
                is_whole: number.allowed.is_whole(),
                search: (number.search)(default, &seen),
            }
        };
        numbers.map(parameter).collect()
    }

    fn written(&self, key: &str) -> Option<f64> {
        self.written[self.place(key)?]
    }

    fn write(&mut self, key: &str, number: f64) -> Result<bool, OutOfRange> {
        let Some(place) = self.place(key) else { return Ok(false) };
        self.written[place] = Some(self.own.numbers[place].allowed.check(number)?);
        Ok(true)
    }
}

impl StabilizerKind for OwnTable {
    fn pledge(&self, _on: &Basis) -> Pledge {
        self.own.pledge()
    }

    fn adds_damping(&self) -> bool {
        self.own.promise.adds_damping()
    }

    fn promises(&self) -> bool {
        self.own.promise.holds_bounds()
    }

    fn lacks(&self, on: &Basis) -> Option<&'static str> {
        self.parameters(on).iter().find(|it| it.value().is_none()).map(|it| it.key)
    }
}
