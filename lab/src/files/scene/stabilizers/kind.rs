//! The interface of every stabilizer's table.

use std::fmt;

use lyapunov::{DampingLimit, OnePort, ParameterError, Scalar, Signal, Stabilizer};

use super::{Basis, Pledge};
use crate::files::scene::book::Key;
use crate::files::scene::check::Conflict;
use crate::files::scene::lanes::numbers;
use crate::files::scene::{Damping, Lanes, OutOfRange};

/// A number of a stabilizer on a loop, by its key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its key in a scene, with the table path.
    pub key: &'static str,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// The value that the scene writes.
    pub written: Option<f64>,
    /// The value where none is written, which follows from the loop; none where the loop gives none.
    pub default: Option<f64>,
    /// Whether it takes whole numbers only.
    pub is_whole: bool,
    /// The range in which to look for a better value; none where there is nothing to look for.
    pub search: Option<Search>,
}

impl Parameter {
    /// The value that the stabilizer is built with; none where it goes without.
    pub fn value(&self) -> Option<f64> {
        self.written.or(self.default)
    }

    /// The key without its table path.
    pub fn name(&self) -> &'static str {
        self.key.rsplit('.').next().unwrap_or(self.key)
    }
}

/// A range to search: every value in it makes a stabilizer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// The smallest value.
    pub lower: f64,
    /// The largest value.
    pub upper: f64,
    /// The spacing of the values between them.
    pub spacing: Spacing,
}

/// Spacing of the values of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// By equal differences.
    Linear,
    /// By equal ratios.
    Logarithmic,
}

impl Search {
    /// Equal ratios from `lower` to `upper`; none unless both are finite and 0 < lower < upper.
    pub fn ratios(lower: f64, upper: f64) -> Option<Self> {
        let fits = lower > 0.0 && lower < upper && upper.is_finite();
        fits.then_some(Self { lower, upper, spacing: Spacing::Logarithmic })
    }

    /// Equal differences from 0 to `upper`; none unless that is finite and above 0.
    pub fn up_to(upper: f64) -> Option<Self> {
        let fits = upper > 0.0 && upper.is_finite();
        fits.then_some(Self { lower: 0.0, upper, spacing: Spacing::Linear })
    }
}

/// The numbers of a table, as its description lists them.
pub(crate) trait Numbers: fmt::Debug {
    /// The name of the table.
    fn name(&self) -> &'static str;

    /// Each number of the table on a loop.
    fn parameters(&self, on: &Basis) -> Vec<Parameter>;

    /// The number that is written under the name `key`; none if there is no such key as well.
    fn written(&self, key: &str) -> Option<f64>;

    /// Writes a number under the name `key`; false if there is no such key.
    ///
    /// # Errors
    /// A number that the key does not allow.
    fn write(&mut self, key: &str, number: f64) -> Result<bool, OutOfRange>;
}

/// The properties of a stabilizer that the lab needs besides its law, which is the library's.
pub(crate) trait StabilizerKind: Numbers {
    /// Its promises beyond finite outputs.
    fn pledge(&self, on: &Basis) -> Pledge;

    /// Whether it takes energy out of a motion by a damper, and not only by smaller forces.
    fn adds_damping(&self) -> bool {
        true
    }

    /// Whether the damping that it adds is reported as `α`; that of a port around the environment is not.
    fn reports_damping(&self) -> bool {
        self.adds_damping()
    }

    /// The assumption about the environment that it rests on, in words; none where it rests on none.
    fn assumes(&self) -> Option<&'static str> {
        None
    }

    /// Whether it makes the promises of POPC: it serves every debt at once, and credits nothing that may not have been
    /// dissipated. `popc` and the kinds of `lolc` are judged by their names and not asked.
    fn promises(&self) -> bool {
        false
    }

    /// The key of the loop that it is set by and that is 0 there.
    fn lacks(&self, _on: &Basis) -> Option<&'static str> {
        None
    }

    /// A setting that follows from its numbers and is the same in all lanes, such as a count of ticks: stabilizers that differ
    /// in it share no lanes.
    fn shape(&self, _on: &Basis) -> u32 {
        0
    }

    /// The rules between its own values, and between those and the loop's.
    fn check(&self, _on: &Basis) -> Result<(), Conflict> {
        Ok(())
    }

    /// The keys of its vectors, with their lengths.
    fn vectors(&self) -> Vec<(&'static str, usize)> {
        Vec::new()
    }
}

/// A stabilizer for any number of dimensions.
pub(super) trait Anywhere: StabilizerKind {
    /// The result of `to` for the library's stabilizer.
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError>
    where
        Self: Sized;
}

/// A stabilizer for one dimension.
pub(super) trait OnALine: StabilizerKind {
    /// The result of `to` for the library's stabilizer.
    fn make<T: Scalar, R: Install<T>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError>
    where
        Self: Sized;
}

/// Tables of one kind, each on the loop of its lane.
#[derive(Debug)]
pub(super) struct OnLoops<'a, A> {
    tables: &'a [&'a A],
    bases: &'a [Basis],
}

impl<A> Clone for OnLoops<'_, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for OnLoops<'_, A> {}

impl<'a, A: StabilizerKind> OnLoops<'a, A> {
    /// One table for each basis, and at least one.
    pub(super) fn new(tables: &'a [&'a A], bases: &'a [Basis]) -> Self {
        Self { tables, bases }
    }

    /// Each table with its loop.
    pub(super) fn pairs(self) -> impl Iterator<Item = (&'a A, &'a Basis)> {
        self.tables.iter().copied().zip(self.bases)
    }

    /// A loop for what all have in common.
    pub(super) fn common(self) -> &'a Basis {
        Lanes::new(self.bases).common()
    }

    /// A table for what all have in common.
    pub(super) fn own(self) -> &'a A {
        Lanes::new(self.tables).common()
    }

    /// The [shape](StabilizerKind::shape) of all.
    pub(super) fn shape(self) -> u32 {
        self.own().shape(self.common())
    }

    /// One number of each table on its loop, lane by lane.
    pub(super) fn each<T: Scalar>(self, number: impl Fn(&A, &Basis) -> f64) -> T {
        let (tables, bases) = (Lanes::new(self.tables), Lanes::new(self.bases));
        numbers(&mut |lane| number(tables.lane(lane), bases.lane(lane)))
    }

    /// The damping limit of `cap` m / T on each loop.
    pub(super) fn limit<T: Scalar>(
        self,
        cap: impl Fn(&A, &Basis) -> f64,
    ) -> Result<DampingLimit<T>, ParameterError> {
        let (tables, bases) = (Lanes::new(self.tables), Lanes::new(self.bases));
        Damping::limit_of_lanes(&|lane| {
            let on = bases.lane(lane);
            Damping { cap: cap(tables.lane(lane), on), ..on.limit }
        })
    }
}

/// A use of a stabilizer, whose type only the scene knows.
pub(crate) trait Install<V: Signal> {
    /// The result.
    type Made;

    /// The port that a stabilizer wraps which is itself a port.
    type Port: OnePort<V> + 'static;

    /// The result for a stabilizer that corrects the environment's efforts.
    fn behind(self, stabilizer: impl Stabilizer<V> + 'static) -> Self::Made;

    /// The result for a stabilizer that is a port around the environment, which it asks itself.
    fn around<P: OnePort<V> + 'static>(
        self,
        pace: Pace,
        wrap: impl Fn(Self::Port) -> Result<P, ParameterError> + 'static,
    ) -> Self::Made;
}

/// The rate of a port around the environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pace {
    /// The environment's: it stands inside the hold.
    Environment,
    /// The servo's: it stands around the hold.
    Servo,
}

/// The keys of a table, by its description.
pub(super) type Keys = &'static [Key];
