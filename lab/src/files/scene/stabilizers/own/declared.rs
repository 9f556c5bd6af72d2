//! An own stabilizer as the lab keeps it.

use std::any::{Any, TypeId};
use std::fmt;

use super::super::Pledge;
use super::{Loop, OwnNumber, Promise};
use crate::files::scene::book::{Key, key};

/// Maker of an own stabilizer on a loop in the signal with that id: a result of the layer above, or none for a signal
/// that no loop has.
pub(crate) type Make = fn(TypeId, &Loop<'_>) -> Option<Box<dyn Any>>;

/// An own stabilizer: its name, its numbers, its promise, and the way to make one.
pub(crate) struct Declared {
    pub(super) name: &'static str,
    pub(super) numbers: Vec<OwnNumber>,
    /// The keys of its table: the table itself, then one for each number.
    pub(super) keys: Vec<Key>,
    /// The names of its numbers.
    pub(super) names: Vec<&'static str>,
    pub(super) promise: Promise,
    /// Whether its observed energy can be recomputed from the port's work.
    pub(super) books_work: bool,
    pub(super) make: Make,
}

impl Declared {
    /// A stabilizer that books the port's work, and nothing else.
    pub(crate) fn stabilizer(
        name: &'static str,
        numbers: &[OwnNumber],
        promise: Promise,
        make: Make,
    ) -> Self {
        // Entered once for the life of the program.
        let leaked = |text: String| -> &'static str { Box::leak(text.into_boxed_str()) };
        let path = |number: &OwnNumber| leaked(format!("stabilizer.{name}.{}", number.key));
        let line = |number: &OwnNumber| {
            let unit = if number.unit.is_empty() { "" } else { "  # " };
            format!("{} = {}{unit}{}", number.key, number.allowed.example(), number.unit)
        };
        let header = format!("[stabilizer.{name}]");
        let shown =
            numbers.first().map_or_else(|| header.clone(), |it| format!("{header}\n{}", line(it)));
        let table = key(leaked(format!("stabilizer.{name}")), "", leaked(shown));
        let of_number = |number: &OwnNumber| key(path(number), number.unit, leaked(line(number)));
        Self {
            name,
            numbers: numbers.to_vec(),
            keys: std::iter::once(table).chain(numbers.iter().map(of_number)).collect(),
            names: numbers.iter().map(|number| number.key).collect(),
            promise,
            books_work: true,
            make,
        }
    }

    /// LOLC with an own candidate, `lolc-NAME`, whose credits nobody can recompute.
    pub(crate) fn candidate(
        name: &'static str,
        numbers: &[OwnNumber],
        promise: Promise,
        make: Make,
    ) -> Self {
        let name = Box::leak(format!("lolc-{name}").into_boxed_str());
        let numbers = [&[OwnNumber::DAMPING_CAP], numbers].concat();
        Self { books_work: false, ..Self::stabilizer(name, &numbers, promise, make) }
    }

    /// The name.
    pub(crate) fn name(&self) -> &'static str {
        self.name
    }

    /// The maker.
    pub(crate) fn make(&self) -> Make {
        self.make
    }

    /// The promise beyond what every stabilizer owes.
    pub(super) fn pledge(&self) -> Pledge {
        let pledge = self.promise.pledge();
        if self.books_work {
            return pledge;
        }
        Pledge { account: super::super::LedgerKind::None, ..pledge }
    }
}

impl PartialEq for Declared {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Declared {}

impl fmt::Debug for Declared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Declared").field(&self.name).finish()
    }
}
