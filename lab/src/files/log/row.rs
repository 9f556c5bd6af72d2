//! Row of a log, good or bad.

use super::bad::{Bad, LARGEST, Reason};
use super::columns::Role;
use super::fields::bare;
use super::layout::Layout;
use super::notation::{Fault, Mark, Notation};
use super::sample::Sample;
use super::stamp::Stamp;

/// A row, good or bad.
#[derive(Debug, PartialEq)]
pub(crate) enum Entry<'a> {
    Good(Sample),
    Bad(Bad<'a>),
}

/// Parser of lines into samples.
#[derive(Debug)]
pub(super) struct RowReader {
    layout: Layout,
    factors: [f64; 4],
    /// Powers of ten from the units of the headings.
    powers: [i32; 4],
    notation: Notation,
    has_velocity: bool,
    /// Time of the first good row, s, and its stamp.
    first: Option<(f64, Option<Stamp>)>,
}

impl RowReader {
    /// Parser of the rows of `layout`, with a factor and the power of ten of its unit for each role.
    pub(super) fn new(
        layout: Layout,
        factors: [f64; 4],
        powers: [i32; 4],
        has_velocity: bool,
    ) -> Self {
        let notation = Notation::of(layout.delimiter);
        Self { layout, factors, powers, notation, has_velocity, first: None }
    }

    /// The decimal mark of the numbers so far, once it is settled.
    pub(super) fn mark(&self) -> Option<Mark> {
        self.notation.mark()
    }

    /// The row in the text of a line.
    pub(super) fn read<'a>(&mut self, text: &'a [u8], line: u64) -> Entry<'a> {
        let fields = match self.layout.pick(text) {
            Ok(fields) => fields,
            Err(reason) => return Entry::Bad(Bad { line, reason, time: None, force: None }),
        };
        match self.sample(&fields, line) {
            Ok(sample) => Entry::Good(sample),
            Err(reason) => {
                let [time, force] = [Role::T, Role::F].map(|role| self.value(role, &fields).ok());
                Entry::Bad(Bad { line, reason, time, force })
            }
        }
    }

    fn sample<'a>(&mut self, fields: &[&'a [u8]; 4], line: u64) -> Result<Sample, Reason<'a>> {
        let [t, x, f] = [Role::T, Role::X, Role::F].map(|role| self.value(role, fields));
        let v = self.has_velocity.then(|| self.value(Role::V, fields)).transpose();
        let (t, x, f, v) = (t?, x?, f?, v?);
        Ok(Sample { line, t, since: self.since(t, fields[Role::T.index()]), x, f, commanded: f, v })
    }

    /// The time from the first good row to the row at `time`, whose stamp is in `field`.
    fn since(&mut self, time: f64, field: &[u8]) -> f64 {
        let at = Role::T.index();
        let stamp = || Stamp::of(bare(field), self.powers[at]);
        let (first, origin) = *self.first.get_or_insert_with(|| (time, stamp()));
        if first == 0.0 {
            return time;
        }
        let exact = origin.and_then(|origin| stamp()?.since(origin));
        exact.map_or(time - first, |exact| exact * self.factors[at])
    }

    /// The value of a column in SI units.
    fn value<'a>(&mut self, role: Role, fields: &[&'a [u8]; 4]) -> Result<f64, Reason<'a>> {
        let field = fields[role.index()];
        let number = self.notation.read(field, self.powers[role.index()]);
        let number = number.map_err(|fault| match fault {
            Fault::NoNumber => Reason::Number { role, field },
            Fault::OtherMark(known) => Reason::Mark { role, field, known },
        })?;
        let value = number * self.factors[role.index()];
        if value.abs() <= LARGEST { Ok(value) } else { Err(Reason::Range { role, field }) }
    }
}
